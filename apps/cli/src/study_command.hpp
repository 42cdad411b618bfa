// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "formats.hpp"
#include "load.hpp"
#include "options.hpp"

#include <twum/studies/study.hpp>

#include <string>

namespace twum::inline v0_1::cli {

/// A command that asks what a kind of study asks, of one motor: runs it without a directory, writes the answer, and draws its
/// first picture.
struct StudyCommand {
  MotorOptions motor;
  OutputOptions output;
  std::string plot;  ///< file of the picture; empty: none
};

/// Adds its options; the answer is a table, CSV or JSON.
void add_study_options(CLI::App& command, StudyCommand& options);

/// Sets torque and speed of a study that may have both. @throws InputError for a torque that is held at rest
template <typename Study>
void set_load(Study& asked, const LoadOptions& options) {
  if (!options.torque.empty()) asked.torque = parse_torque("--torque", options.torque);
  if (!options.speed.empty()) asked.speed = parse_speed("--speed", options.speed);
  if (asked.torque && asked.speed) more_than_zero("--speed", *asked.speed, options.speed);
}

/// @param asked   entries of the study, which have the names of the options
/// @return the exit status
int run_study_command(const StudyCommand& options, studies::Study asked);

}  // namespace twum::inline v0_1::cli
