// SPDX-License-Identifier: Apache-2.0
#include "running_program.hpp"

#include "child_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

namespace twum::inline v0_1::cli {

std::optional<RunningProgram> RunningProgram::start(const std::vector<std::string>& words,
                                                    const std::string& folder,
                                                    const std::string& log) {
  FileActions files;
  posix_spawn_file_actions_addchdir_np(files.get(), folder.c_str());
  posix_spawn_file_actions_addopen(files.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(files.get(), STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(files.get(), STDOUT_FILENO, STDERR_FILENO);
  const std::optional<pid_t> child = started_program(words, files);
  if (!child) return std::nullopt;
  return RunningProgram(*child);
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

}  // namespace twum::inline v0_1::cli
