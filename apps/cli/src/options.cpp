// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>

namespace twum::inline v0_1::cli {
namespace {

constexpr std::array kBranches{Branch::running, Branch::dead};

double parse_option(const std::string& option, std::string_view text,
                    const studies::Expected& expected) {
  try {
    return studies::parse_quantity(text, expected);
  } catch (const studies::ValueError& error) {
    throw InputError(option + ": " + error.what());
  }
}

}  // namespace

void add_set_option(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "Override a motor parameter, as in --set \"preload=140 N\" (repeatable)")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
}

void add_motor_options(CLI::App& command, MotorOptions& options) {
  command.add_option("MOTOR", options.path, "Motor file ('-': standard input)")
      ->required()
      ->type_name("FILE");
  add_set_option(command, options.settings);
}

void add_branch_option(CLI::App& command, MotorOptions& options) {
  command
      .add_option(
          "--branch", options.branch,
          "Which stable wave of a motor under a voltage: the large one of a running motor, or "
          "the small one that does not turn the rotor")
      ->check(one_of(words_of(kBranches)))
      ->type_name(choices(words_of(kBranches)));
}

studies::MotorFile load_motor(const MotorOptions& options) {
  studies::MotorFile motor = studies::read_motor_file(options.path);
  motor.design = studies::with_settings(motor.design, options.settings);
  if (options.branch.empty()) return motor;
  if (!motor.design.stator.voltage)
    throw InputError(
        "--branch: the amplitude of this motor is given; only a voltage leaves a choice "
        "of waves");
  motor.design.stator.branch = value_of(options.branch, kBranches);
  return motor;
}

std::string choices(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
  return text;
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](const std::string& text) -> std::string {
    const std::vector<std::string_view> known(words.begin(), words.end());
    if (std::find(known.begin(), known.end(), text) != known.end()) return {};
    return studies::quoted(text) + " is not known here; " + studies::did_you_mean(text, known);
  };
  return {check, "", "one_of"};  // the help shows the words as the type of the option
}

std::size_t parse_count(const std::string& option, const std::string& text, std::size_t least,
                        std::size_t most) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most) {
    throw InputError(option + ": " + studies::quoted(text) +
                     " is not valid; expected a whole number from " + std::to_string(least) +
                     " to " + std::to_string(most));
  }
  return value;
}

double parse_speed(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"rad/s", "100 rpm"});
}

double parse_torque(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"N.m", "0.5 N.m"});
}

double parse_frequency(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"Hz", "40 kHz"});
}

double parse_time(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"s", "10 min"});
}

double parse_voltage(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"V", "120 V"});
}

double parse_inertia(const std::string& option, std::string_view text) {
  return parse_option(option, text, {"kg.m^2", "1e-4 kg.m^2"});
}

double more_than_zero(const std::string& option, double value, const std::string& text) {
  if (value > 0) return value;
  throw InputError(option + ": " + studies::quoted(text) + "; expected more than 0");
}

}  // namespace twum::inline v0_1::cli
