// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/units/engineering.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace twum::cli {

/// How a result is written and where to.
struct OutputOptions {
  std::string format{"table"};
  std::string path;

  /// Columns that a table may have: those of the terminal that it goes to; 0, without limit, in files and pipes.
  std::size_t table_width() const;
};

/// Adds --format and -o. Without --format a file named .csv, .json or .md gets what its name says.
void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats);

/// A number for a CSV cell; empty if it is not a number.
std::string cell_of(double value);

/// How a column of a terminal's table shows its numbers.
struct ColumnScale {
  studies::DisplayUnit unit;
  double largest{0};  ///< SI; what is a thousand millionth of it is rounding, and shown as 0
};

/// A number for a cell of such a table, to four digits; "-" if it is not a number.
std::string rounded_cell(double value, const ColumnScale& scale);

/// Numbers in rows under a heading of "name [unit]" columns, as CSV.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace twum::cli
