// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <string>
#include <string_view>

/// How a page is put together; internal.
namespace twum::studies {

/// JSON that may stand inside an HTML script element, whatever the names in it are.
std::string embedded(const Json& json);

/// A page with its mark replaced. What goes in last is not searched for marks.
std::string filled(std::string_view page, std::string_view mark, std::string_view content);

}  // namespace twum::studies
