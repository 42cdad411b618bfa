// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "message.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/processes.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kRunExamples = R"text(Examples:
  twum run study.yaml                       results in results/study
  twum run study.yaml -o first --jobs 4
  twum run study.yaml --set "preload=140 N" -o first-140N
  twum run study.yaml -o first --fresh      discards the stored results and starts again
  mpirun -n 8 twum run study.yaml           shares the work among processes (a build with MPI)

DIR then holds study.yaml (the study in full), results.db (SQLite: every evaluation), results.csv,
summary.json, report.html, and what was found as motor files: best.yaml, fitted.yaml, or those of a
front in front/, or of motors that fit equally well in optima/. If a study was interrupted, by Ctrl-C or
in any other way, the same command resumes it and ends with the same results.)text";

struct StudyOptions {
  std::string path;
  std::vector<std::string> settings;
  std::string directory;
  std::string jobs;
  bool fresh{false};
};

std::string directory_of(const StudyOptions& options) {
  if (!options.directory.empty()) return options.directory;
  const std::filesystem::path file(options.path);
  const std::string stem = file.stem().string();
  const bool dots =
      stem.find_first_not_of('.') == std::string::npos;  // of "...yaml": a parent directory
  const std::string name = options.path == "-" ? "study" : dots ? file.filename().string() : stem;
  return (std::filesystem::path("results") / name).string();
}

// Whether a search has a design, or a front of designs, that keeps all limits: also one that used up its budget.
std::optional<bool> keeps_all_limits(const studies::StudyResult& result) {
  if (const auto* front = std::get_if<studies::ParetoResult>(&result.answer))
    return result.outcome != studies::StudyOutcome::infeasible && !front->front.empty();
  const auto* best = std::get_if<studies::OptimizeResult>(&result.answer);
  if (best == nullptr) return {};
  return result.outcome != studies::StudyOutcome::infeasible && best->found &&
         studies::keeps_limits(best->best);
}

int status_of(const studies::StudyResult& result) {
  if (result.outcome == studies::StudyOutcome::interrupted) return kInterrupted;
  const bool answered =
      keeps_all_limits(result).value_or(result.outcome == studies::StudyOutcome::done ||
                                        result.outcome == studies::StudyOutcome::fitted);
  return answered ? kDone : kNoAnswer;
}

studies::StudyResult run_with_progress(const studies::StudyFile& file, const std::string& directory,
                                       studies::RunOptions& options) {
  const StopOnInterrupt stop;
  options.stop = stop.token();
  Progress progress;
  note_study_progress(0, 0, false);
  options.progress = [&](const studies::RunProgress& now) {
    note_study_progress(now.done, now.total, now.budget);
    progress.show({now.done, now.fraction(), now.budget, now.stage, now.best});
  };
  return studies::run_study(file, directory, options);
}

// Prints the paths of motor files; of a front only the first, the last and the knee.
void say_motor_files(const studies::StudyResult& result, const std::string& directory) {
  const auto path = [&](const std::string& file) {
    return (std::filesystem::path(directory) / file).string();
  };
  const std::vector<std::string>& files = result.motor_files;
  if (files.empty()) return;
  std::string text = path(files.front());
  if (files.size() > 1) text += " to " + path(files.back());
  if (const auto* front = std::get_if<studies::ParetoResult>(&result.answer);
      front != nullptr && front->has_knee())
    text += ", the knee is " + path(files[front->knee]);
  say(std::string(files.size() == 1 ? "motor file: " : "motor files: ") + text);
}

// Runs the study, alone or as the first of several processes.
int run_first(const StudyOptions& options, studies::RunOptions run) {
  run.fresh = options.fresh;
  const studies::StudyFile file = studies::read_study_file(options.path, options.settings);
  const std::string directory = directory_of(options);
  const std::vector<std::string> notes = studies::study_notes(file);
  for (const std::string& note : notes) say("note: " + note);
  const std::string pace = studies::pace_note(file);
  if (!pace.empty()) say("note: " + pace);
  const studies::StudyResult result = run_with_progress(file, directory, run);
  if (result.was_complete) {
    say("twum: " + directory + " holds this result already; --fresh computes it again");
  }
  Output output("");
  output.say(studies::summary_text(result, notes));
  output.finish();
  say("results: " + directory);
  say_motor_files(result, directory);
  if (result.outcome == studies::StudyOutcome::interrupted)
    say_study_interrupted(result.evaluations);
  return status_of(result);
}

// Runs as one of several processes, of which only the first prints and writes anything.
int run_together(const StudyOptions& options, studies::RunOptions run) {
  if (options.path == "-")
    throw InputError("run: only the first of " + std::to_string(studies::launched_processes()) +
                     " processes could read the study from the standard input; give a file");
  studies::Processes processes;
  if (processes.first()) {
    run.processes = &processes;
    return run_first(options, std::move(run));
  }
  ignore_interrupts();
  processes.serve(options.path, options.settings, run.jobs);
  return kDone;
}

int run_study(const StudyOptions& options) {
  studies::RunOptions run;
  if (!options.jobs.empty())
    run.jobs = static_cast<unsigned>(parse_count("--jobs", options.jobs, 1, 1024));
  if (studies::launched_processes() > 1) return run_together(options, std::move(run));
  return run_first(options, std::move(run));
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand("run", "Runs a study, or resumes it");
  command->add_option("STUDY", options->path, "Study file ('-': standard input)")
      ->required()
      ->type_name("FILE");
  add_set_option(*command, options->settings);
  command
      ->add_option("-o,--output", options->directory,
                   "Directory for the results (default: results/NAME in the current directory, "
                   "with the name of the study file)")
      ->type_name("DIR");
  command
      ->add_option("--jobs", options->jobs,
                   "Threads (default: all processors); the result does not depend on it")
      ->type_name("N");
  command->add_flag("--fresh", options->fresh,
                    "Discard the stored results in the directory and start again");
  command->footer(kRunExamples);
  command->callback([options, &action] { action = [options] { return run_study(*options); }; });
}

}  // namespace twum::inline v0_1::cli
