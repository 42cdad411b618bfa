// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the exercise adds to study_result.hpp.

/// The holding torque of a motor over its preload.
struct SqueezeResult {
  std::vector<double> preloads;  ///< [N]
  std::vector<double> torques;   ///< [N m]
};
