// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <functional>
#include <stop_token>
#include <string>

namespace twum::inline v0_1::studies {

/// Reads a finished study from its directory: the question, the answer derived again from the stored evaluations, and
/// the evaluations. Changes nothing in the directory. Takes the time of the study without its evaluations:
/// milliseconds; under tolerances seconds.
/// @param use  called with these; they are valid during the call only
/// @throws InputError if the directory holds no result, or one of an interrupted study; StoreError if the result is damaged;
/// Interrupted after a stop request
void read_result(
    const std::string& directory,
    const std::function<void(const StudyFile&, const StudyResult&, const ResultStore&)>& use,
    const std::stop_token& stop = {});

}  // namespace twum::inline v0_1::studies
