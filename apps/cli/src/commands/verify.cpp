// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/verify_study.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

using studies::counted;

constexpr const char* kVerifyExamples = R"text(Examples:
  twum verify results/optimize
  twum verify results/sweep --samples 100000 --seed 7

Computes again: rows of results.db drawn at random, the designs of summary.json, their
certificates, and the answer as it follows from the rows; and compares summary.json, results.csv and
the motor files with them, and study.yaml with its hash (not report.html: 'twum report' writes it
again). Exit status 0: every number agrees to 1e-12 of itself; 1: something differs; 3: the results
cannot be read.)text";

struct VerifyCommand {
  std::string directory;
  std::string samples;
  std::string seed;
};

std::string report(const studies::Verification& found) {
  std::string text =
      found.study + " (" + found.kind + "): " + (found.holds() ? "holds" : "does NOT hold") + "\n";
  text += "  " + std::to_string(found.rows_checked) + " of " + counted(found.rows, "stored row") +
          " evaluated again\n";
  if (found.rows_skipped > 0)
    text += "  " + counted(found.rows_skipped, "row") + " cannot be evaluated without other rows\n";
  text += "  " + counted(found.designs, "design") + " of the summary evaluated again\n";
  if (found.certificates > 0)
    text += "  " + counted(found.certificates, "certificate") + " measured again\n";
  text += found.answer_checked ? "  the answer was derived again from the rows\n"
                               : "  interrupted: the answer was not derived again\n";
  text += found.deviation == 0 ? "  confirmed numbers are bitwise equal\n"
                               : "  confirmed numbers are equal to within " +
                                     studies::rounded_text(found.deviation, 2) + " of their size\n";
  for (const std::string& complaint : found.complaints) text += complaint + "\n";
  if (found.failed > found.complaints.size())
    text += "and " + std::to_string(found.failed - found.complaints.size()) + " more\n";
  return text;
}

int run_verify(const VerifyCommand& command) {
  studies::VerifyOptions options;
  if (!command.samples.empty())
    options.samples = parse_count("--samples", command.samples, 0, 1000000000);
  if (!command.seed.empty())
    options.seed = parse_count("--seed", command.seed, 0, 9007199254740992);
  const StopOnInterrupt stop;
  options.stop = stop.token();
  const studies::Verification found = studies::verify_study(command.directory, options);
  Output output("");
  output.say(report(found));
  output.finish();
  return found.holds() ? kDone : kNoAnswer;
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  const auto options = std::make_shared<VerifyCommand>();
  CLI::App* command =
      app.add_subcommand("verify", "Computes a study's results again and reports differences");
  command->add_option("DIR", options->directory, "Directory that 'twum run' wrote")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--samples", options->samples,
                   "Stored evaluations to repeat, drawn at random (default: 1000)")
      ->type_name("N");
  command->add_option("--seed", options->seed, "Seed of the draw (default: 1)")->type_name("N");
  command->footer(kVerifyExamples);
  command->callback([options, &action] { action = [options] { return run_verify(*options); }; });
}

}  // namespace twum::inline v0_1::cli
