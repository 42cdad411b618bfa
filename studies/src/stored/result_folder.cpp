// SPDX-License-Identifier: Apache-2.0
#include "stored/result_folder.hpp"

#include "stored/result_of.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace twum::inline v0_1::studies {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPart = ".part";
constexpr std::string_view kInputs = "inputs/";
constexpr std::array<std::string_view, 8> kResults{"study.yaml",   "results.csv", "motion.csv",
                                                   "summary.json", "report.html", "best.yaml",
                                                   "fitted.yaml",  "results.db"};
// Folders of numbered motor files, such as 01.yaml: points of a front, motors that fit equally well, fitted motors
// of several tables.
constexpr std::array<std::string_view, 3> kNumbered{"front", "optima", "fitted"};

[[noreturn]] void fail(const std::string& path, const std::string& what, int reason) {
  throw StoreError(path + ": " + what + ": " + std::strerror(reason));
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// A new file in the place of what a killed run has left. A link there is not followed: it could lead to any file of the user.
std::unique_ptr<std::FILE, CloseFile> new_file(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return nullptr;
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  return std::unique_ptr<std::FILE, CloseFile>(descriptor < 0 ? nullptr
                                                              : ::fdopen(descriptor, "wb"));
}

// Whether a file has the header of an SQLite file of this program. An empty file counts as well: its creation was
// interrupted.
bool is_our_database(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 72> head{};
  file.read(head.data(), head.size());
  if (file.gcount() == 0) return true;
  return file && std::string_view(head.data(), 15) == "SQLite format 3" &&
         std::string_view(head.data() + 68, 4) == "twum";
}

}  // namespace

ResultFolder::ResultFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) fail(path_, "cannot be created as a directory", error.value());
  if (!fs::is_directory(path_, error)) fail(path_, "cannot be used", ENOTDIR);
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) fail(path_, "cannot be opened", errno);
  // On a file system without locks, the lock of the database has to be sufficient.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    throw StoreError(path_ +
                     ": another twum process is using this directory; wait for it or end it, "
                     "or choose another directory with -o");
  }
}

ResultFolder::~ResultFolder() { ::close(lock_); }

std::string ResultFolder::file(std::string_view name) const {
  return (fs::path(path_) / name).string();
}

bool ResultFolder::has(std::string_view name) const {
  std::error_code ignored;
  return fs::exists(file(name), ignored);
}

namespace {

[[noreturn]] void refuse_foreign(const std::string& path, const std::string& remark) {
  throw InputError(path + ": exists already and is not a result of twum" + remark +
                   "; choose another directory with -o, or remove it yourself");
}

// "07.yaml", or its temporary file
bool is_numbered_motor(const fs::path& path) {
  std::string name = path.filename().string();
  if (name.ends_with(kPart)) name.resize(name.size() - kPart.size());
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits > 0 && name.substr(std::min(digits, name.size())) == ".yaml";
}

// Nothing if the database is damaged: copies that it lists then stay, and are written again.
std::string listed_copies(const std::string& database) {
  std::error_code ignored;
  if (!fs::exists(database, ignored)) return {};
  try {
    return ResultStore(database).fact(facts::kCopies);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

void ResultFolder::discard_numbered() const {
  for (const std::string_view name : kNumbered) {
    std::error_code error;
    const fs::path folder = file(name);
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (!is_numbered_motor(entry.path())) continue;
      fs::remove(entry.path(), error);
      if (error) fail(entry.path().string(), "cannot be removed", error.value());
    }
    fs::remove(folder, error);  // the folder stays if other files are in it
  }
}

void ResultFolder::check_ours() const {
  std::error_code error;
  for (const std::string_view name : kNumbered)
    if (has(name) && !fs::is_directory(fs::symlink_status(file(name), error)))
      refuse_foreign(file(name), "");
  if (has_database() && is_our_database(file(kDatabase))) return;
  if (has_database()) refuse_foreign(file(kDatabase), "");
  const std::string alone = " (there is no results.db with it)";
  for (const std::string_view name : kResults) {
    if (has(name)) refuse_foreign(file(name), alone);
  }
  for (const std::string_view name : kNumbered) {
    for (const auto& entry : fs::directory_iterator(file(name), error)) {
      if (is_numbered_motor(entry.path())) refuse_foreign(entry.path().string(), alone);
    }
  }
}

// Copies of the files of a study are those that its database lists; other files beside them stay.
void ResultFolder::discard_copies() const {
  std::error_code error;
  std::istringstream copies(listed_copies(file(kDatabase)));
  for (std::string name; std::getline(copies, name);) {
    if (!name.starts_with(kInputs) || name.find("..") != std::string::npos) continue;
    fs::remove(file(name), error);
    if (error) fail(file(name), "cannot be removed", error.value());
    fs::path folder = fs::path(name).parent_path();
    for (; !folder.empty(); folder = folder.parent_path()) fs::remove(file(folder.string()), error);
  }
}

void ResultFolder::discard() const {
  check_ours();
  discard_numbered();
  discard_copies();
  std::error_code error;
  // Removes the database last, because it marks the other files as results of twum.
  for (const std::string_view name : kResults) {
    for (const std::string_view suffix :
         {std::string_view("-wal"), std::string_view("-shm"), std::string_view("-journal"), kPart,
          std::string_view("")}) {
      const std::string path = file(std::string(name) + std::string(suffix));
      fs::remove(path, error);
      if (error) fail(path, "cannot be removed", error.value());
    }
  }
}

// The directory that is locked, by device and inode, is still the one at the path.
void ResultFolder::check_held() const {
  struct stat held {};
  struct stat there {};
  if (::fstat(lock_, &held) != 0) fail(path_, "cannot be read", errno);
  if (::stat(path_.c_str(), &there) == 0 && there.st_dev == held.st_dev &&
      there.st_ino == held.st_ino)
    return;
  throw StoreError(path_ +
                   ": was moved, replaced or removed while the study was running; the results are "
                   "not there. Run the study again");
}

void ResultFolder::check_in_place() const {
  check_held();
  for (const auto& [path, size] : written_) {
    std::error_code error;
    const std::uintmax_t found = fs::file_size(path, error);
    if (error) fail(path, "was written, but cannot be read back", error.value());
    if (found == size) continue;
    throw StoreError(path + ": was written, but has changed since: " + std::to_string(found) +
                     " bytes instead of " + std::to_string(size) + "; run the study again");
  }
}

void ResultFolder::check_not_emptied() const {
  std::error_code error;
  if (fs::file_size(file(kDatabase), error) != 0 || error || !has(kStudy)) return;
  throw StoreError(file(kDatabase) +
                   ": is empty, although a study was stored there; restore it from a copy, or run "
                   "the study again with --fresh");
}

void ResultFolder::write(
    std::string_view name,
    const std::function<void(const std::function<void(std::string_view)>&)>& fill) {
  check_held();
  const std::string place = file(name);
  std::error_code ignored;  // creating the file itself will then fail
  fs::create_directories(fs::path(place).parent_path(), ignored);
  const std::string part = place + std::string(kPart);
  std::unique_ptr<std::FILE, CloseFile> stream = new_file(part);
  if (!stream) fail(place, "cannot be written", errno);
  const auto check = [&](bool good) {
    const int reason = errno;
    if (good) return;
    std::remove(part.c_str());
    fail(place, "cannot be written", reason);
  };
  std::uintmax_t size = 0;
  fill([&](std::string_view piece) {
    check(std::fwrite(piece.data(), 1, piece.size(), stream.get()) == piece.size());
    size += piece.size();
  });
  check(std::fflush(stream.get()) == 0);
  check(std::fclose(stream.release()) == 0);
  check(std::rename(part.c_str(), place.c_str()) == 0);
  written_[place] = size;
}

void ResultFolder::write(std::string_view name, const std::string& content) {
  write(name, [&](const std::function<void(std::string_view)>& put) { put(content); });
}

}  // namespace twum::inline v0_1::studies
