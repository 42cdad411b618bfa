// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/settings.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kCheckExamples = R"text(Examples:
  twum check ring-60.yaml
  twum check study.yaml              with the files that the study names
  twum check ring-60.yaml --set "thickness=0.2 mm"

A valid file may still describe an unusual motor. Lines that begin with "note:" name values outside
the range in which the solver is tested, and assumptions of the model that do not hold.)text";

// A valid file: its description, its motor, and what is still missing.
struct Checked {
  std::string words;
  MotorDesign motor;
  std::string missing;
  std::vector<std::string> notes{};
};

// A study may be written before its points are measured. Other errors in the path are reported by its reader.
std::string missing_data(const studies::StudyFile& study) {
  const auto* asked = std::get_if<studies::CalibrateStudy>(&study.asked);
  if (asked == nullptr) return "";
  for (const std::string& name : asked->data) {
    const std::filesystem::path path = std::filesystem::path(study.folder) / name;
    std::error_code error;
    if (std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found)
      return path.string();
  }
  return "";
}

// Throws the errors of the file. Reads it once, because standard input cannot be read again.
Checked checked(const MotorOptions& options) {
  const studies::Source source = studies::read_source(options.path);
  if (studies::is_study(source)) {
    const std::string folder =
        options.path == "-" ? "" : std::filesystem::path(options.path).parent_path().string();
    const studies::StudyFile study = studies::read_study(source, folder, options.settings);
    const std::string missing = missing_data(study);
    return {"a valid study file (" + std::string(studies::to_string(study.kind())) + ")",
            study.motor.design, missing,
            missing.empty() ? studies::study_notes(study) : std::vector<std::string>()};
  }
  return {"a valid motor file",
          studies::with_settings(studies::read_motor(source).design, options.settings), ""};
}

int run_check(const MotorOptions& options) {
  const Checked found = checked(options);
  const Motor motor(found.motor);
  Output output("");
  output.say(options.path + ": " + found.words + "\n");
  output.finish();
  if (!found.missing.empty())
    say("note: " + found.missing + ": does not exist yet; 'twum run' needs it");
  for (const std::string& note : found.notes) say("note: " + note);
  print_model_notes(found.motor, found.notes);
  return kDone;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MotorOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Checks a file and reports every error, without running it");
  command->add_option("FILE", options->path, "File to check ('-': standard input)")
      ->required()
      ->type_name("FILE");
  add_set_option(*command, options->settings);
  command->footer(kCheckExamples);
  command->callback([options, &action] { action = [options] { return run_check(*options); }; });
}

}  // namespace twum::inline v0_1::cli
