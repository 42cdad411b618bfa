// SPDX-License-Identifier: Apache-2.0
#include "report/encode.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace twum::inline v0_1::studies {
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

std::string base85(std::string_view bytes) {
  const auto letter = [](std::uint32_t digit) {
    const std::uint32_t at = '(' + digit;
    return static_cast<char>(at < '<' ? at : at + 1 < '\\' ? at + 1 : at + 2);
  };
  std::string text;
  text.reserve((bytes.size() + 3) / 4 * 5);
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 4; ++k)
      group = group << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    std::array<char, 5> digits{};
    for (std::size_t k = digits.size(); k-- > 0; group /= 85) digits[k] = letter(group % 85);
    // n bytes are n + 1 digits
    text.append(digits.data(), std::min<std::size_t>(4, bytes.size() - i) + 1);
  }
  return text;
}

std::string base64(std::string_view bytes) { return encoded(std::as_bytes(std::span(bytes))); }
std::string base64(std::span<const double> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const float> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const std::uint16_t> values) { return encoded(std::as_bytes(values)); }
std::string base64(std::span<const std::uint32_t> values) { return encoded(std::as_bytes(values)); }

}  // namespace twum::inline v0_1::studies
