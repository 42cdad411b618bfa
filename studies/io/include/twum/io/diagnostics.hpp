// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>
#include <twum/base/namespaces.hpp>
#include <twum/io/source.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::io {

/// One thing that is wrong in a file: where, which entry, what was found, what would be right.
struct Diagnostic {
  SourceMark mark;                  ///< where
  std::string entry;                ///< path such as "motor.contact_layer.thickness"; may be empty
  std::string found;                ///< "'3 N' is a force [N]"
  std::string expected;             ///< "expected a length [m] such as '0.3 mm'"
  std::optional<SourceMark> other;  ///< a second place that the error refers to
  std::string other_text;           ///< what is there, such as "first given here"
};

/// "file:line:column: entry: found; expected", the source line with a caret, and the second place.
std::string to_string(const Diagnostic& diagnostic, const Source& source);

/// Everything that is wrong with one file. what() is the text of all of it.
class FileError : public InputError {
 public:
  /// The errors of a file, in the order in which they are printed.
  FileError(const Source& source, std::vector<Diagnostic> diagnostics);
  /// The errors of a file and of another file that it names; the text holds both.
  FileError(const FileError& first, const FileError& second);

  /// Errors of the first file.
  const std::vector<Diagnostic>& diagnostics() const noexcept { return *diagnostics_; }

 private:
  std::shared_ptr<const std::vector<Diagnostic>> diagnostics_;  // shared: exceptions are copied
};

/// Collects the errors of one file, so that all of them are reported at once.
class Diagnostics {
 public:
  /// Collects errors of this text, which has to outlive the object.
  explicit Diagnostics(const Source& source) : source_(source) {}

  /// The text.
  const Source& source() const noexcept { return source_; }
  /// Adds an error.
  /// @{
  void add(Diagnostic diagnostic) { found_.push_back(std::move(diagnostic)); }
  void add(SourceMark mark, std::string entry, std::string found, std::string expected) {
    add({mark, std::move(entry), std::move(found), std::move(expected), {}, {}});
  }
  /// @}
  /// True if nothing is wrong so far.
  bool empty() const noexcept { return found_.empty(); }
  /// Errors so far.
  std::size_t count() const noexcept { return found_.size(); }
  /// @throws FileError with all errors in the order of the file, if there are any.
  void throw_if_any() const;

 private:
  const Source& source_;
  std::vector<Diagnostic> found_;
};

}  // namespace twum::inline v0_1::io
