// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/heading.hpp"

#include <twum/core/parameters.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::motors {

/// Names of up to so many letters are symbols, of which another case means something else.
inline constexpr std::size_t kLongestSymbol = 4;

/// The parameter that a column's heading means: by its name, its symbol, or its entry in a motor file, such as
/// "friction.kinetic" or "motor.preload"; capitals of "Preload" mean nothing.
std::optional<Parameter> parameter_named(std::string_view name);

/// One letter without a unit, as of a column that numbers its rows ("n"). It must not set a parameter without a word.
bool is_bare_letter(const Heading& heading);

/// "the letter 'n' alone does not say whether wavelengths is meant"
std::string bare_letter_words(std::string_view letter, const ParameterInfo& row);
/// "write 'wavelengths', or another heading if it is no parameter"
std::string bare_letter_advice(const ParameterInfo& row);

/// The heading with which a parameter is read, such as "preload [N]".
std::string heading_of(const ParameterInfo& row);

}  // namespace twum::inline v0_1::motors
