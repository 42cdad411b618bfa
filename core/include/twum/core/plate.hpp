// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/stator/stator_model.hpp>

#include <memory>

namespace twum::inline v0_1 {

/// Modes of a design's stator from its geometry: frequency, modal mass, force factor and the other numbers that the
/// drive needs, with their derivatives. shape_values are R at the four radii of (P8.1), then at the inner and the
/// outer edge of the contact track.
///
/// Costs less than a microsecond for a design that keeps its plate, once it was asked the same: one made by with(), that of a
/// Motor, one given to keep_plate(). Otherwise it costs some milliseconds, most of them for the modes beside the wave.
/// @param others       whether mode_separation and the list of unwanted modes are wanted; with them come derivatives
/// @param derivatives  whether derivatives are wanted; without them they are NaN
/// @throws InputError if the design has no geometry, or one that cannot be built or does not fit wavelengths and track
/// @throws EvaluationError "no-ring-mode" as stator::stator_model()
std::shared_ptr<const stator::StatorModel> plate_model(
    const MotorDesign& design, stator::OtherModes others = stator::OtherModes::found,
    stator::Derivatives derivatives = stator::Derivatives::all);

/// Its mode_separation alone.
stator::Derived plate_separation(const MotorDesign& design, stator::Derivatives derivatives);

/// Solves the plate of a design and keeps it there (Stator::plate), so that plate_model() and get() need not solve it again for
/// this design and its copies. Does nothing where it is known, without a geometry, and where no plate can be solved.
void keep_plate(MotorDesign& design);

}  // namespace twum::inline v0_1
