// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/schema.hpp>

#include <string_view>

namespace twum::inline v0_1::io {

/// Reads a quantity or count according to a schema, in SI.
/// @throws ValueError saying what was found and what would be right.
double read_number(std::string_view text, const Schema& schema);
/// The two parts of it: reading the number, and checking its range.
/// @throws ValueError likewise
/// @{
double parse_number_of(std::string_view text, const Schema& schema);
void check_size(double value, std::string_view text, const Schema& schema);
/// @}

/// @throws ValueError unless the text fits a schema of kind quantity, count, word or text.
void check_scalar(std::string_view text, const Schema& schema);

/// True for a mapping whose names are parameters; their shapes differ in units and ranges only. They are too many to be
/// listed in a message.
bool by_parameter(const Schema& schema);

/// "expected a length [m] such as '0.3 mm'" for any schema.
std::string expectation(const Schema& schema);

}  // namespace twum::inline v0_1::io
