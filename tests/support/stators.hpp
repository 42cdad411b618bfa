// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/stator_model.hpp>

namespace twum::test {

/// A 60 mm stator with nine wavelengths whose radii are all different, so that each can be varied alone.
inline stator::StatorGeometry distinct_stator() {
  stator::StatorGeometry g;
  g.substrate = {0.0205, 0.0300, 3.0e-3, 105e9, 0.34, 8800};
  g.web = stator::Web{0.0125, 0.0210, 1.4e-3};
  g.teeth = stator::Teeth{90, 1.5e-3, 0.6e-3, 0.0232, 0.0295, 0.12};
  g.glue = {0.05e-3, 4e9, 0.35, 1200};
  g.ceramic = {0.0224, 0.0298, 0.5e-3, 75e9, 0.31, 7600, -130e-12, 1.1e-8};
  g.electrodes = {4, 0.0226, 0.0297};
  g.support = stator::InnerEdge::clamped;
  return g;
}

/// The stator of docs/theory/stator-plate.md, section 7.
/// @param stiffness_share  of the teeth
inline stator::StatorGeometry default_stator(double stiffness_share) {
  stator::StatorGeometry g;
  g.substrate = {0.0215, 0.0300, 2.4e-3, 110e9, 0.34, 8800};
  g.web = stator::Web{0.0125, 0.0215, 1.0e-3};
  g.teeth = stator::Teeth{90, 1.6e-3, 0.6e-3, 0.0230, 0.0300, stiffness_share};
  g.glue.thickness = 0.02e-3;
  g.ceramic = {0.0220, 0.0300, 0.5e-3, 80e9, 0.31, 7600, -125e-12, 1275 * 8.8541878128e-12};
  g.electrodes = {4, {}, {}};
  g.support = stator::InnerEdge::clamped;
  return g;
}

inline constexpr int kWaves = 9;
inline constexpr double kContactRadius = 0.0265;  // [m]

inline stator::StatorModel differentiated(
    const stator::StatorGeometry& g, double contact_radius = kContactRadius,
    stator::PlateTheory theory = stator::PlateTheory::mindlin) {
  return stator::stator_model(g, kWaves, contact_radius, theory, stator::Derivatives::all);
}

}  // namespace twum::test
