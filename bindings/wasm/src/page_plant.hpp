// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motion/plant/plant.h"
#include "motion/src/plant_nodes.hpp"

#include <array>
#include <string>
#include <vector>

namespace twum::inline v0_1::wasm {

/// A motor in time, by the stepper that an FMU carries. Its table has the nodes of an FMU, each of which is solved when a motion
/// first comes near it: some thousand of 33,000.
class PagePlant {
 public:
  /// At rest, without a wave. @throws InputError for a design without a table
  explicit PagePlant(const MotorDesign& design);
  PagePlant(const PagePlant&) = delete;  // data_ points into it
  PagePlant& operator=(const PagePlant&) = delete;

  /// The longest step [s].
  double longest_step() const;

  /// Follows the motor under the drive of the design. @throws InputError where it cannot go on
  void follow(double load_torque, bool enabled, double duration);

  const PlantState& state() const { return state_; }
  double amplitude() const;  ///< of the wave [m]

 private:
  /// Torque, reactive and active stiffness of one side; not a number where a node is not yet solved.
  using Side = std::array<std::vector<float>, 3>;
  static void before_reading(void* filler, int along, int row, int column);
  void solve_node(Side& side, double sign, std::size_t row, std::size_t column);

  motion::PlantNodes nodes_;
  Side along_, against_;
  PlantData data_;
  PlantInputs inputs_;
  PlantParameters parameters_;
  PlantState state_;
  std::string failure_;  // of the stepper, or of a node without an answer; ends the motion
};

}  // namespace twum::inline v0_1::wasm
