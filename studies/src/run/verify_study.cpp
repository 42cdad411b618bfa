// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/verify_study.hpp>

#include "results/stored_summary.hpp"
#include "run/verify_checks.hpp"
#include "stored/result_of.hpp"
#include "stored/stored_study.hpp"

namespace twum::inline v0_1::studies {

Verification verify_study(const std::string& directory, const VerifyOptions& options) {
  StoredStudy stored(directory, options.stop);
  const StudyFile& file = stored.file();
  StudyKindRun& kind = stored.kind();
  ResultStore& store = stored.store();
  const ResultFolder& folder = stored.folder();
  const auto& summary = stored.summary();
  Verification found;
  found.study = stored.name();
  found.kind = to_string(file.kind());
  verify_rows(kind, store, options, found);
  const std::string path = folder.file(ResultFolder::kSummary);
  from_summary(path, [&] { verify_designs(file, kind, summary, options.stop, found); });
  from_summary(path, [&] { verify_study_hash(file, summary, found); });
  if (stored.interrupted()) {
    verify_interrupted(store, summary, found);
    return found;
  }
  const FailureCount failures = verify_table(kind, store, folder.file(ResultFolder::kTable), found);
  if (file.kind() == StudyKind::motion)
    verify_table(kind, store, folder.file(ResultFolder::kMotion), found);
  StudyResult result = result_of(file, kind, store, from_summary(path, [&] {
                                   return verify_answer(kind, store, summary, options.stop, found);
                                 }));
  result.study = found.study;
  set_failures(result, failures);
  from_summary(path, [&] { verify_record(result, summary, found); });
  verify_motor_files(file, result, directory, found);
  return found;
}

}  // namespace twum::inline v0_1::studies
