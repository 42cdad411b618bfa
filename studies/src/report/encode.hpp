// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Bytes, and columns of numbers, as base64 of their little-endian bytes, which a browser converts to typed arrays
/// without parsing digits; internal.
namespace twum::inline v0_1::studies {

std::string base64(std::string_view bytes);
std::string base64(std::span<const double> values);
std::string base64(std::span<const float> values);
std::string base64(std::span<const std::uint16_t> values);
std::string base64(std::span<const std::uint32_t> values);

/// What is large, in 15/16 of the letters of base64: four bytes are five digits of base 85, written as the letters from ( to ~
/// without < and \.
std::string base85(std::string_view bytes);

}  // namespace twum::inline v0_1::studies
