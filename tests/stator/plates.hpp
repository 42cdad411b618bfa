// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/plate.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace twum::test {

/// A homogeneous plate of unit Young's modulus and density, outer radius 1 m.
/// @param thickness      [m]
/// @param poisson_ratio  [1]
inline stator::Section homogeneous(double thickness, double poisson_ratio = 0.3,
                                   double shear_factor = stator::kMindlinShearFactor) {
  return stator::section_of<double>({{thickness, 1, poisson_ratio, 1}}, shear_factor);
}

/// The same without rotary inertia: the classical thin plate.
inline stator::Section thin(double thickness = 0.01, double poisson_ratio = 0.3) {
  stator::Section section = homogeneous(thickness, poisson_ratio);
  section.rotary_inertia = 0;
  return section;
}

/// lambda^2 = omega r_o^2 sqrt(m'' / D), with r_o = 1 m, of a frequency [Hz].
inline double lambda_squared(double frequency, const stator::Section& section) {
  return 2 * std::numbers::pi * frequency * std::sqrt(section.mass / section.bending_stiffness);
}

/// lambda^2 of the lowest mode of each number of nodal circles, rigid-body modes left out.
inline std::vector<double> lambdas(const std::vector<stator::Segment>& segments,
                                   stator::PlateTheory theory, stator::InnerEdge edge, int n,
                                   int count) {
  std::vector<double> result;
  for (const auto& mode : stator::plate_modes(segments, theory, edge, n, count + 2)) {
    if (mode.frequency > 0 && static_cast<int>(result.size()) < count) {
      result.push_back(lambda_squared(mode.frequency, segments.back().section));
    }
  }
  return result;
}

}  // namespace twum::test
