// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "output.hpp"

#include <twum/studies/comparison.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

using studies::Comparison;
using studies::ComparisonRow;

constexpr const char* kCompareExamples = R"text(Examples:
  twum compare results/by-slsqp results/by-ipopt
  twum compare results/a results/b results/c --format csv -o compared.csv

Differences are those to the first directory.)text";

struct CompareOptions {
  std::vector<std::string> directories;
  OutputOptions output;
};

std::string as_csv(const Comparison& comparison) {
  std::vector<std::string> cells{"group", "name", "unit"};
  cells.insert(cells.end(), comparison.names.begin(), comparison.names.end());
  std::string text = csv_line(cells);
  for (const ComparisonRow& row : comparison.rows) {
    cells = {row.group, row.name, row.unit};
    for (const std::string& word : row.words) cells.push_back(word);
    for (const double value : row.values) cells.push_back(cell_of(value));
    text += csv_line(cells);
  }
  return text;
}

std::string as_json(const Comparison& comparison) {
  Json json{{"results", comparison.names}, {"rows", Json::array()}};
  for (const ComparisonRow& row : comparison.rows) {
    Json values = Json::array();
    for (const std::string& word : row.words)
      values.push_back(word.empty() ? Json(nullptr) : Json(word));
    for (const double value : row.values) values.push_back(number_json(value));
    json["rows"].push_back(
        {{"group", row.group}, {"name", row.name}, {"unit", row.unit}, {"values", values}});
  }
  return json_text(json);
}

int run_compare(const CompareOptions& options) {
  if (options.directories.size() < 2)
    throw InputError("compare: only one directory is given; give two or more");
  const Comparison comparison = studies::compare_results(options.directories);
  Output output(options.output.path);
  const std::string& format = options.output.format;
  output.write(format == "json"  ? as_json(comparison)
               : format == "csv" ? as_csv(comparison)
               : format == "markdown"
                   ? studies::comparison_markdown(comparison)
                   : studies::comparison_text(comparison, options.output.table_width()));
  output.finish();
  return kDone;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Results of two or more studies side by side");
  command->add_option("DIR", options->directories, "Directories that 'twum run' wrote")
      ->required()
      ->type_name("DIR DIR");
  add_output_options(*command, options->output, {"table", "csv", "json", "markdown"});
  command->footer(kCompareExamples);
  command->callback([options, &action] { action = [options] { return run_compare(*options); }; });
}

}  // namespace twum::inline v0_1::cli
