// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/run/verify_study.hpp>

#include "results/stored_summary.hpp"
#include "run/kept_study.hpp"
#include "run/result_folder.hpp"
#include "run/verify_checks.hpp"

#include <twum/base/error.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace twum::studies {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A folder of its own that goes when it is no longer needed.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    path_ = (fs::temp_directory_path(error) / "twum-verify-XXXXXX").string();
    if (error || ::mkdtemp(path_.data()) == nullptr) {
      throw StoreError(
          "no folder for a copy of the results can be made in that for temporary files: " +
          (error ? error.message() : path_ + ": " + std::strerror(errno)) +
          "; set TMPDIR to another one");
    }
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
};

void require_result(const std::string& directory) {
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored))
    throw InputError(directory + ": no such directory; expected one that 'twum run' wrote");
  for (const std::string_view name :
       {ResultFolder::kStudy, ResultFolder::kSummary, ResultFolder::kDatabase}) {
    if (!fs::exists(fs::path(directory) / name, ignored)) {
      throw InputError(directory + ": holds no complete result: there is no " + std::string(name));
    }
  }
}

// The study as it was run; that it is wrong is damage, not a user's mistake.
StudyFile read_stored_study(const std::string& path) {
  try {
    return read_study_file(path);
  } catch (const InputError& error) {
    throw StoreError(std::string("the stored study is damaged: ") + error.what());
  }
}

std::unique_ptr<StudyKindRun> make_stored_kind(const StudyFile& file) {
  try {
    return make_kind(file);
  } catch (const InputError& error) {
    throw StoreError(std::string("the stored study cannot be repeated: ") + error.what());
  }
}

// A copy, with what a killed run left in its log, so that nothing is changed where it lies.
std::string copy_database(const std::string& directory, const std::string& to) {
  for (const std::string suffix : {"", "-wal"}) {
    const std::string name = std::string(ResultFolder::kDatabase) + suffix;
    if (!fs::exists(fs::path(directory) / name)) continue;
    fs::copy_file(fs::path(directory) / name, fs::path(to) / name);
  }
  return (fs::path(to) / ResultFolder::kDatabase).string();
}

}  // namespace

Verification verify_study(const std::string& directory, const VerifyOptions& options) {
  require_result(directory);
  const ResultFolder folder(directory);  // nobody may write to it meanwhile
  const Json summary = stored_summary(folder.file(ResultFolder::kSummary));
  const StudyFile file = read_stored_study(folder.file(ResultFolder::kStudy));
  const std::unique_ptr<StudyKindRun> kind = make_stored_kind(file);
  Verification found;
  found.study = summary.value("study", "");
  found.kind = to_string(file.kind());
  const ScratchFolder scratch;
  ResultStore store(copy_database(directory, scratch.path()), kind->columns());
  verify_rows(*kind, store, options, found);
  verify_designs(file, *kind, summary, found);
  verify_study_hash(file, summary, found);
  if (summary.value("outcome", "") == "interrupted") {
    verify_interrupted(store, summary, found);
    return found;
  }
  const FailureCount failures =
      verify_table(store, kind->variables(), folder.file(ResultFolder::kTable), found);
  StudyResult result = result_of(file, *kind, store, verify_answer(*kind, store, summary, found));
  result.study = found.study;
  set_failures(result, failures);
  verify_record(result, summary, found);
  verify_motor_files(file, result, directory, found);
  return found;
}

}  // namespace twum::studies
