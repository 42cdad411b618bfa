// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/source.hpp>

#include <string>
#include <vector>

namespace twum::studies {

/// A torque read at a rotor speed that the test stand sets.
struct MeasuredPoint {
  double speed;         ///< [rad/s]
  double torque;        ///< [N m], negative where the rotor is driven
  double weight{1};     ///< of its squared residual; mean over all points 1
  double deviation{0};  ///< standard deviation of the torque [N m]; 0: not given
};

/// What a table of measured points holds.
struct MeasuredPoints {
  std::vector<MeasuredPoint> points;
  std::vector<std::string>
      without_unit;  ///< headings without a unit, and the SI unit they are read in: "torque [N.m]"
};

/// Reads a CSV file with the columns `speed`, `torque`, and at most one of `weight` and `torque_sd`,
/// units in the header; lines that begin with # are remarks. A standard deviation s gives the weight 1 / s^2.
/// @throws FileError with everything that is wrong in it; InputError if it cannot be read.
MeasuredPoints read_measured_points(const std::string& path);
MeasuredPoints read_measured_points(const Source& source);

}  // namespace twum::studies
