// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/shape.hpp>
#include <twum/studies/study_file.hpp>

#include <functional>
#include <string>
#include <vector>

/// The entry `choose`: sets of parameters in files; internal.
namespace twum::inline v0_1::studies::shapes {

/// Choices by name, each a list of files. Their values come from read_sets().
Shape<std::vector<DesignChoice>> choices();

/// The entry `choose` of a study S.
template <typename S>
Field<S> choose_field() {
  return hidden(optional<S>("choose", choices(), &S::choose, "none"));
}

/// A file of a set, and its place below `study:`.
struct SetFile {
  std::size_t choice;  ///< position of its choice
  std::size_t set;     ///< position in the choice
  std::string entry;   ///< "choose.lining[0]"
  YamlNode* item;      ///< the path, or the mapping with `file:`
  YamlNode* path;      ///< the path
};

/// The files that a study's `choose` names; items that are not paths are left out.
std::vector<SetFile> set_files(YamlNode& study);

}  // namespace twum::inline v0_1::studies::shapes
