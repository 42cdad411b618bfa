// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/motor_rows.hpp"

namespace twum::inline v0_1 {
namespace motion_rows {

using P = Parameter;
using motor_rows::kNoAlternative;

inline bool is_damped(const MotorDesign& d) { return d.rotor.axial_damping != 0; }

/// Rows of the parameter table for motions in time and for the driver. Every motor does without them.
inline constexpr std::array kMotionRows{std::to_array<ParameterRow>({
    {{P::rotor_inertia, "rotor_inertia", "", "kg.m^2", "rotor.inertia", 1e-18, 1e6, false, false,
      kNoAlternative, "7e-6 kg.m^2", "moment of inertia of rotor and shaft",
      "from a silicon disc of 1 mm to a flywheel of 100 t", "none; a motion needs it", false},
     optional_number<&Rotor::inertia>()},
    {{P::load_inertia, "load_inertia", "", "kg.m^2", "load.inertia", 0, 1e6, false, false,
      kNoAlternative, "1e-4 kg.m^2", "moment of inertia of what the shaft drives",
      "0 is a bare rotor; the largest is that of rotor_inertia", "0 kg.m^2", false},
     in_block<&MotorDesign::load, &ShaftLoad::inertia>()},
    {{P::load_damping, "load_damping", "", "N.m.s", "load.damping", 0, 1e6, false, false,
      kNoAlternative, "1e-3 N.m.s", "viscous friction of the load, torque over speed",
      "0 is a load without viscous friction; the largest stops any motor", "0 N.m.s", false},
     in_block<&MotorDesign::load, &ShaftLoad::damping>()},
    {{P::load_friction, "load_friction", "", "N.m", "load.friction", 0, 1e6, false, false,
      kNoAlternative, "0.02 N.m", "Coulomb friction of the load",
      "0 is a load without dry friction; the largest stops any motor", "0 N.m", false},
     in_block<&MotorDesign::load, &ShaftLoad::friction>()},
    {{P::load_stiffness, "load_stiffness", "", "N.m/rad", "load.stiffness", 0, 1e9, false, false,
      kNoAlternative, "0.5 N.m/rad", "spring of the load about load_neutral",
      "0 is a load without spring; the largest is stiffer than any shaft", "0 N.m/rad", false},
     in_block<&MotorDesign::load, &ShaftLoad::stiffness>()},
    {{P::load_neutral, "load_neutral", "", "rad", "load.neutral", -1e4, 1e4, false, false,
      kNoAlternative, "0.3 rad", "angle at which the load's spring is relaxed",
      "no spring allows more than a thousand turns", "0 rad", false},
     in_block<&MotorDesign::load, &ShaftLoad::neutral>()},
    {{P::off_resistance, "off_resistance", "", "ohm", "driver.off_resistance", 0, 1e15, false,
      false, kNoAlternative, "459 ohm", "resistance across each phase while the drive is off",
      "0 is a short circuit; the largest exceeds any insulator", "0 ohm", false},
     in_block<&MotorDesign::driver, &Driver::off_resistance>()},
    {{P::driver_inductance, "driver_inductance", "", "H", "driver.inductance", 0, 10, false, false,
      kNoAlternative, "0.8 mH",
      "inductance in series with each phase; `voltage` is then that of the inverter",
      "0 is an ideal driver; the largest lets less than a milliampere through", "0 H", false},
     in_block<&MotorDesign::driver, &Driver::inductance>()},
    {{P::driver_resistance, "driver_resistance", "", "ohm", "driver.resistance", 0, 1e6, false,
      false, kNoAlternative, "5 ohm",
      "resistance in series with each phase; `voltage` is then that of the inverter",
      "0 is an ideal driver; the largest lets less than a milliampere through", "0 ohm", false},
     in_block<&MotorDesign::driver, &Driver::resistance>()},
    {{P::axial_damping, "axial_damping", "", "N.s/m", "rotor.axial_damping", 0, 1e9, false, false,
      kNoAlternative, "300 N.s/m", "damping of the rotor's axial motion: flange, rubber, lining",
      "0 is a rotor that hops near no-load; the largest stops any axial motion", "0 N.s/m", false},
     plain<&Rotor::axial_damping>().used_if(is_damped)},
})};

}  // namespace motion_rows

using motion_rows::kMotionRows;
}  // namespace twum::inline v0_1
