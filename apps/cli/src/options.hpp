// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/motor_file.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace twum::inline v0_1::cli {

/// MOTOR and --set, common to many commands, and --branch of the commands that show one wave.
struct MotorOptions {
  std::string path;
  std::vector<std::string> settings;
  std::string branch;  // empty: that of the file
};

void add_motor_options(CLI::App& command, MotorOptions& options);
void add_branch_option(CLI::App& command, MotorOptions& options);
void add_set_option(CLI::App& command, std::vector<std::string>& settings);

/// The motor file with the settings and the branch applied.
/// @throws InputError also for a branch of a motor without a voltage
studies::MotorFile load_motor(const MotorOptions& options);

/// "up|down|both": words as the type of an option in the help.
std::string choices(const std::vector<std::string>& words);

/// The words of some values of an enumeration, and the value of one of these words: the first one, if an option was not given.
/// @{
template <typename E, std::size_t N>
std::vector<std::string> words_of(const std::array<E, N>& values) {
  std::vector<std::string> words;
  for (const E value : values) words.emplace_back(to_string(value));
  return words;
}
template <typename E, std::size_t N>
E value_of(const std::string& word, const std::array<E, N>& values) {
  const auto found = std::ranges::find(values, word, [](E value) { return to_string(value); });
  return found == values.end() ? values.front() : *found;
}
/// @}

/// A check that accepts only some words; its message names the word that was probably meant, or all of them.
CLI::Validator one_of(const std::vector<std::string>& words);

/// A whole number given to an option.
/// @throws InputError naming the option and the range.
std::size_t parse_count(const std::string& option, const std::string& text, std::size_t least,
                        std::size_t most);

/// A speed given to an option [rad/s], a torque [N m], a frequency [Hz], a time [s], a voltage [V], a moment of inertia [kg m^2].
/// @{
double parse_speed(const std::string& option, std::string_view text);
double parse_torque(const std::string& option, std::string_view text);
double parse_frequency(const std::string& option, std::string_view text);
double parse_time(const std::string& option, std::string_view text);
double parse_voltage(const std::string& option, std::string_view text);
double parse_inertia(const std::string& option, std::string_view text);
/// @}

/// A value given to an option that has to be more than 0. @throws InputError with the option and its text
double more_than_zero(const std::string& option, double value, const std::string& text);

}  // namespace twum::inline v0_1::cli
