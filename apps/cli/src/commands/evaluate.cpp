// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "interrupt.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"

#include <twum/base/ordered.hpp>
#include <twum/io/plain_table.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/design_table.hpp>
#include <twum/motors/expression.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kEvaluateExamples = R"text(Examples:
  twum evaluate ring-60.yaml --metrics "stall_torque, peak_power / preload"
  twum evaluate ring-60.yaml --designs designs.csv
  twum evaluate ring-60.yaml --designs designs.csv -o results.csv \
      --metrics "stall_torque, no_load_speed, wear_intensity_at(80 rpm)" --jobs 4

The table's columns are parameter names with an optional unit, such as "preload [N]";
other columns are copied. Tables of spreadsheets are read, too: semicolons, decimal commas,
tabs, UTF-16. A design that fails gets empty cells and a reason in "status".
Without a table the motor itself is evaluated. Metrics may stand in expressions:
numbers with units, + - * / ^, parentheses, sqrt abs exp log min max.)text";

struct EvaluateOptions {
  MotorOptions motor;
  std::string designs;
  std::string metrics;
  std::string jobs;
  std::string output;
};

struct CloseFile {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

File open_designs(const std::string& path) {
  std::error_code ignored;
  if (path == "-") return File(stdin);
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": cannot be read: it is a directory");
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError(path + ": cannot be read: " + std::strerror(errno));
  return file;
}

std::vector<studies::MetricExpression> metrics_of(const EvaluateOptions& options) {
  if (options.metrics.empty()) return {};
  try {
    return studies::parse_metric_list(options.metrics);
  } catch (const studies::ValueError& error) {
    const std::string caret = std::string(error.position(), ' ') + "^";
    throw InputError(std::string("--metrics: ") + error.what() + "\n  " +
                     studies::printable(options.metrics, 1000) + "\n  " + caret);
  }
}

bool needs_stator_loss(Metric metric) {
  return metric == Metric::max_efficiency || metric == Metric::speed_at_max_efficiency;
}

// All plain metrics that have a value for usual designs: efficiency needs a modal damping, and few motors pull out above rest.
std::vector<studies::MetricExpression> usual_metrics(const MotorDesign& base,
                                                     const std::string& header) {
  std::vector<studies::MetricExpression> metrics = studies::plain_metrics(base);
  const bool damped = modal_damping(base) > 0 || header.find("modal_damping") != std::string::npos;
  std::erase_if(metrics, [&](const studies::MetricExpression& one) {
    const Metric metric = one.request()->metric;
    return metric == Metric::pull_out_torque || (!damped && needs_stator_loss(metric));
  });
  return metrics;
}

// The motor without a table of designs: one row of metrics and a status, under their names.
int run_alone(const EvaluateOptions& options, std::vector<studies::MetricExpression> metrics) {
  Output output(options.output, {options.motor.path});
  const MotorDesign design = load_motor(options.motor).design;
  if (metrics.empty()) metrics = usual_metrics(design, {});
  const std::vector<MetricValue> values =
      studies::ExpressionEvaluator(metrics).evaluate(Motor(design));
  const std::string reason = studies::without_number(metrics, values);
  std::vector<std::string> names;
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    names.push_back(metrics[i].text + " [" + metrics[i].unit() + "]");
    cells.push_back(cell_of(values[i].value));
  }
  names.emplace_back("status");
  cells.push_back(reason.empty() ? "ok" : reason);
  output.write(csv_line(names) + csv_line(cells));
  output.finish();
  print_model_notes(design);
  return studies::any_answer(metrics, values) ? kDone : kNoAnswer;
}

double fraction_read(std::size_t bytes, double size) {
  return size > 0 ? static_cast<double>(bytes) / size : 0;
}

int run_evaluate(const EvaluateOptions& options) {
  const unsigned jobs = job_count(
      options.jobs.empty() ? 0
                           : static_cast<unsigned>(parse_count("--jobs", options.jobs, 1, 1024)));
  if (!options.output.empty()) require_ending(options.output, {"csv"});
  if (options.designs.empty()) return run_alone(options, metrics_of(options));
  Output output(options.output, {options.motor.path, options.designs});
  std::vector<studies::MetricExpression> metrics = metrics_of(options);
  const MotorDesign base = load_motor(options.motor).design;
  const File file = open_designs(options.designs);
  std::error_code no_size;
  const auto size = static_cast<double>(std::filesystem::is_regular_file(options.designs, no_size)
                                            ? std::filesystem::file_size(options.designs, no_size)
                                            : 0);

  const std::string name = options.designs == "-" ? "standard input" : options.designs;
  auto [bytes, kind] = studies::plain_stream(name, studies::bytes_of(file.get(), options.designs),
                                             studies::is_parameter_heading);
  if (!kind.empty()) say(name + ": read as: " + kind);
  studies::CsvReader reader(name, std::move(bytes));
  studies::CsvChunk header;
  if (!reader.read(header, 1))
    throw InputError(reader.name() + ":1: no header; expected columns such as 'preload [N]'");
  if (metrics.empty()) metrics = usual_metrics(base, header.text);
  const studies::DesignTable table(reader, header, base, std::move(metrics));
  for (const std::string& warning : table.warnings()) {
    say(reader.name() + ":" + std::to_string(header.records[0].line) + ": warning: " + warning);
  }

  studies::DesignCounts counts;
  {
    Progress progress;
    counts = studies::evaluate_table(
        reader, table, jobs, [&](std::string_view text) { output.write(text); },
        [] { return !interrupted(); },
        [&](const studies::DesignCounts& now) {
          progress.show({now.rows, fraction_read(now.bytes, size)});
        });
  }
  output.finish();
  if (counts.rows == 0) say("twum: " + reader.name() + " has no designs below its header");
  if (counts.failed > 0) {
    say("twum: " + std::to_string(counts.failed) + " of " + std::to_string(counts.rows) +
        " designs failed or are incomplete; see the column 'status'");
  }
  for (const std::string& note : counts.notes) say("note: " + note);
  if (!interrupted()) return counts.empty == counts.rows ? kNoAnswer : kDone;
  say("twum: interrupted after " + std::to_string(counts.rows) + " designs");
  return kInterrupted;
}

}  // namespace

void add_evaluate(CLI::App& app, Action& action) {
  const auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = app.add_subcommand("evaluate", "Metrics of every design in a CSV table");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  command
      ->add_option("--designs", options->designs,
                   "CSV table with one design in each row ('-': standard input); without it, the "
                   "motor itself")
      ->type_name("FILE");
  command
      ->add_option("--metrics", options->metrics,
                   "Metrics or expressions, separated by commas (default: all metrics without "
                   "argument)")
      ->type_name("METRICS");
  command
      ->add_option("--jobs", options->jobs,
                   "Threads (default: all processors); the result does not depend on it")
      ->type_name("N");
  command->add_option("-o,--output", options->output, "Write the result to this file")
      ->type_name("FILE");
  command->footer(kEvaluateExamples);
  command->callback([options, &action] { action = [options] { return run_evaluate(*options); }; });
}

}  // namespace twum::inline v0_1::cli
