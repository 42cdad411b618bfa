// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/yaml_node.hpp>
#include <twum/studies/study_file.hpp>

#include <string>
#include <vector>

namespace twum::studies {

/// A complete study: the whole motor, and every default written out.
struct ResolvedStudy {
  /// A file that the study names, by the entry that names it.
  struct NamedFile {
    std::string entry;  ///< "data", "data[1]", "start" or "choose.lining[0]"
    std::string path;   ///< from the current folder
    std::string hash;   ///< of its content, times aside
  };
  MotorFile motor;
  YamlNode study;    ///< what stands below `study:`, as typed
  YamlNode meaning;  ///< the same in SI, so that equivalent studies are equal
  std::vector<NamedFile> files;

  /// As a study file. Quantities are as typed, those of the motor in SI.
  /// @param folder  directory to which its paths are made relative; empty: paths as typed
  std::string text(const std::string& folder = {}) const;
  /// Hash of everything that determines the result.
  std::string hash() const;
};

/// @throws InputError if a file that the study names cannot be read
ResolvedStudy resolve(const StudyFile& file);

/// The differences between two studies, one line each: "study.samples: '100' there, '200' here".
/// @param stored  text() of the one that is there
std::vector<std::string> differences(const std::string& stored, const std::string& now);

}  // namespace twum::studies
