// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace twum::inline v0_1 {

/// Root of every exception that twum throws on purpose.
class Error : public std::runtime_error {
 public:
  /// The constructors of std::runtime_error, which take the text of what().
  using std::runtime_error::runtime_error;
};

/// The caller asked for something that cannot be: a value out of range, an unknown name.
/// The text names the entry, what was found, and what would be right.
class InputError : public Error {
 public:
  /// The constructors of Error.
  using Error::Error;
};

/// A valid design has no answer at the point asked for, for a reason of physics or numerics.
/// The text says which; optimizers and studies count it under `reason()`.
class EvaluationError : public Error {
 public:
  /// @param reason  short machine-readable word
  /// @param text    a sentence, what() of the exception
  EvaluationError(std::string reason, const std::string& text)
      : Error(text), reason_(std::move(reason)) {}

  /// Short machine-readable reason, such as "no-periodic-state".
  const std::string& reason() const noexcept { return reason_; }

 private:
  std::string reason_;
};

/// A mistake of this program: a condition that no input should break does not hold. The text asks for a report.
class BugError : public std::logic_error {
 public:
  /// The constructors of std::logic_error.
  using std::logic_error::logic_error;
};

namespace detail {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}  // namespace detail

}  // namespace twum::inline v0_1

/// Checks a condition that only a bug in twum can break. Active in all builds, so keep it out of hot loops.
#define TWUM_ASSERT(condition) \
  ((condition) ? void(0) : ::twum::detail::assertion_failed(#condition, __FILE__, __LINE__))
