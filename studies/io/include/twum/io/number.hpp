// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// Reads a text that is a number as a whole, such as "1.5", "+2", ".5", "5." or "1e-6". Nothing for any other text,
/// including hexadecimal, infinite and NaN, and beyond the range of a double. Independent of the locale.
std::optional<double> parse_number(std::string_view text) noexcept;

/// parse_number(text) times 10^power, rounded once: "26.5" with power -3 is exactly 0.0265.
std::optional<double> parse_decimal(std::string_view text, int power) noexcept;

/// Length of the number that `text` begins with (sign and exponent included), 0 if there is none.
std::size_t number_prefix(std::string_view text) noexcept;

/// The meanings that a number with commas may have, as texts without any; empty where there is no such meaning.
struct CommaReadings {
  std::string decimal;    ///< "1.2" of "1,2" and "1200.5" of "1.200,5"
  std::string thousands;  ///< "1200.5" of "1,200.5"
};
/// "1,200" has both meanings.
CommaReadings comma_readings(std::string_view number);

/// What is wrong with a number because of its commas, its minus sign or marks between thousands, and what to write instead;
/// both empty if that is not what is wrong.
struct NumberComplaint {
  std::string found;     ///< "'0,3 mm' has a decimal comma"
  std::string expected;  ///< "write '0.3 mm'"
};
/// @param unit  what follows the number
NumberComplaint number_complaint(std::string_view number, std::string_view unit = {});

/// Appends the shortest text that reads back as the same double; nothing for NaN. Independent of the locale.
void append_number(std::string& out, double value);

/// The shortest text that reads back as the same double; empty for NaN.
std::string number_text(double value);

/// The value to a number of significant digits (1 to 17), without trailing zeros.
std::string rounded_text(double value, int digits);

/// A rounded number for a sentence: two significant digits, or a whole number from 100 on.
std::string about(double value);

}  // namespace twum::inline v0_1::io
