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

/// Names as in `kind:`, in the order of StudyKind; the list lives for ever.
std::span<const std::string_view> study_kinds();

/// The kind of a name; nothing if there is none.
std::optional<StudyKind> find_study_kind(std::string_view name);

/// The name of a kind; lives for ever.
std::string_view to_string(StudyKind kind);

/// Shape of what stands below `study:` for one kind.
Schema study_schema(StudyKind kind);

/// Shape of a study file; lives for ever.
const Schema& study_file_schema();

/// A study file that is known to be right: its motor, and its entries as they stand there.
struct StudyFile {
  StudyKind kind;      ///< what it asks
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
