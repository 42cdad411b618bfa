// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/thermal_rows.hpp"
#include "design/wear_design.hpp"

namespace twum::inline v0_1 {
namespace wear_rows {

using P = Parameter;
using thermal_rows::kNoAlternative;

/// A number of the wear block; none without it.
template <auto... path>
constexpr ParameterPlace of_wear() {
  return {
      [](const MotorDesign& d) { return thermal_rows::number_at<&MotorDesign::wear, path...>(d); },
      nullptr,
      [](MotorDesign& d, double value) {
        thermal_rows::set_at<path...>(wear_of(d), value);
        return true;
      }};
}

/// Rows of the parameter table for wear. Every motor does without them.
inline constexpr std::array kWearRows{std::to_array<ParameterRow>({
    {{P::specific_wear, "specific_wear", "", "m^2/N", "wear.specific_wear", 0, 1e-6, false, false,
      kNoAlternative, "1e-6 mm^3/(N.m)",
      "worn volume of the lining per normal force and sliding distance",
      "0 is a lining that does not wear; even chalk has a thousandth of the largest value",
      "that of the lining's material", false},
     of_wear<&Wear::specific_wear>()},
    {{P::stator_specific_wear, "stator_specific_wear", "", "m^2/N", "wear.stator_specific_wear", 0,
      1e-6, false, false, kNoAlternative, "1e-8 mm^3/(N.m)",
      "worn volume of the stator per normal force and sliding distance", "as specific_wear",
      "0 m^2/N", false},
     of_wear<&Wear::stator_specific_wear>()},
    {{P::wear_depth_limit, "wear_depth_limit", "", "m", "wear.depth_limit", 1e-12, 1, false, false,
      kNoAlternative, "100 um", "largest worn depth of both bodies together",
      "from less than the size of an atom to thicker than any lining",
      "none; a life needs it or wear.until", false},
     of_wear<&Wear::depth_limit>()},
    {{P::preload_spring, "preload_spring", "", "N/m", "wear.preload_spring", 0, 1e15, false, false,
      kNoAlternative, "100 N/mm", "stiffness of the spring that gives the preload",
      "0 is a constant force, such as a weight; the largest is stiffer than any frame", "0 N/m",
      false},
     of_wear<&Wear::preload_spring>()},
    {{P::lining_youngs_modulus, "lining_youngs_modulus", "", "Pa", "wear.lining_youngs_modulus",
      1e3, 1e13, false, false, kNoAlternative, "3 GPa",
      "Young's modulus of the lining alone, if that of the layer includes a flange",
      "from soft gels, 1 kPa, to ten times diamond", "that of the layer", false},
     of_wear<&Wear::lining_youngs_modulus>()},
})};

}  // namespace wear_rows

using wear_rows::kWearRows;
}  // namespace twum::inline v0_1
