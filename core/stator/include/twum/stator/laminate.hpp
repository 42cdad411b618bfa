// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace twum::inline v0_1::stator {

/// Shear factor of Mindlin's plate, pi^2 / 12 [1].
inline constexpr double kMindlinShearFactor = 0.82246703342411321824;

/// One layer of a laminate, isotropic. S is double, or a dual number to carry derivatives.
template <typename S>
struct LayerOf {
  S thickness;       ///< h_j [m]
  S youngs_modulus;  ///< E_j [Pa]
  S poisson_ratio;   ///< nu_j [1]
  S density;         ///< rho_j [kg/m^3]
};

/// Properties of a plate's cross section, integrated over the thickness.
template <typename S>
struct SectionOf {
  S neutral_plane;      ///< z_n, height of the neutral plane above the bottom [m]
  S top;                ///< height of the top surface above the bottom [m]
  S bending_stiffness;  ///< D [N m]
  S poisson_ratio;      ///< nu of the bending stiffness [1]
  S shear_stiffness;    ///< k_G sum G_j h_j [N/m]
  S mass;               ///< m'', mass per area [kg/m^2]
  S rotary_inertia;     ///< I'', rotary inertia per area about the neutral plane [kg]
};

using Layer = LayerOf<double>;      ///< in plain numbers
using Section = SectionOf<double>;  ///< in plain numbers

/// Section of a laminate, layers from the bottom to the top (P1.1, P1.2, P1.3, P1.4, P1.5, P1.6).
/// Smooth; never throws. At least one layer needs a stiffness and a thickness above zero.
/// @param shear_factor  k_G [1]
template <typename S>
SectionOf<S> section_of(const std::vector<LayerOf<S>>& layers,
                        double shear_factor = kMindlinShearFactor) {
  const auto in_plane = [](const LayerOf<S>& layer) {
    return layer.youngs_modulus / (1.0 - layer.poisson_ratio * layer.poisson_ratio);
  };
  S stretching(0.0);
  S moment(0.0);
  S top(0.0);
  for (const LayerOf<S>& layer : layers) {
    const S stiffness = in_plane(layer) * layer.thickness;
    stretching += stiffness;
    moment += stiffness * (top + 0.5 * layer.thickness);
    top += layer.thickness;
  }
  SectionOf<S> section{moment / stretching, top, S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
  S lower = -section.neutral_plane;
  for (const LayerOf<S>& layer : layers) {
    const S upper = lower + layer.thickness;
    const S cube = (upper * upper * upper - lower * lower * lower) / 3.0;
    const S bending = in_plane(layer) * cube;
    section.bending_stiffness += bending;
    section.poisson_ratio += layer.poisson_ratio * bending;
    section.shear_stiffness +=
        shear_factor * layer.youngs_modulus / (2.0 * (1.0 + layer.poisson_ratio)) * layer.thickness;
    section.mass += layer.density * layer.thickness;
    section.rotary_inertia += layer.density * cube;
    lower = upper;
  }
  section.poisson_ratio = section.poisson_ratio / section.bending_stiffness;
  return section;
}

}  // namespace twum::inline v0_1::stator
