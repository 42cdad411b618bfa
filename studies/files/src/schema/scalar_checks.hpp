// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/schema/schema.hpp>

#include <string_view>

namespace twum::studies {

/// Reads a quantity or count as a schema wants it, in SI.
/// @throws ValueError saying what was found and what would be right.
double read_number(std::string_view text, const Schema& schema);
/// The two halves of it: the number, whatever its size, and whether its size is right.
/// @throws ValueError likewise
/// @{
double parse_number_of(std::string_view text, const Schema& schema);
void check_size(double value, std::string_view text, const Schema& schema);
/// @}

/// @throws ValueError unless the text is what a schema of kind quantity, count, word or text wants.
void check_scalar(std::string_view text, const Schema& schema);

/// "expected a length [m] such as '0.3 mm'" for any schema.
std::string expectation(const Schema& schema);

}  // namespace twum::studies
