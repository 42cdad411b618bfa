// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/yaml_node.hpp>
#include <twum/studies/study_file.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A complete study: the whole motor, and every default written out.
struct ResolvedStudy {
  /// A file that the study names, by the entry that names it.
  struct NamedFile {
    std::string entry;  ///< "data", "data[1]", "start" or "choose.lining[0]"
    std::string path;   ///< from the current folder; of `start` a directory of results
    std::string hash;   ///< of its content, times aside
    /// Where a directory of results keeps a copy of `path`, such as "inputs/points.csv"; empty: too large for one.
    std::string copy{};

    /// The file that is read: of `start` the summary in the directory.
    std::string source() const { return entry == "start" ? path + "/summary.json" : path; }
    /// The copy of source(), in the directory of results.
    std::string kept() const { return entry == "start" ? copy + "/summary.json" : copy; }
  };
  MotorFile motor;
  YamlNode study;    ///< what stands below `study:`, as typed
  YamlNode meaning;  ///< the same in SI, so that equivalent studies are equal
  std::vector<NamedFile> files;

  /// As a study file. Quantities are as typed, those of the motor in SI.
  /// @param folder  directory of the results, in which it names the copies of its files; other paths are relative to it. Empty:
  ///                paths as typed
  std::string text(const std::string& folder = {}) const;
  /// Hash of everything that determines the result.
  std::string hash() const;
};

/// @throws InputError if a file that the study names cannot be read
ResolvedStudy resolve(const StudyFile& file);

/// Content of a file that a study names.
/// @throws InputError if it cannot be read, or is not the one that was resolved
std::string content_of(const ResolvedStudy::NamedFile& file);

/// The differences between two studies, one line each: "study.samples: '100' there, '200' here".
/// @param stored  text() of the one that is there
std::vector<std::string> differences(const std::string& stored, const std::string& now);

}  // namespace twum::inline v0_1::studies
