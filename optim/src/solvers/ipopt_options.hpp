// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solvers/optimizer.hpp"

#include <utility>

namespace Ipopt {
class OptionsList;
}

namespace twum::inline v0_1::optim {

/// Checked options for Ipopt: texts, numbers and integers.
struct IpoptSettings {
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<std::pair<std::string, int>> integers;
};

/// @throws InputError for a value of the wrong type or outside its range
IpoptSettings check_ipopt_settings(const RunSettings& settings);

/// @throws Error if Ipopt refuses one of them, which would be a bug in the table
void apply_ipopt_settings(const IpoptSettings& settings, Ipopt::OptionsList& options);

}  // namespace twum::inline v0_1::optim
