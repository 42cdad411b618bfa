// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <string>

/// Files as texts, for tests that damage or compare them.
namespace twum::test {

inline std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Replaces the first `from` in a file; false if there is none.
inline bool replace_in(const std::string& path, const std::string& from, const std::string& to) {
  std::string text = content(path);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return false;
  write(path, text.replace(at, from.size(), to));
  return true;
}

}  // namespace twum::test
