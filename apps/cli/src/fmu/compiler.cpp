// SPDX-License-Identifier: Apache-2.0
#include "fmu/compiler.hpp"

#include "output.hpp"

#include <twum/io/words.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace twum::cli {
namespace {

namespace fs = std::filesystem;

// A folder of our own among the temporary files.
class ScratchFolder {
 public:
  ScratchFolder() : path_((fs::temp_directory_path() / "twum-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr)
      throw OutputError(std::string("a temporary folder for the compiler cannot be made: ") +
                        std::strerror(errno));
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Exit status of a program, its messages in a file; an errno below zero if it cannot be started.
int run(std::vector<std::string> words, const std::string& messages) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -error;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

Compiled compile_shared_library(const std::vector<SourceFile>& files) {
  const ScratchFolder folder;
  const std::string library = folder.file("unit.so"), messages = folder.file("messages");
  std::vector<std::string> words{
      "cc", "-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-s", "-o", library};
  for (const auto& [name, text] : files) {
    std::ofstream(folder.file(name), std::ios::binary) << text;
    if (name.ends_with(".c")) words.push_back(folder.file(name));
  }
  words.emplace_back("-lm");
  const int status = run(words, messages);
  if (status == -ENOENT) return {"", "no C compiler 'cc' was found (Debian package gcc)"};
  if (status < 0)
    return {"", std::string("the C compiler cannot be run: ") + std::strerror(-status)};
  if (status != 0)
    return {"", "the C compiler failed: " + studies::printable(contents(messages), 200)};
  return {contents(library), ""};
}

}  // namespace twum::cli
