// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/schema/schema.hpp>
#include <twum/studies/yaml/node.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twum::studies {

/// What a study asks.
enum class StudyKind : unsigned char {
  curve,
  sweep,
  sensitivity,
  optimize,
  pareto,
  size,
  uncertainty,
  calibrate
};

/// Names as in `kind:`, in the order of StudyKind.
std::span<const std::string_view> study_kinds();
std::optional<StudyKind> find_study_kind(std::string_view name);
std::string_view to_string(StudyKind kind);

/// Shape of what stands below `study:` for one kind.
Schema study_schema(StudyKind kind);

/// Shape of a study file.
const Schema& study_file_schema();

/// A study file that is known to be right: its motor, and its entries as they stand there.
struct StudyFile {
  StudyKind kind;
  MotorFile motor;     ///< with `set:` and the settings of the command line applied
  YamlNode study;      ///< what stands below `study:`, valid by study_schema(kind)
  std::string folder;  ///< where paths in the file start
  std::string path{};  ///< of the file itself; "-" is standard input
};

/// Reads a study file and its motor; "-" is standard input.
/// @param settings  "NAME=VALUE" overrides, applied after those of the file
/// @throws FileError with everything that is wrong in it, and in its motor file;
///         InputError if it cannot be read or a setting is wrong.
StudyFile read_study_file(const std::string& path, std::span<const std::string> settings = {});
/// The same of a text; paths in it start in `folder`.
StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings = {});

/// True if a document is a study file (it has `study:`) rather than a motor file.
bool is_study(const Source& source);

/// The reference page of study files: every kind and entry, as Markdown.
std::string study_reference();

/// A commented study file of one kind to start from.
std::string study_template(StudyKind kind);

}  // namespace twum::studies
