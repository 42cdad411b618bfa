// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A program that runs beside this one, without a shell in between. It is killed with the object.
class RunningProgram {
 public:
  /// Starts it in a folder; what it prints goes into a file there.
  /// @param words  its name, and its arguments
  /// @return nothing if no program of that name is on the PATH
  /// @throws OutputError if it is there but cannot be run
  static std::optional<RunningProgram> start(const std::vector<std::string>& words,
                                             const std::string& folder, const std::string& log);

  RunningProgram(RunningProgram&& other) noexcept;
  RunningProgram& operator=(RunningProgram&& other) noexcept;
  ~RunningProgram();

  /// True once it has ended; does not wait.
  bool ended();
  /// Of a program that has ended: true if it said that all went well.
  bool succeeded() const { return status_ == 0; }

 private:
  explicit RunningProgram(pid_t child) : child_(child) {}

  pid_t child_;  // 0: none
  std::optional<int> status_{};
};

}  // namespace twum::inline v0_1::cli
