// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/eigenmodes.hpp>

#include <complex>

namespace twum::inline v0_1::solid {

/// Integral of (eps_r + eps_t) e^(-i n phi) over the ceramic of a sector between two radii, which are lines of the mesh (F2.4)
/// [m^2], for a motion in metres.
std::complex<double> ceramic_stretch(const Sector& sector, int nodal_diameters,
                                     const Eigenmode& mode, double inner, double outer);

}  // namespace twum::inline v0_1::solid
