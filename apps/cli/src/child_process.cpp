// SPDX-License-Identifier: Apache-2.0
#include "child_process.hpp"

#include "output.hpp"

#include <twum/io/words.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace twum::inline v0_1::cli {
namespace {

int wait_for(pid_t child, const std::string& name) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw OutputError(name + " was lost: " + std::strerror(errno));
  }
  return status;
}

}  // namespace

File scratch_file() {
  File file(std::tmpfile());
  if (file == nullptr)
    throw OutputError(std::string("a temporary file cannot be made: ") + std::strerror(errno));
  return file;
}

std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 1 << 16> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file))
    text.append(buffer.data(), n);
  return text;
}

std::string first_words(const std::string& text) {
  std::string line;
  for (std::size_t begin = 0; begin < text.size() && line.empty();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    line = studies::trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return studies::printable(line, 200);
}

FileActions::FileActions() { posix_spawn_file_actions_init(&actions_); }
FileActions::~FileActions() { posix_spawn_file_actions_destroy(&actions_); }

std::optional<pid_t> started_program(std::vector<std::string> words, const FileActions& files) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], files.get(), nullptr, arguments.data(), environ);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw OutputError(words.front() + " cannot be run: " + std::strerror(error));
  return child;
}

ChildEnd run_program(const std::vector<std::string>& words, std::FILE* in, std::FILE* out,
                     std::FILE* errors) {
  FileActions files;
  const std::array streams{in, out, errors};
  for (int i = 0; i < 3; ++i) {
    if (streams[i] != nullptr) posix_spawn_file_actions_adddup2(files.get(), fileno(streams[i]), i);
  }
  const std::optional<pid_t> child = started_program(words, files);
  if (!child) return {false, 0};
  return {true, wait_for(*child, words.front())};
}

}  // namespace twum::inline v0_1::cli
