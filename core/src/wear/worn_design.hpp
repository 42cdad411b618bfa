// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>

#include <array>
#include <string>

namespace twum::inline v0_1::core {

/// Derivatives of a number in every parameter.
using WornGradient = std::array<double, kParameterCount>;

/// k_l + k_s, specific wear of both bodies [m^2/N].
double specific_wear_of_both(const MotorDesign& design);

/// The motor whose track has worn to a depth: h - s chi u and F_N - k_F u (V2.2).
MotorDesign worn_design(const MotorDesign& design, double depth);

/// The largest depth at which there is a lining and a preload, and why there is none beyond.
struct HardEnd {
  double depth;         ///< infinite: there is none [m]
  bool spring_relaxed;  ///< the preload is gone; else the lining is worn through
};
HardEnd hard_end(const MotorDesign& design);

/// Derivatives by the new motor's parameters at a depth that stays, from those by the worn motor's.
WornGradient by_new_motor(const MotorDesign& design, double depth, const WornGradient& of_worn);

/// How what depends on thickness and preload moves with the depth: -s chi d/dh - k_F d/dF_N.
double by_depth(const MotorDesign& design, double depth, const WornGradient& of_worn);

}  // namespace twum::inline v0_1::core
