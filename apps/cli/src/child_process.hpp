// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <spawn.h>
#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A file of the C library that closes itself.
struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// A nameless temporary file: nothing to clean up, and no pipe that could fill while the other end waits.
/// @throws OutputError if there is no room for it
File scratch_file();

/// All bytes of a file from its beginning.
std::string contents(std::FILE* file);

/// The first line with words in it, for a message.
std::string first_words(const std::string& text);

/// How a program ended.
struct ChildEnd {
  bool found;  ///< a program of that name is on the PATH
  int status;  ///< 0 if all went well
};

/// What becomes of a program's files and folder as it starts.
class FileActions {
 public:
  FileActions();
  ~FileActions();
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Starts a program, without a shell in between.
/// @param words  its name, and its arguments
/// @return nothing if no program of that name is on the PATH
/// @throws OutputError if it is there but cannot be run
std::optional<pid_t> started_program(std::vector<std::string> words, const FileActions& files);

/// Runs a program to its end, likewise.
/// @param in, out, errors  its standard streams; may be null for those of this program
ChildEnd run_program(const std::vector<std::string>& words, std::FILE* in, std::FILE* out,
                     std::FILE* errors);

}  // namespace twum::inline v0_1::cli
