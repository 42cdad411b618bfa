// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact.hpp"

#include <twum/motion/plant_table.hpp>

#include <string>

namespace twum::inline v0_1::motion {

/// The contact at the nodes of a plant's table, each solved when it is asked for.
class PlantNodes {
 public:
  /// @throws InputError for a design or a size of which there is no table, as tabulate()
  PlantNodes(const MotorDesign& design, const PlantTableOptions& options);
  PlantNodes(const PlantNodes&) = delete;  // contact_ points to model_
  PlantNodes& operator=(const PlantNodes&) = delete;

  /// All numbers of the table and its axes, without values of the contact.
  const PlantTable& frame() const { return frame_; }

  /// @param amplitude    number of the node along amplitudes
  /// @param speed_ratio  number of the node along speed_ratios
  /// @param side         1 for a rotor that turns as the wave drives it, else -1
  ContactForces at(std::size_t amplitude, std::size_t speed_ratio, double side);

  /// Size of the rotor's speed at a node [rad/s].
  double speed(std::size_t amplitude, std::size_t speed_ratio) const;

  /// Why the last contact without an answer has none.
  const std::string& failure() const { return contact_.failure(); }

 private:
  MotionModel model_;
  Contact contact_;
  PlantTable frame_;
};

}  // namespace twum::inline v0_1::motion
