// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// A unit as people type it, in the spelling of the unit system: "N⋅m" is "N.m", "m⁻¹" is "m^-1", "r/min" is "rpm", and
/// "Vrms" is "V", because voltages and currents are rms everywhere.
std::string usual_spelling(std::string_view unit);

/// A unit of amplitudes, such as "Vpp": the unit that it counts in, and the rms value of a sine of one of it.
struct PeakUnit {
  std::string_view base;
  double rms;
};
/// Nothing for any other unit.
std::optional<PeakUnit> peak_unit(std::string_view unit);

}  // namespace twum::inline v0_1::io
