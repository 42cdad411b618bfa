// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

#include <map>
#include <string>

namespace twum::studies {

/// Finds what stands in a list for the second time, in a time that grows with the list's length only
/// as sorting does.
class Repeats {
 public:
  /// @param path    of the list, such as "study.limits"
  /// @param remedy  what to do about it
  Repeats(std::string path, std::string remedy, Diagnostics& diagnostics)
      : path_(std::move(path)), remedy_(std::move(remedy)), diagnostics_(diagnostics) {}

  /// Looks at the next item. Two of one meaning are the same.
  void see(const YamlNode& item, const std::string& meaning);

 private:
  std::string path_;
  std::string remedy_;
  Diagnostics& diagnostics_;
  std::map<std::string, SourceMark> first_;
};

}  // namespace twum::studies
