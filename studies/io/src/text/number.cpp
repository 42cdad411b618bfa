// SPDX-License-Identifier: Apache-2.0
#include <twum/io/number.hpp>

#include "text/utf8.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace twum::inline v0_1::io {
namespace {

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

// Reads all of [first, last). std::from_chars does not accept '+', but accepts "inf" and "nan".
std::optional<double> read_all(const char* first, const char* last) noexcept {
  double value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return {};
  return value;
}

std::string without(std::string_view text, char separator) {
  std::string rest(text);
  std::erase(rest, separator);
  return rest;
}

// Whether commas stand before groups of three digits only, as in "1,200" and "1,200.5".
bool groups_thousands(std::string_view number) {
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  const std::size_t first = number.find(',');
  if (first == std::string_view::npos || first == 0 || first > 3 || number[0] == '0') return false;
  for (std::size_t at = first; at < number.size() && number[at] == ','; at += 4) {
    const std::string_view group = number.substr(at + 1, 3);
    const bool digits = group.size() == 3 && std::ranges::all_of(group, is_digit);
    const bool longer = at + 4 < number.size() && is_digit(number[at + 4]);
    if (!digits || longer) return false;
  }
  return true;
}

}  // namespace

std::size_t number_prefix(std::string_view text) noexcept {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t whole = skip_digits(text, at);
  std::size_t end = whole;
  std::size_t digits = whole - at;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = skip_digits(text, end + 1);
    digits += fraction - end - 1;
    end = fraction;
  }
  if (digits == 0) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    at = end + 1;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t exponent = skip_digits(text, at);
    if (exponent > at) end = exponent;
  }
  return end;
}

std::optional<double> parse_number(std::string_view text) noexcept {
  if (text.empty() || number_prefix(text) != text.size()) return {};
  if (text.front() == '+') text.remove_prefix(1);
  return read_all(text.data(), text.data() + text.size());
}

std::optional<double> parse_decimal(std::string_view text, int power) noexcept {
  if (power == 0) return parse_number(text);
  if (text.empty() || number_prefix(text) != text.size()) return {};
  if (text.front() == '+') text.remove_prefix(1);
  const std::size_t mark = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, mark);
  int exponent = 0;
  if (mark != std::string_view::npos) {
    std::string_view digits = text.substr(mark + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || exponent > 100000 || exponent < -100000) return {};
  }
  std::array<char, 96> buffer{};
  if (mantissa.size() > 64) {  // so many digits that a second rounding no longer matters
    const auto value = parse_number(text);
    if (!value || !std::isfinite(*value * std::pow(10.0, power))) return {};
    return *value * std::pow(10.0, power);
  }
  std::memcpy(buffer.data(), mantissa.data(), mantissa.size());
  char* at = buffer.data() + mantissa.size();
  *at++ = 'e';
  at = std::to_chars(at, buffer.data() + buffer.size(), exponent + power).ptr;
  return read_all(buffer.data(), at);
}

CommaReadings comma_readings(std::string_view number) {
  const std::size_t comma = number.find(',');
  if (comma == std::string_view::npos) return {};
  const auto if_number = [](std::string text) {
    return number_prefix(text) == text.size() ? std::move(text) : std::string();
  };
  CommaReadings readings;
  const std::size_t point = number.find('.');
  std::string pointed = without(number, '.');  // "1.200,5" as "1200.5"
  pointed[pointed.find(',')] = '.';
  if (point == std::string_view::npos || point < comma) readings.decimal = if_number(pointed);
  if (groups_thousands(number)) readings.thousands = if_number(without(number, ','));
  return readings;
}

namespace {

// "-1.5" of a number with the minus sign of books; empty for any other text.
std::string with_plain_minus(std::string_view number) {
  constexpr std::string_view kMinus = "\xE2\x88\x92";  // U+2212
  if (!number.starts_with(kMinus)) return {};
  std::string plain = "-" + std::string(number.substr(kMinus.size()));
  return parse_number(plain) ? plain : std::string();
}

// "1200.5" of "1 200.5" and "1'200.5"; empty for any other text.
std::string without_marks(std::string_view number) {
  for (const std::string_view mark : {" ", "'", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"}) {
    std::string grouped(number);
    for (std::size_t at; (at = grouped.find(mark)) != std::string::npos;)
      grouped.replace(at, mark.size(), ",");
    std::string whole = without(grouped, ',');
    if (grouped != number && groups_thousands(grouped) && parse_number(whole)) return whole;
  }
  return {};
}

}  // namespace

NumberComplaint number_complaint(std::string_view number, std::string_view unit) {
  const auto [decimal, thousands] = comma_readings(number);
  const auto shown = [&](std::string_view text) {
    return quoted(std::string(text) + std::string(unit));
  };
  if (!decimal.empty() && !thousands.empty())
    return {
        shown(number) + " has a comma, which may stand for a decimal point or separate thousands",
        "write " + shown(decimal) + " or " + shown(thousands)};
  if (!thousands.empty())
    return {shown(number) + " has commas between thousands", "write " + shown(thousands)};
  if (!decimal.empty()) return {shown(number) + " has a decimal comma", "write " + shown(decimal)};
  if (const std::string plain = with_plain_minus(number); !plain.empty())
    return {shown(number) + " has the minus sign of books", "write " + shown(plain)};
  if (const std::string whole = without_marks(number); !whole.empty())
    return {shown(number) + " has marks between thousands", "write " + shown(whole)};
  return {};
}

void append_number(std::string& out, double value) {
  if (std::isnan(value)) return;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  out.append(buffer.data(), end);
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string rounded_text(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {buffer.data(), end};
}

}  // namespace twum::inline v0_1::io
