// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/solid_data.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::motors {

/// A motor as its file gives it, in SI.
struct GivenMotor {
  std::string name{};
  std::vector<ParameterValue> values{};
  std::vector<std::pair<double, double>> shape_table{};  ///< radius and R
  std::optional<Branch> branch{};
  std::optional<DriveControl> control{};
  std::optional<std::vector<double>> frequency_range{};  ///< lowest and highest [Hz]
  std::optional<bool> radial_motion{};
  std::optional<EquivalentCircuit> circuit{};
  std::optional<stator::InnerEdge> inner_edge{};  ///< of the geometry
  std::optional<SolidData> solid{};               ///< of the geometry as a solid
  std::vector<LoadPhase> operation{};
  std::vector<WearLimit> until{};
  std::optional<WearProfile> wear_profile{};
  std::optional<double> lining_wear{};  ///< specific wear of the layer's material [m^2/N]
  std::string material{};               ///< of the block that is being read

  std::optional<double> value(Parameter parameter) const {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [=](const auto& one) { return one.first == parameter; });
    return found == values.end() ? std::nullopt : std::optional<double>(found->second);
  }
};

}  // namespace twum::inline v0_1::motors
