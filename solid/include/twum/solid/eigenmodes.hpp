// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/sector.hpp>

#include <array>
#include <complex>
#include <iosfwd>
#include <vector>

namespace twum::inline v0_1::solid {

/// A wave that travels round the stator: the motion of one sector. That of the next one is ahead by n pitches. The sum of mass
/// times motion squared over the sector's nodes is 1 kg.
struct Eigenmode {
  double frequency;  ///< [Hz]; 0 of a rigid-body mode
  /// Along radius, circumference and axis, of each node of the sector [1].
  std::vector<std::array<std::complex<double>, 3>> motion;
};

/// Reads the modes of one number of nodal diameters that CalculiX printed (file .dat), lowest frequency first. Of the two modes
/// that CalculiX gives for a wave, the first is kept.
/// @throws InputError if there are no modes, or they are not those of this sector
std::vector<Eigenmode> read_eigenmodes(std::istream& dat, const Sector& sector);

}  // namespace twum::inline v0_1::solid
