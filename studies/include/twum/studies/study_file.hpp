// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/diagnostics.hpp>
#include <twum/io/schema.hpp>
#include <twum/io/yaml_node.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/study.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twum::inline v0_1::studies {

/// Shape of the mapping below `study:` for one kind.
Schema study_schema(StudyKind kind);

/// Shape of a study file; static lifetime.
const Schema& study_file_schema();

/// A study with its motor, from a valid file or from a program.
struct StudyFile {
  MotorFile motor{};     ///< with `set:` and the settings of the command line applied
  Study asked{};         ///< the question, in SI
  YamlNode study{};      ///< the mapping below `study:`, as typed; empty if no file was read
  std::string folder{};  ///< directory to which paths are relative
  std::string path{};    ///< path of the file itself; "-" is standard input

  /// The kind of study.
  StudyKind kind() const { return kind_of(asked); }
};

/// Reads a study file and its motor; "-" is standard input.
/// @param settings  "NAME=VALUE" overrides, applied after those of the file
/// @throws FileError with everything that is wrong in it, and in its motor file;
///         InputError if it cannot be read or a setting is wrong.
StudyFile read_study_file(const std::string& path, std::span<const std::string> settings = {});
/// The same for a text; paths in it are relative to `folder`.
/// @throws FileError and InputError likewise.
StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings = {});

/// The metrics of the program that a study asks for, each name once: a name stands for one function.
/// @throws InputError if two of one name have different units
OwnMetrics own_metrics(const Study& study);

/// Checks a study as read_study() checks a file, whether a program or a file made it; run_study() begins with this. The
/// files that it names are read when it runs. Costs about a millisecond. Metrics of the program are functions, which no
/// file can hold: a study that asks for them is right, but run_study() refuses to keep it in a directory.
/// @throws InputError with everything that is wrong, each with the name of its entry in a study file, such as
///         "study.variables.preload.max: ..."
void validate(const StudyFile& file);

/// True if a document is a study file rather than a motor file: it has `study:`, or `motor:` is the path of a file.
bool is_study(const Source& source);

/// The reference page of study files: every kind and entry, as Markdown.
std::string study_reference();

/// A commented template of a study file of one kind. It is valid in any directory; only `calibrate` needs a file with
/// measured points.
/// @param motor    path of a motor file that the study names; empty: the study contains the motor
/// @param voltage  of this motor, if it has one: varied in place of the amplitude [V]
std::string study_template(StudyKind kind, std::string_view motor = {},
                           std::optional<double> voltage = {});

}  // namespace twum::inline v0_1::studies
