// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <twum/core/contact_gradients.hpp>
#include <twum/core/parameters.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::motion {

/// Derivatives of the numbers of a motion in one parameter of its design: of the model's, and of the drive's.
struct ModelSlope {
  Parameter parameter;
  double scale;  ///< |q|, or 1 of a parameter that is zero: a change of the column by 1
  double mass, damping, stiffness_of_wave, force_factor, capacitance, loss_tangent;
  double voltage, omega;  ///< of the drive, V rms and omega
  double inertia, load_damping, load_friction, stiffness, neutral, off_resistance;
  double series_inductance, series_resistance;
};

/// True for parameters that wave, contact, rotor or load take: not for those of heat and wear.
bool counts_in_motion(Parameter parameter);

/// How a motion under the drive of its design moves with the design: a column for each parameter that may count.
class ModelSlopes {
 public:
  /// @param wanted  the only parameters that have a column; empty: all
  explicit ModelSlopes(const MotorDesign& design, bool fixed_static_friction,
                       std::span<const Parameter> wanted = {});

  const std::vector<ModelSlope>& columns() const { return columns_; }
  const ContactDifferentiator& contact() const { return contact_; }

 private:
  std::vector<ModelSlope> columns_;
  ContactDifferentiator contact_;
};

}  // namespace twum::inline v0_1::motion
