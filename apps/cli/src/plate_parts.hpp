// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json_parts.hpp"

#include <twum/core/plate.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A mode of the plate as `twum stator` lists it.
struct ListedMode {
  stator::StatorMode mode;
  bool drive;  ///< whether it carries the travelling wave
};

/// The drive's mode and the other modes of n - 2 to n + 2 that are nearest to it, lowest frequency first.
/// @param count  of all modes, at least 1
std::vector<ListedMode> listed_modes(const MotorDesign& design, std::size_t count);

/// Numbers of the plate of a design with a geometry, beside its modal data, and its modes, for the terminal.
std::string plate_text(const MotorDesign& design, std::size_t modes);

/// The same as JSON with the radial shape; adds the units of its entries.
Json plate_json(const MotorDesign& design, std::size_t modes, Json& units);

}  // namespace twum::inline v0_1::cli
