// SPDX-License-Identifier: Apache-2.0
#include "stored/stored_study.hpp"

#include "entries/resolved_study.hpp"
#include "kinds/rows/executor.hpp"
#include "results/stored_summary.hpp"
#include "store/written_content.hpp"
#include "stored/result_of.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/studies/stored_result.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

namespace fs = std::filesystem;

const std::string& required_result(const std::string& directory) {
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored))
    throw InputError(directory + ": no such directory; give one that 'twum run' wrote");
  if (!fs::exists(fs::path(directory) / ResultFolder::kStudy, ignored)) {
    throw InputError(directory + ": not a result directory: it has no " +
                     std::string(ResultFolder::kStudy) +
                     "; give a directory that 'twum run' wrote");
  }
  for (const std::string_view name : {ResultFolder::kSummary, ResultFolder::kDatabase}) {
    if (!fs::exists(fs::path(directory) / name, ignored)) {
      throw InputError(directory + ": holds no complete result: there is no " + std::string(name) +
                       "; complete the study with 'twum run STUDY -o " + directory + "'");
    }
  }
  return directory;
}

// The study as it was run. An error in it means damage, not a mistake of the user.
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
    throw StoreError(std::string("the stored study cannot be evaluated again: ") + error.what());
  }
}

// In pieces, so that a stop request need not wait for a large file.
void copy_file(const fs::path& from, const fs::path& to, const std::stop_token& stop) {
  std::ifstream source(from, std::ios::binary);
  std::ofstream copy(to, std::ios::binary);
  std::vector<char> piece(std::size_t{4} << 20U);
  while (source.read(piece.data(), static_cast<std::streamsize>(piece.size())) ||
         source.gcount() > 0) {
    if (stop.stop_requested()) throw Interrupted();
    copy.write(piece.data(), source.gcount());
  }
  copy.close();
  if (source.bad() || !source.eof() || !copy)
    throw StoreError(from.string() + ": cannot be copied to " + to.string() + ": " +
                     std::strerror(errno) + "; set TMPDIR to a folder with room");
}

// Copies the database with its log, which a killed run may have left, so that nothing changes in the directory.
std::string copy_database(const std::string& directory, const std::string& to,
                          const std::stop_token& stop) {
  for (const std::string suffix : {"", "-wal"}) {
    const std::string name = std::string(ResultFolder::kDatabase) + suffix;
    if (fs::exists(fs::path(directory) / name))
      copy_file(fs::path(directory) / name, fs::path(to) / name, stop);
  }
  return (fs::path(to) / ResultFolder::kDatabase).string();
}

std::vector<ResolvedStudy::NamedFile> resolved_files(const StudyFile& file) {
  try {
    return resolve(file).files;
  } catch (const InputError& error) {
    throw StoreError(std::string("the stored study cannot be evaluated again: ") + error.what());
  }
}

// The files beside the motor that the study was run with: the same names have to hold the same content, because the stored
// numbers belong to it.
std::vector<std::string> changed_files(const StudyFile& file, const ResultStore& store) {
  const std::string stored = store.fact(facts::kFiles);
  std::vector<std::string> changed;
  for (const ResolvedStudy::NamedFile& named : resolved_files(file))
    if (!has_line(stored, named.entry + " " + named.hash)) changed.push_back(named.source());
  return changed;
}

void refuse_changed_files(const StudyFile& file, const std::string& directory,
                          const ResultStore& store) {
  std::string text;
  for (const std::string& path : changed_files(file, store))
    text += path + ": has changed since the study in " + directory + " was run with it\n";
  if (text.empty()) return;
  throw InputError(text + "restore what it was, or run the study again into another directory");
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::error_code error;
  path_ = (fs::temp_directory_path(error) / "twum-result-XXXXXX").string();
  if (error || ::mkdtemp(path_.data()) == nullptr) {
    throw StoreError(
        "cannot create a directory for a copy of the results among the temporary files: " +
        (error ? error.message() : path_ + ": " + std::strerror(errno)) +
        "; set TMPDIR to another one");
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

StoredStudy::StoredStudy(const std::string& directory, const std::stop_token& stop)
    : folder_(required_result(directory)),
      summary_(stored_summary(folder_.file(ResultFolder::kSummary))),
      file_(read_stored_study(folder_.file(ResultFolder::kStudy))),
      stop_(stop),
      store_(copy_database(directory, scratch_.path(), stop), stop) {
  refuse_changed_files(file_, directory, store_);
  kind_ = make_stored_kind(file_);
  store_.require(kind_->columns());
}

std::string StoredStudy::text() const {
  return written_content(folder_.file(ResultFolder::kStudy));
}

StudyResult StoredStudy::answer() {
  if (interrupted()) {
    throw InputError(folder_.file(ResultFolder::kSummary) +
                     ": the study was interrupted; run it again to complete its result");
  }
  const std::uint64_t rows = store_.rows();
  ThreadExecutor executor(*kind_);
  RunContext context{store_, executor, stop_, {}};
  StudyResult result = result_of(file_, *kind_, store_, kind_->run(context));
  if (stop_.stop_requested()) throw Interrupted();
  store_.flush();
  if (store_.rows() != rows) {
    throw StoreError(folder_.file(ResultFolder::kDatabase) + ": " +
                     std::to_string(store_.rows() - rows) +
                     " rows of the study are missing; run the study again");
  }
  result.study = name();
  result.hash = store_.fact(facts::kHash);
  result.started = store_.fact(facts::kStarted);
  result.seconds = parse_number(store_.fact(facts::kSeconds)).value_or(0);
  set_failures(result, failures_of(*kind_, store_));
  return result;
}

void read_result(
    const std::string& directory,
    const std::function<void(const StudyFile&, const StudyResult&, const ResultStore&)>& use,
    const std::stop_token& stop) {
  StoredStudy stored(directory, stop);
  const StudyResult result = stored.answer();
  use(stored.file(), result, stored.store());
}

}  // namespace twum::inline v0_1::studies
