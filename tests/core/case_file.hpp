// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/test_motors.hpp"

#include <twum/core/parameters.hpp>

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace twum::test {

struct IdentityCase {
  std::string motor;
  MotorDesign design;
  std::vector<double> speeds;  ///< [rad/s]
};

/// The cases of tests/core/identity_cases.yaml.
inline std::vector<IdentityCase> read_identity_cases(const std::string& path) {
  std::vector<IdentityCase> cases;
  for (const YAML::Node& node : YAML::LoadFile(path)) {
    IdentityCase entry{node["motor"].as<std::string>(), ring_motor(), {}};
    std::vector<ParameterValue> values;
    double load = 0;
    for (const auto& item : node["set"]) {
      const auto name = item.first.as<std::string>();
      const auto value = item.second.as<double>();
      if (name == "load") {
        load = value;
      } else if (const auto parameter = find_parameter(name)) {
        values.emplace_back(*parameter, value);
      } else {
        throw std::runtime_error("no parameter " + name);
      }
    }
    entry.design = with(entry.design, values);
    if (load > 0) entry.design.preload = load * full_contact_load(entry.design);
    const double unit = crest_speed_of(entry.design);
    for (const double speed : node["speeds"].as<std::vector<double>>())
      entry.speeds.push_back(speed * unit);
    cases.push_back(std::move(entry));
  }
  return cases;
}

}  // namespace twum::test
