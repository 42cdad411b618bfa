// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/study_kind.hpp"
#include "results/row_pass.hpp"

#include <twum/studies/run/run_options.hpp>
#include <twum/studies/store/result_store.hpp>

#include <string>

namespace twum::studies {

/// Makes the page of a result; report_html() is one.
using PageOf = std::string (*)(const StudyFile& study, const std::string& text,
                               const StudyResult& result, const ResultStore& store);

/// run_study() in a directory. `page` makes the report, which is code of a higher layer.
StudyResult keep_study(const StudyFile& file, const std::string& directory,
                       const RunOptions& options, PageOf page);

/// The result for an answer: counts, notes and failures of its rows, without name, hash and times.
StudyResult result_of(const StudyFile& file, const StudyKindRun& kind, const ResultStore& store,
                      KindAnswer answer);
void set_failures(StudyResult& result, const FailureCount& failures);
FailureCount failures_of(const StudyKindRun& kind, const ResultStore& store);

/// Names of the facts that a database keeps beside the rows.
namespace facts {
inline constexpr const char* kHash = "hash";
inline constexpr const char* kVersion = "version";
inline constexpr const char* kStudyText = "study";
inline constexpr const char* kFiles = "files";
inline constexpr const char* kStarted = "started";
inline constexpr const char* kSeconds = "seconds";
inline constexpr const char* kComplete = "complete";
}  // namespace facts

}  // namespace twum::studies
