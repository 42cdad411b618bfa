// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/schema/schema.hpp>
#include <twum/studies/study/study.hpp>
#include <twum/studies/yaml/node.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twum::studies {

/// Shape of what stands below `study:` for one kind.
Schema study_schema(StudyKind kind);

/// Shape of a study file; static lifetime.
const Schema& study_file_schema();

/// A study with its motor: what a file says once it is known to be right, or what a program asks.
struct StudyFile {
  MotorFile motor;       ///< with `set:` and the settings of the command line applied
  Study asked;           ///< what is asked, in SI
  YamlNode study{};      ///< what stands below `study:`, as typed; empty if no file was read
  std::string folder{};  ///< where paths start
  std::string path{};    ///< of the file itself; "-" is standard input

  /// What kind of study it is.
  StudyKind kind() const { return kind_of(asked); }
};

/// Reads a study file and its motor; "-" is standard input.
/// @param settings  "NAME=VALUE" overrides, applied after those of the file
/// @throws FileError with everything that is wrong in it, and in its motor file;
///         InputError if it cannot be read or a setting is wrong.
StudyFile read_study_file(const std::string& path, std::span<const std::string> settings = {});
/// The same of a text; paths in it start in `folder`.
/// @throws FileError and InputError likewise.
StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings = {});

/// True if a document is a study file (it has `study:`) rather than a motor file.
bool is_study(const Source& source);

/// The reference page of study files: every kind and entry, as Markdown.
std::string study_reference();

/// A commented study file of one kind to start from; valid wherever it lies, but that `calibrate` needs
/// its points.
/// @param motor  path of a motor file for it to name; empty: a motor stands in the study itself
std::string study_template(StudyKind kind, std::string_view motor = {});

}  // namespace twum::studies
