// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"
#include "stored/result_folder.hpp"

#include <twum/io/result_store.hpp>
#include <twum/studies/study_file.hpp>

#include <nlohmann/json.hpp>

#include <memory>
#include <stop_token>
#include <string>

namespace twum::inline v0_1::studies {

/// A folder for temporary files, removed at the end.
class ScratchFolder {
 public:
  /// @throws StoreError if it cannot be made
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
};

/// The result of a study, read from its directory, which must not change meanwhile. Rows are read from a copy of the
/// database, so nothing changes in the directory.
class StoredStudy {
 public:
  /// @throws InputError if the directory holds no result; StoreError if the result is damaged
  /// @throws InputError also if a file that the study names has changed since; Interrupted after a stop request
  explicit StoredStudy(const std::string& directory, const std::stop_token& stop = {});

  ResultFolder& folder() { return folder_; }
  const StudyFile& file() const { return file_; }
  StudyKindRun& kind() { return *kind_; }
  ResultStore& store() { return store_; }
  const nlohmann::ordered_json& summary() const { return summary_; }
  std::string name() const { return summary_.value("study", ""); }
  bool interrupted() const {
    return summary_.value("outcome", "") == to_string(StudyOutcome::interrupted);
  }
  std::string text() const;  ///< content of study.yaml

  /// The answer that the study kind derives from the stored rows.
  /// @throws InputError if the study was interrupted; StoreError if rows are missing
  StudyResult answer();

 private:
  ResultFolder folder_;
  nlohmann::ordered_json summary_;
  StudyFile file_;
  std::stop_token stop_;
  ScratchFolder scratch_;
  ResultStore store_;
  std::unique_ptr<StudyKindRun> kind_;
};

}  // namespace twum::inline v0_1::studies
