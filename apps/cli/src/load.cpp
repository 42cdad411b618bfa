// SPDX-License-Identifier: Apache-2.0
#include "load.hpp"

#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"

#include <twum/core/metrics.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace twum::inline v0_1::cli {

void add_load_options(CLI::App& command, LoadOptions& options, std::size_t least) {
  const CLI::Option* speed =
      command.add_option("--speed", options.speed, "Rotor speed, such as \"100 rpm\"")
          ->type_name("SPEED");
  const CLI::Option* torque =
      command
          .add_option("--torque", options.torque,
                      "Load torque, such as \"0.5 N.m\", in place of --speed")
          ->type_name("TORQUE");
  command.parse_complete_callback([speed, torque, least] {
    const std::size_t given = speed->count() + torque->count();
    if (given > 1)
      throw CLI::ValidationError("--speed and --torque exclude each other", "give one of the two");
    if (given < least) throw CLI::RequiredError("--speed or --torque");
  });
}

void add_held_load_options(CLI::App& command, LoadOptions& options) {
  command
      .add_option("--torque", options.torque,
                  "Load torque (default: none; the motor's operation alone)")
      ->type_name("TORQUE");
  command
      .add_option("--speed", options.speed,
                  "Rotor speed; with a torque, the drive is adjusted to hold both as the motor "
                  "warms or wears")
      ->type_name("SPEED");
}

std::optional<double> speed_of(const LoadOptions& options, const Motor& motor) {
  if (options.torque.empty()) return parse_speed("--speed", options.speed);
  const double torque = parse_torque("--torque", options.torque);
  const MetricValue speed = evaluate(motor, {Metric::speed_at, Argument::torque, torque});
  if (speed.status == MetricStatus::ok) return speed.value;
  say("twum: no answer at this torque: " + std::string(to_string(speed.status)));
  explain_reasons({to_string(speed.status)});
  return {};
}

}  // namespace twum::inline v0_1::cli
