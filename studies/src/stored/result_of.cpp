// SPDX-License-Identifier: Apache-2.0
#include "stored/result_of.hpp"

#include "kinds/sample/found_motors.hpp"
#include "stored/study_notes.hpp"

#include <utility>

namespace twum::inline v0_1::studies {

StudyResult result_of(const StudyFile& file, const StudyKindRun& kind, const ResultStore& store,
                      KindAnswer answer) {
  StudyResult result;
  result.kind = file.kind();
  result.motor = file.motor.name;
  result.design = kind.own_motor().value_or(file.motor.design);
  result.outcome = answer.outcome;
  result.evaluations = store.rows();
  result.seed = kind.seed();
  result.answer = std::move(answer.answer);
  result.model_notes = notes_of(file, kind);
  for (std::string& note : notes_on(file, result)) result.model_notes.push_back(std::move(note));
  return result;
}

void set_failures(StudyResult& result, const FailureCount& failures) {
  result.failure_regions = failures.regions();
  for (const FailureRegion& region : result.failure_regions)
    result.failures[region.reason] = region.count;
}

FailureCount failures_of(const StudyKindRun& kind, const ResultStore& store) {
  const std::vector<StoredColumn> columns = kind.columns();
  FailureCount failures(
      {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(kind.variables())});
  store.read([&](const StoredRow& row) { failures.see(row); });
  return failures;
}

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

}  // namespace twum::inline v0_1::studies
