// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace twum::studies {

/// A message of the YAML parser in words for somebody who writes a motor file.
struct SyntaxWords {
  std::string_view parser;
  const char* found;
  const char* expected;
};

/// Null if the message is not one we know.
const SyntaxWords* syntax_words(std::string_view parser_message);

}  // namespace twum::studies
