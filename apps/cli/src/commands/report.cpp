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

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kReportExamples = R"text(Examples:
  twum report results                    builds results/report.html again
  twum report results --format md        prints the answer as Markdown, to paste into a report
  twum report results --format md -o answer.md)text";

struct ReportOptions {
  std::string directory;
  std::string format{"html"};
  std::string path;
};

int run_report(const ReportOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(options.directory, ignored))
    throw InputError(options.directory + ": no such directory; give one that 'twum run' wrote");
  if (options.format == "html" && !options.path.empty())
    throw InputError("-o: the page is DIR/report.html; -o belongs to --format md");
  const StopOnInterrupt stop;
  const std::string text = options.format == "md"
                               ? studies::report_markdown(options.directory, stop.token())
                               : studies::write_report(options.directory, stop.token()) + "\n";
  Output output(options.path);
  output.say(text);
  output.finish();
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand(
      "report", "Writes the report of a study's results again: the page, or Markdown");
  command->add_option("DIR", options->directory, "Directory that 'twum run' wrote")
      ->required()
      ->type_name("DIR");
  command->add_option("--format", options->format, "html: the page DIR/report.html; md: Markdown")
      ->check(CLI::IsMember({"html", "md"}))
      ->type_name("FORMAT");
  command->add_option("-o,--output", options->path, "File of the Markdown (default: the terminal)")
      ->type_name("FILE");
  command->footer(kReportExamples);
  command->callback([options, &action] { action = [options] { return run_report(*options); }; });
}

}  // namespace twum::inline v0_1::cli
