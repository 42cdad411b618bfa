// SPDX-License-Identifier: Apache-2.0
#include "running_program.hpp"

#include "output.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace twum::cli {

std::optional<RunningProgram> RunningProgram::start(std::vector<std::string> words,
                                                    const std::string& folder,
                                                    const std::string& log) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw OutputError(words.front() + " cannot be run: " + std::strerror(error));
  return RunningProgram(child);
}

RunningProgram::RunningProgram(RunningProgram&& other) noexcept
    : child_(std::exchange(other.child_, 0)), status_(other.status_) {}

RunningProgram& RunningProgram::operator=(RunningProgram&& other) noexcept {
  std::swap(child_, other.child_);
  std::swap(status_, other.status_);
  return *this;
}

RunningProgram::~RunningProgram() {
  if (child_ == 0 || status_) return;
  ::kill(child_, SIGKILL);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
}

bool RunningProgram::ended() {
  if (status_) return true;
  int status = 0;
  const pid_t found = waitpid(child_, &status, WNOHANG);
  if (found == child_) status_ = status;
  if (found < 0 && errno != EINTR) status_ = -1;  // lost
  return status_.has_value();
}

}  // namespace twum::cli
