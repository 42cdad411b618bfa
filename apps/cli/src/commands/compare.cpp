// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "output.hpp"
#include "text_table.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/comparison.hpp>

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

namespace twum::cli {
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

// Differences in per cent of the first value, or in its unit if that is zero.
std::string difference(const ComparisonRow& row, std::size_t i) {
  const double first = row.values.front();
  const double value = row.values[i];
  if (std::isnan(first) || std::isnan(value)) return "";
  if (value == first) return "same";
  const std::string sign = value > first ? "+" : "";
  if (first == 0) return sign + studies::engineering(value, row.unit);
  return sign + studies::rounded_text(100 * (value - first) / std::abs(first), 3) + " %";
}

std::vector<std::string> table_row(const ComparisonRow& row) {
  std::vector<std::string> cells{row.group, row.name};
  const std::size_t count = std::max(row.words.size(), row.values.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool word = !row.words.empty();
    const bool none = word ? row.words[i].empty() : std::isnan(row.values[i]);
    cells.push_back(none   ? "-"
                    : word ? studies::printable(row.words[i])
                           : studies::engineering(row.values[i], row.unit, 6));
    if (i > 0) cells.push_back(word ? "" : difference(row, i));
  }
  return cells;
}

std::string as_table(const Comparison& comparison, std::size_t width) {
  TextTable table{{{"", ""}}, false, 2};
  for (std::size_t i = 0; i < comparison.names.size(); ++i) {
    table.rows.front().push_back(studies::printable(comparison.names[i]));
    if (i > 0) table.rows.front().emplace_back("");
  }
  std::string group;
  for (const ComparisonRow& row : comparison.rows) {
    table.rows.push_back(table_row(row));
    if (row.group == group) table.rows.back().front().clear();
    group = row.group;
  }
  return aligned(table, width);
}

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
  output.write(options.output.format == "json" ? as_json(comparison)
               : options.output.format == "csv"
                   ? as_csv(comparison)
                   : as_table(comparison, options.output.table_width()));
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
  add_output_options(*command, options->output, {"table", "csv", "json"});
  command->footer(kCompareExamples);
  command->callback([options, &action] { action = [options] { return run_compare(*options); }; });
}

}  // namespace twum::cli
