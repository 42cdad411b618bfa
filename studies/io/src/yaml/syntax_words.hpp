// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace twum::inline v0_1::io {

/// A message of the YAML parser reworded for users who write motor files.
struct SyntaxWords {
  std::string_view parser;
  const char* found;
  const char* expected;
};

/// Null for an unknown message.
const SyntaxWords* syntax_words(std::string_view parser_message);

}  // namespace twum::inline v0_1::io
