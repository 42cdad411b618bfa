// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/source.hpp>

#include <string>

namespace twum::inline v0_1::cli {

/// The text of a motor file with another stiffness_share of the teeth, and nothing else changed.
/// @param text  of a motor file that was read without errors and has teeth
std::string with_stiffness_share(const studies::Source& text, double share);

}  // namespace twum::inline v0_1::cli
