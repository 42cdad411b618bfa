// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// Access to UDUNITS-2; internal. Every call is serialized, because its parser is not thread-safe.

/// SI value of one `unit` if it has the dimension of `si_unit` ("1": none); nothing if not.
/// Both must be known units.
std::optional<double> factor_to(std::string_view unit, std::string_view si_unit);

/// Powers of the base units m, kg, s, rad, A and K in a known unit.
std::array<int, 6> base_powers(std::string_view unit);

/// True if the text is a unit with a unique meaning.
bool is_unit(std::string_view unit);

/// Why a text that looks like a unit is refused: "5 mm" as a unit, "W/m.K"; empty if it is well formed.
std::string unit_form_complaint(std::string_view unit);

}  // namespace twum::inline v0_1::io
