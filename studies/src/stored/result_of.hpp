// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"
#include "results/row_pass.hpp"

#include <twum/io/result_store.hpp>

namespace twum::inline v0_1::studies {

/// The result for an answer: counts, notes and failures of its rows, without name, hash and times.
StudyResult result_of(const StudyFile& file, const StudyKindRun& kind, const ResultStore& store,
                      KindAnswer answer);
void set_failures(StudyResult& result, const FailureCount& failures);
FailureCount failures_of(const StudyKindRun& kind, const ResultStore& store);

/// Whether a text of lines has this one.
bool has_line(const std::string& text, const std::string& line);

/// Names of the facts that a database keeps beside the rows.
namespace facts {
inline constexpr const char* kHash = "hash";
inline constexpr const char* kVersion = "version";
inline constexpr const char* kStudyText = "study";
inline constexpr const char* kFiles = "files";
inline constexpr const char* kCopies = "copies";  // of files, one on each line
inline constexpr const char* kStarted = "started";
inline constexpr const char* kSeconds = "seconds";
inline constexpr const char* kComplete = "complete";
}  // namespace facts

}  // namespace twum::inline v0_1::studies
