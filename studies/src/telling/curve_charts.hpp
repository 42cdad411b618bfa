// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "telling/curve_limits.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/studies/telling.hpp>

#include <string>
#include <vector>

/// Charts of quantities over the speed; internal.
namespace twum::inline v0_1::studies::telling {

/// The columns of a curve, and the stator's loss of motors without modal data, too.
std::vector<CurveColumn> told_columns(const MotorDesign& design);

/// What comes out of a motor over what goes in, as far as its losses are known.
struct EfficiencyKind {
  const char* name;
  const char* quantity;  ///< as metrics at a point are named after it
  const char* in_key;    ///< beside that of the contact
  const char* note;
  double (*value)(const OperatingPoint&);
};

/// The most complete efficiency that all of these motors have: overall with modal data, of contact and stator if only the
/// damping is given, else of the contact.
EfficiencyKind efficiency_kind(std::span<const MotorCurve> curves);
EfficiencyKind efficiency_kind(const MotorDesign& design);

/// The torques of these motors, with limits of the last one.
Chart torque_chart(std::span<const MotorCurve> curves, const std::vector<CurveLimit>& limits = {});

/// Torque, output power and efficiency of one motor, with a point of it marked.
std::vector<Chart> sheet_charts(const MotorCurve& curve, const std::optional<OperatingPoint>& at);

/// A card of the torques, over which a reader points at a speed; nothing without curves.
std::vector<Section> torque_sections(const Phrase& title, const Sources& sources,
                                     const std::vector<CurveLimit>& limits = {});

/// What the motors do besides their torque: powers, efficiency, wear, the terminals, the fields in the contact and the points.
std::vector<Section> curve_sections(const Sources& sources,
                                    const std::vector<CurveLimit>& limits = {});

/// The curves of the study's motor.
std::vector<Section> motor_sections(const Sources& sources);

}  // namespace twum::inline v0_1::studies::telling
