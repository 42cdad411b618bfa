// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/motor.hpp>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace twum::cli {

/// --speed and --torque, of which one says at which point of the curve a motor is looked at.
struct LoadOptions {
  std::string speed;
  std::string torque;

  bool given() const { return !speed.empty() || !torque.empty(); }
};

/// @param least  1 if one of them has to be given, 0 if they may be left out
void add_load_options(CLI::App& command, LoadOptions& options, std::size_t least);

/// The rotor speed asked for, or at which the motor carries the torque asked for [rad/s]; nothing, and why on standard error,
/// if it cannot.
std::optional<double> speed_of(const LoadOptions& options, const Motor& motor);

}  // namespace twum::cli
