// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>
#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <string>

namespace twum::inline v0_1::io {

/// A wrong text. What was found and what would be right are kept separately, so that a reader of files can add the
/// place, and the command line the option.
class ValueError : public InputError {
 public:
  /// @param found     what stands there
  /// @param expected  what would be right
  /// @param position  position of the error in the text, in bytes from its start
  ValueError(std::string found, std::string expected, std::size_t position = 0)
      : InputError(found + "; " + expected),
        found_(std::move(found)),
        expected_(std::move(expected)),
        position_(position) {}

  /// What stands there, such as "'3 N' is a force [N]".
  const std::string& found() const noexcept { return found_; }
  /// What would be right, such as "expected a length [m] such as '0.3 mm'".
  const std::string& expected() const noexcept { return expected_; }
  /// Position of the error in the text, in bytes from its start.
  std::size_t position() const noexcept { return position_; }

 private:
  std::string found_;
  std::string expected_;
  std::size_t position_;
};

}  // namespace twum::inline v0_1::io
