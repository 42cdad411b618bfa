// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/test_motors.hpp"

#include <twum/core/motor_design.hpp>

#include <vector>

namespace twum::bench {

/// A motor with one kind of contact layer, and what its closed forms need.
struct Layer {
  const char* name;
  MotorDesign design;
  bool vibrates;  ///< it has inertia: sines and cosines
  bool decays;    ///< it has viscosity: exponentials
};

/// The 60 mm ring motor with the three kinds of layer.
inline std::vector<Layer> layers() {
  const MotorDesign ring = test::ring_motor();
  return {{"elastic", test::elastic(ring), false, false},
          {"damped", test::damped(ring), false, true},
          {"inertial", ring, true, true}};
}

}  // namespace twum::bench
