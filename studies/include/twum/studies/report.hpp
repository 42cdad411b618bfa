// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// The page that shows a result: one self-contained HTML file that needs no network. Depends on the arguments only.
/// Thread-safe.
/// @param study    the study that was run
/// @param text     text of the study as it was run, shown unchanged
/// @param result   its answer
/// @param store    its evaluations; of more than 100,000 the page shows a random sample, always the same one, and
///                 says so
std::string report_html(const StudyFile& study, const std::string& text, const StudyResult& result,
                        const ResultStore& store);

/// The page of a run in memory.
/// @throws InputError if the result has no rows
std::string report_html(const StudyFile& study, const StudyResult& result);

/// Writes report.html of a result directory again from its study and its stored evaluations.
/// @return the path of the page
/// @throws InputError if the directory holds no result, or one of an interrupted study; StoreError if the
///         result is damaged or the page cannot be written; Interrupted after a stop request
std::string write_report(const std::string& directory, const std::stop_token& stop = {});

/// The answer of a result directory as Markdown.
/// @throws as write_report()
std::string report_markdown(const std::string& directory, const std::stop_token& stop = {});

}  // namespace twum::inline v0_1::studies
