// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <string>
#include <string_view>

/// Assembly of a page; internal.
namespace twum::inline v0_1::studies {

/// JSON that may stand inside an HTML script element, whatever the names in it are.
std::string embedded(const Json& json);

/// A script or a style with its hash (SHA-256).
struct HashedText {
  std::string_view text;
  std::string_view hash;
};

/// A template with style and script, and with the content security policy that admits them and no others.
std::string dressed(std::string_view page, const HashedText& style, const HashedText& script);

/// A page with its mark replaced. The inserted text is not searched for marks.
std::string filled(std::string_view page, std::string_view mark, std::string_view content);

}  // namespace twum::inline v0_1::studies
