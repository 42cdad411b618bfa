// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/stator/stator_model.hpp>

#include <memory>

namespace twum {

/// Modes of a design's stator from its geometry: frequency, modal mass, force factor and the other numbers that the
/// drive needs, with their derivatives. shape_values are R at the four radii of (P8.1), then at the inner and the
/// outer edge of the contact track.
///
/// Each thread keeps the last few results, so that asking again for the same geometry, wavelengths and track costs
/// microseconds. The first time costs 6 milliseconds, and a fourth of it without the modes beside the wave.
/// @param others  whether mode_separation and the list of unwanted modes are wanted
/// @throws InputError if the design has no geometry, or one that cannot be built or does not fit wavelengths and track
/// @throws EvaluationError "no-ring-mode" as stator::stator_model()
std::shared_ptr<const stator::StatorModel> plate_model(
    const MotorDesign& design, stator::OtherModes others = stator::OtherModes::found);

}  // namespace twum
