// SPDX-License-Identifier: Apache-2.0
// A plugin of someone else's program: one function, and everything of twum behind it.
#include <twum/twum.hpp>

#if TWUM_VERSION < 100
#error "the version is a number that the preprocessor compares"
#endif

extern "C" [[gnu::visibility("default")]] double best_preload() {
  twum::studies::DesignProblem p{twum::MotorDesign{}};
  p.vary("preload", "10 N", "500 N").minimize("preload").limit("holding_torque >= 0.53 N.m");
  return solve(p).motor.preload;
}
