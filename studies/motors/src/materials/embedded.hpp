// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace twum::inline v0_1::motors {

/// A file of `materials/`, built into the program.
struct EmbeddedFile {
  std::string_view name, text;
};

std::span<const EmbeddedFile> embedded_materials();

}  // namespace twum::inline v0_1::motors
