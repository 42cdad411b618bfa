// SPDX-License-Identifier: Apache-2.0
#include "metrics/direction_slopes.hpp"

#include "design/parameter_slopes.hpp"
#include "design/plate_numbers.hpp"

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

constexpr int kNoDirection = -1;

// Directions of the parameters that have one.
constexpr auto kDirectionOf = [] {
  std::array<int, kParameterCount> directions{};
  directions.fill(kNoDirection);
  for (const P p : kModelParameters) directions[index_of(p)] = static_cast<int>(model_index(p));
  for (const P p : kDriveParameters) directions[index_of(p)] = drive_direction(p);
  return directions;
}();

// @param plate_mode  the radial shape is that of a plate's mode: exponent and root have no direction
int direction_of(std::size_t parameter, bool plate_mode) {
  const int direction = kDirectionOf[parameter];
  const bool shape = direction >= static_cast<int>(kShapeIndex) && direction < kDirections;
  return shape && plate_mode ? kNoDirection : direction;
}

}  // namespace

std::vector<DirectionSlope> direction_slopes(const MotorDesign& design,
                                             bool fixed_static_friction) {
  const bool plate_mode = design.stator.geometry.has_value();
  std::vector<DirectionSlope> list;
  for (const ParameterSlope& s : parameter_slopes(design, fixed_static_friction))
    if (const int direction = direction_of(s.value, plate_mode); direction >= 0)
      list.push_back({direction, s.moved, s.slope});
  if (!plate_mode) return list;
  const auto plate = plate_jacobian(design);
  const auto add = [&](const std::array<double, kParameterCount>& row, std::size_t direction) {
    for (std::size_t j = 0; j < kParameterCount; ++j)
      if (row[j] != 0) list.push_back({static_cast<int>(direction), j, row[j]});
  };
  for (std::size_t i = 0; i < kShapeNumbers; ++i)
    add(plate[index_of(PlateNumber::shape) + i], kShapeIndex + i);
  constexpr PlateNumber kStress = PlateNumber::ceramic_stress;
  add(plate[index_of(kStress)], static_cast<std::size_t>(plate_direction(kStress)));
  constexpr PlateNumber kMass = PlateNumber::stator_mass;
  add(plate[index_of(kMass)], static_cast<std::size_t>(plate_direction(kMass)));
  return list;
}

}  // namespace twum::inline v0_1::core
