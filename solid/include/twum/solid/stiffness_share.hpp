// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/geometry.hpp>

#include <optional>

namespace twum::inline v0_1::solid {

/// The stiffness_share of the teeth with which the plate has a given frequency.
struct FittedShare {
  std::optional<double> share;  ///< chi; nothing if no value from 0 to 1 gives the frequency [1]
  double lowest;                ///< the plate's frequency with 0 [Hz]
  double highest;  ///< the plate's frequency with 1, teeth as stiff as solid metal [Hz]
};

/// Finds the share by a bounded search; the plate's frequency rises with it.
/// @param frequency  that the plate has to meet [Hz]
/// @throws InputError without teeth, or as stator::stator_model(); EvaluationError if the plate has no wave
FittedShare fit_stiffness_share(const stator::StatorGeometry& geometry, int wavelengths,
                                double contact_radius, double frequency);

}  // namespace twum::inline v0_1::solid
