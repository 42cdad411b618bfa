// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <twum/io/words.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace twum::inline v0_1::cli {

Output::Output(std::string path, const std::vector<std::string>& inputs)
    : path_(path == "-" ? "" : std::move(path)) {
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (!path_.empty() && std::filesystem::is_regular_file(path_, ignored) &&
        std::filesystem::equivalent(path_, input, ignored)) {
      throw InputError(
          path_ +
          ": is an input of this command and would be overwritten; choose another name after -o");
    }
  }
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void Output::open() {
  file_ = path_.empty() ? stdout : std::fopen(path_.c_str(), "wb");
  if (file_ == nullptr) fail();
}

void Output::write(std::string_view text) {
  if (file_ == nullptr) open();
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void Output::say(std::string_view text) { write(studies::printable_lines(text)); }

void Output::finish() {
  if (file_ == nullptr) open();
  if (std::fflush(file_) != 0) fail();
  if (file_ == stdout) return;
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail();
}

void Output::fail() {
  const int reason = errno;
  if (reason == EPIPE) throw ClosedPipe();
  throw OutputError((path_.empty() ? "standard output" : path_) +
                    ": cannot be written: " + std::strerror(reason));
}

}  // namespace twum::inline v0_1::cli
