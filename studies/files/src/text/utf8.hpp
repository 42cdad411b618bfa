// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace twum::studies {

/// Bytes of the well-formed UTF-8 character at the front of a text, 0 if there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace twum::studies
