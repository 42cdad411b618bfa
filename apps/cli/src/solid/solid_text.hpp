// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json_parts.hpp"
#include "solid/solid_stator.hpp"

#include <twum/motors/motor_file.hpp>

#include <optional>
#include <string>

namespace twum::inline v0_1::cli {

/// The stator of a motor as a solid, beside the plate model.
struct SolidComparison {
  studies::MotorFile file{};
  std::size_t listed_modes{};
  SolidStator solid{};
  std::optional<StatorNumbers> plate{};         ///< nothing if the plate has no wave
  std::optional<solid::FittedShare> share{};    ///< of teeth
  std::optional<StatorNumbers> fitted_plate{};  ///< the plate with this share
};

/// As tables and sentences.
std::string solid_text(const SolidComparison& comparison);

/// As JSON.
std::string solid_json(const SolidComparison& comparison);

}  // namespace twum::inline v0_1::cli
