// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>

#include <map>
#include <string>

namespace twum::inline v0_1::studies {

/// Finds repeated items of a list in n log n time.
class Repeats {
 public:
  /// @param path    of the list, such as "study.limits"
  /// @param remedy  advice in the error
  Repeats(std::string path, std::string remedy, Diagnostics& diagnostics)
      : path_(std::move(path)), remedy_(std::move(remedy)), diagnostics_(diagnostics) {}

  /// Checks the next item. Items with the same meaning are repeats.
  void see(const YamlNode& item, const std::string& meaning);

 private:
  std::string path_;
  std::string remedy_;
  Diagnostics& diagnostics_;
  std::map<std::string, SourceMark> first_;
};

}  // namespace twum::inline v0_1::studies
