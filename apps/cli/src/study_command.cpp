// SPDX-License-Identifier: Apache-2.0
#include "study_command.hpp"

#include "exit_status.hpp"
#include "formats.hpp"
#include "interrupt.hpp"
#include "notes.hpp"
#include "output.hpp"
#include "plot/study/told_pictures.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/run_options.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <string_view>
#include <utility>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

std::string text_of(const studies::StudyResult& result, const std::string& format) {
  if (format == "json") return studies::summary_json(result);
  if (format == "csv") return studies::results_csv(result);
  return studies::summary_text(result);
}

// The entries of the study have the names of the options.
studies::StudyResult result_of(const studies::StudyFile& file, const studies::RunOptions& run) {
  try {
    return studies::run_study(file, run);
  } catch (const InputError& error) {
    const std::string_view text = error.what(), entry = "study.";
    if (!text.starts_with(entry)) throw;
    throw InputError("--" + std::string(text.substr(entry.size())));
  }
}

}  // namespace

void add_study_options(CLI::App& command, StudyCommand& options) {
  add_motor_options(command, options.motor);
  add_output_options(command, options.output, {"table", "csv", "json"});
  add_plot_option(command, options.plot);
}

int run_study_command(const StudyCommand& options, studies::Study asked) {
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const StopOnInterrupt stop;
  studies::RunOptions run;
  run.stop = stop.token();
  studies::StudyFile file;
  file.motor = load_motor(options.motor);
  file.path = options.motor.path;
  file.asked = std::move(asked);
  const studies::StudyResult result = result_of(file, run);
  if (result.outcome == studies::StudyOutcome::interrupted) return kInterrupted;
  const std::vector<Picture> pictures = plot && result.outcome == studies::StudyOutcome::done
                                            ? told_pictures({file, result, *result.rows})
                                            : std::vector<Picture>{};
  if (!pictures.empty()) plot->draw(pictures.front().size, pictures.front().script);
  output.write(text_of(result, options.output.format));
  output.finish();
  print_model_notes(file.motor.design);
  return result.outcome == studies::StudyOutcome::done ? kDone : kNoAnswer;
}

}  // namespace twum::inline v0_1::cli
