// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/plate.hpp>

#include <vector>

namespace twum::test {

/// Natural frequencies of a stepped thin plate by exact solutions on each ring: J_n, Y_n, I_n, K_n, joined by
/// deflection, slope, bending moment and effective shear force (Leissa, Vibration of Plates, NASA SP-160,
/// chapter 2). Shares nothing with the Ritz method but the data. Rotary inertia is left out.
/// @return the lowest frequencies [Hz] above zero
std::vector<double> exact_thin_plate(const std::vector<stator::Segment>& segments,
                                     stator::InnerEdge inner_edge, int nodal_diameters, int count);

}  // namespace twum::test
