// SPDX-License-Identifier: Apache-2.0
#include "telling/heat_parts.hpp"

#include "telling/load_parts.hpp"

namespace twum::inline v0_1::studies::telling {

std::size_t parts_of(const HeatResult::Member& motor) {
  return motor.network.one_node ? 1 : kHeated.size();
}

std::string part_name(const HeatResult::Member& motor, std::size_t i) {
  return motor.network.one_node ? "motor" : kHeated[i].name;
}

std::optional<double> limit_of(const HeatResult::Member& motor, std::size_t i) {
  if (!motor.network.one_node) return motor.limits[i];
  std::optional<double> lowest;
  for (const auto& limit : motor.limits)
    if (limit && (!lowest || *limit < *lowest)) lowest = limit;
  return lowest;
}

Nearest nearest_limit(const HeatResult::Member& motor, const PartTemperatures& temperatures) {
  Nearest nearest;
  for (std::size_t i = 0; i < parts_of(motor); ++i)
    if (const auto limit = limit_of(motor, i)) {
      const double margin = *limit - at(temperatures, kHeated[i].part);
      if (margin < nearest.margin) nearest = {i, margin};
    }
  return nearest;
}

bool is_steady(const HeatResult::Member& motor) {
  return motor.steady && motor.steady->status == "ok";
}

bool has_cycle(const HeatResult::Member& motor) {
  return motor.cycle && motor.cycle->status == "ok";
}

Phrase heated_phrase(const HeatResult& answer, const HeatResult::Member& motor) {
  return family_phrase(answer.family, motor.value);
}

}  // namespace twum::inline v0_1::studies::telling
