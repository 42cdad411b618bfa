// SPDX-License-Identifier: Apache-2.0
#include "formats.hpp"

#include <twum/studies/tables/csv.hpp>
#include <twum/studies/text/number.hpp>

#include <CLI/CLI.hpp>

namespace twum::cli {

void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats) {
  std::string names;
  for (const std::string& format : formats) names += (names.empty() ? "" : "|") + format;
  command.add_option("--format", options.format, "How to write the result (default: table)")
      ->check(CLI::IsMember(formats))
      ->type_name(names);
  command.add_option("-o,--output", options.path, "Write the result to this file")
      ->type_name("FILE");
}

std::string cell_of(double value) { return studies::number_text(value); }

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != cells.data()) line += ',';
    studies::append_cell(line, cell);
  }
  return line + "\n";
}

}  // namespace twum::cli
