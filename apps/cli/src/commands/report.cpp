// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "output.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/report.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace twum::cli {
namespace {

constexpr const char* kReportExamples = R"text(Examples:
  twum report results                 builds results/report.html again)text";

int run_report(const std::string& directory) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(directory, ignored))
    throw InputError(directory + ": no such directory; give one that 'twum run' wrote");
  const StopOnInterrupt stop;
  const std::string path = studies::write_report(directory, stop.token());
  Output output("");
  output.say(path + "\n");
  output.finish();
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto directory = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("report", "Writes the report page of a study's results again");
  command->add_option("DIR", *directory, "Directory that 'twum run' wrote")
      ->required()
      ->type_name("DIR");
  command->footer(kReportExamples);
  command->callback(
      [directory, &action] { action = [directory] { return run_report(*directory); }; });
}

}  // namespace twum::cli
