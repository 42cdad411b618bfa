// SPDX-License-Identifier: Apache-2.0
#include "design/wear_design.hpp"

namespace twum::inline v0_1 {

Wear& wear_of(MotorDesign& design) { return design.wear ? *design.wear : design.wear.emplace(); }

double lining_part(const Wear& wear) {
  const double lining = wear.specific_wear.value_or(0);
  return lining / (lining + wear.stator_specific_wear);
}

double softness(const MotorDesign& design) {
  const Wear& wear = *design.wear;
  return wear.lining_youngs_modulus ? design.layer.youngs_modulus / *wear.lining_youngs_modulus : 1;
}

double thickness_share(const MotorDesign& design) {
  return softness(design) * lining_part(*design.wear);
}

const char* to_string(WearProfile profile) noexcept {
  return profile == WearProfile::free ? "free" : "even";
}

std::string wear_complaint(const MotorDesign& design) {
  const bool drifts = design.thermal && design.thermal->drift.specific_wear.value_or(0) != 0;
  if (!design.wear)
    return drifts ? "drift_specific_wear must be left out, but the motor has no wear" : "";
  const Wear& wear = *design.wear;
  if (!(wear.specific_wear.value_or(0) + wear.stator_specific_wear > 0))
    return wear.specific_wear
               ? "specific_wear must be more than 0 m^2/N, or stator_specific_wear be, but is 0 "
                 "m^2/N"
               : "specific_wear must be given with wear, or a material of the layer that has one, "
                 "but is missing";
  const bool ends = wear.depth_limit || !wear.until.empty();
  if (!ends) return "wear_depth_limit must be given with wear, or until, but is missing";
  const bool changes = wear.specific_wear.value_or(0) > 0 || wear.preload_spring > 0;
  if (!wear.depth_limit && !changes)
    return "wear_depth_limit must be given where the stator alone wears and no spring relaxes, but "
           "is missing";
  return {};
}

}  // namespace twum::inline v0_1
