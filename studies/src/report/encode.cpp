// SPDX-License-Identifier: Apache-2.0
#include "report/encode.hpp"

#include <bit>
#include <cstddef>
#include <string_view>

namespace twum::studies {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string encoded(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  const auto at = [&](std::size_t i) {
    return i < bytes.size() ? std::to_integer<unsigned>(bytes[i]) : 0U;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = at(i) << 16U | at(i + 1) << 8U | at(i + 2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

}  // namespace

std::string base64(std::string_view bytes) { return encoded(std::as_bytes(std::span(bytes))); }
std::string base64(std::span<const double> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const float> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const std::uint16_t> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const std::uint32_t> values) { return encoded(std::as_bytes(values)); }

}  // namespace twum::studies
