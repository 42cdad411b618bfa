// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::cli {

/// A result could not be written.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// The reader of standard output has stopped reading, which is not an error.
class ClosedPipe : public Error {
 public:
  ClosedPipe() : Error("the reader closed the pipe") {}
};

/// Destination of a command's result: standard output, or a file that is created with the first write. Every failure
/// to write is detected, including a full disk.
class Output {
 public:
  /// @param path    empty or "-" for standard output
  /// @param inputs  files being read, which the result must not overwrite
  /// @throws InputError if the path is one of the inputs
  explicit Output(std::string path, const std::vector<std::string>& inputs = {});
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// @throws OutputError, ClosedPipe
  void write(std::string_view text);
  /// Writes words for a person: control characters, which names of files may contain, are shown as \xNN.
  void say(std::string_view text);
  /// Flushes and closes the destination; to be called once, at the end.
  void finish();

 private:
  void open();
  [[noreturn]] void fail();

  std::string path_;
  std::FILE* file_{nullptr};
};

}  // namespace twum::inline v0_1::cli
