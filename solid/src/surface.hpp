// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/eigenmodes.hpp>

#include <complex>
#include <vector>

namespace twum::inline v0_1::solid {

/// Motion of the top of the stator at one radius: the mean of u e^(-i n phi) over the top, which of teeth is their tips (F2.1).
struct SurfaceMotion {
  double radius;                    ///< [m]
  std::complex<double> radial;      ///< along the radius [1]
  std::complex<double> tangential;  ///< round the circumference [1]
  std::complex<double> axial;       ///< W [1]
};

/// At each line of constant radius, from the inside.
std::vector<SurfaceMotion> surface_motion(const Sector& sector, int nodal_diameters,
                                          const Eigenmode& mode);

/// That of the line nearest to a radius [m].
const SurfaceMotion& at_radius(const std::vector<SurfaceMotion>& surface, double radius);

}  // namespace twum::inline v0_1::solid
