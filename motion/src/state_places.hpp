// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <twum/motion/motion.hpp>

#include <array>
#include <cstddef>

namespace twum::inline v0_1::motion {

/// States of every motion: zeta = A e^(-i phi) in Cartesian parts, Omega, theta_r, the electrical energy, and the angle by which zeta
/// has turned while the drive is off. Then only A counts for all else; a zeta that stood for its phase, too, would turn
/// thousands of times a second. Of a motor with a given amplitude zeta stays zero.
enum StateIndex : std::size_t { kReal, kImaginary, kSpeed, kAngle, kEnergy, kTurn, kBaseStates };

/// Where the states of circuit and rotor stand after those of any motion, or of any plant, and how many there are together. A motion has only those that it needs: the integrator
/// measures its error over all of them.
class StatePlaces {
 public:
  static constexpr std::size_t kNone = 0;  // the place of zeta

  /// @param base  states before these
  StatePlaces(const MotionModel& model, AxialMotion axial, std::size_t base = kBaseStates)
      : count(base) {
    const bool series = model.driven && model.has_series();
    if (series) voltage = add();
    if (series && model.series_inductance != 0) current = add();
    if (axial == AxialMotion::dynamic) height = add(), rise = height + 1;
  }

  std::size_t voltage{kNone};  ///< u at the terminals, in two parts (M3.1) [V]
  std::size_t current{kNone};  ///< I of a phase, in two parts (M3.1) [A]
  std::size_t height{kNone};   ///< of the rotor's face, z [m]
  std::size_t rise{kNone};     ///< z' [m/s]
  std::size_t count;

 private:
  std::size_t add() {
    count += 2;
    return count - 2;
  }
};

/// As many as any motion has.
inline constexpr std::size_t kMostStates = kBaseStates + 6;
using States = std::array<double, kMostStates>;

}  // namespace twum::inline v0_1::motion
