// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace twum::inline v0_1::cli {

/// --speed and --torque: one of them, or both, select the operating point of a motor.
struct LoadOptions {
  std::string speed;
  std::string torque;

  bool given() const { return !speed.empty() || !torque.empty(); }
};

/// @param least  1 if one of them has to be given, 0 if they may be left out
void add_load_options(CLI::App& command, LoadOptions& options, std::size_t least);

/// The same for a load of which both may be given: the drive then holds the torque at the speed.
void add_held_load_options(CLI::App& command, LoadOptions& options);

/// The given rotor speed, or the speed at which the motor carries the given torque [rad/s]. If it cannot, prints the
/// reason on standard error and returns nothing.
std::optional<double> speed_of(const LoadOptions& options, const Motor& motor);

}  // namespace twum::inline v0_1::cli
