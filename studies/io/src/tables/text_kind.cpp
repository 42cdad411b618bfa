// SPDX-License-Identifier: Apache-2.0
#include "tables/text_kind.hpp"

#include "text/utf8.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cstdint>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kHead = 512;  // bytes that tell the kind of a file

// A program's own format has no lines that could be read.
void refuse_documents(const std::string& name, std::string_view content) {
  const std::string save = "; save it as CSV (text with commas, UTF-8)";
  if (content.starts_with("PK\x03\x04"))
    throw InputError(name + ": is a spreadsheet (.xlsx, .ods) or another packed file, not a text" +
                     save);
  if (content.starts_with("\xD0\xCF\x11\xE0"))
    throw InputError(name + ": is a spreadsheet (.xls) or another document, not a text" + save);
}

enum class Order : unsigned char { none, little, big };

// UTF-16 by its mark, or by the zero bytes of Latin letters.
Order utf16_order(const std::string& name, std::string_view content) {
  if (content.starts_with("\xFF\xFE")) return Order::little;
  if (content.starts_with("\xFE\xFF")) return Order::big;
  const std::string_view head = content.substr(0, kHead);
  std::size_t zeros[2] = {0, 0};  // at even and at odd places
  for (std::size_t i = 0; i < head.size(); ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  if (zeros[0] + zeros[1] == 0) return Order::none;
  if (zeros[0] == 0 && zeros[1] > head.size() / 4) return Order::little;
  if (zeros[1] == 0 && zeros[0] > head.size() / 4) return Order::big;
  throw InputError(name + ": is not a text; save it as CSV (text with commas, UTF-8)");
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
  const auto tail = [&](unsigned shift) { byte(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xC0U | (code >> 6U));
    return tail(0);
  }
  if (code < 0x10000) {
    byte(0xE0U | (code >> 12U));
    tail(6);
    return tail(0);
  }
  byte(0xF0U | (code >> 18U));
  tail(12);
  tail(6);
  tail(0);
}

std::string from_utf16(std::string_view bytes, Order order) {
  constexpr std::uint32_t kMark = 0xFEFF, kReplacement = 0xFFFD;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[2 * i + k]); };
    return order == Order::little ? at(0) | (at(1) << 8U) : at(1) | (at(0) << 8U);
  };
  std::string text;
  const std::size_t count = bytes.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t code = unit(i);
    if (code == kMark && i == 0) continue;
    if (code >= 0xD800 && code < 0xE000) {  // the half of a pair
      const bool pair =
          code < 0xDC00 && i + 1 < count && unit(i + 1) >= 0xDC00 && unit(i + 1) < 0xE000;
      code = pair ? 0x10000 + ((code - 0xD800) << 10U) + (unit(++i) - 0xDC00) : kReplacement;
    }
    append_utf8(text, code);
  }
  return text;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

// Each byte as the character of its number (ISO 8859-1).
std::string from_latin(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
  return text;
}

}  // namespace

std::string utf8_text(const std::string& name, std::string content,
                      std::vector<std::string>& kinds) {
  refuse_documents(name, content);
  if (const Order order = utf16_order(name, content); order != Order::none) {
    kinds.emplace_back("text in UTF-16");
    content = from_utf16(content, order);
  } else if (!is_utf8(content)) {
    kinds.emplace_back("text in ISO 8859-1");
    content = from_latin(content);
  }
  if (content.find('\r') != std::string::npos && content.find('\n') == std::string::npos) {
    kinds.emplace_back("line ends of carriage returns alone (CR)");
    std::ranges::replace(content, '\r', '\n');
  }
  return content;
}

}  // namespace twum::inline v0_1::io
