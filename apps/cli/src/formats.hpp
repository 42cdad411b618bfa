// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/engineering.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace twum::inline v0_1::cli {

/// Format and destination of a result.
struct OutputOptions {
  std::string format{"table"};
  std::string path;

  /// Width of a table in characters: that of the terminal; 0, without limit, for files and pipes.
  std::size_t table_width() const;
};

/// Adds --format and -o. Without --format, the extension .csv, .json or .md of the file selects the format.
void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats);

/// Format that the ending of a path names, in small letters: "csv" of "results/curve.CSV", "markdown" of ".md".
std::string format_of(const std::string& path);

/// Refuses a file whose ending is that of another format than these, such as "curve.xlsx".
/// @throws InputError
void require_ending(const std::string& path, const std::vector<std::string>& formats);

/// A number for a CSV cell; empty if it is not a number.
std::string cell_of(double value);

/// Unit and rounding of a column of a terminal's table.
struct ColumnScale {
  studies::DisplayUnit unit;
  /// largest size in the column, SI; values below 1e-9 of it are rounding errors and shown as 0
  double largest{0};
};

/// A number for a cell of such a table, to four digits; "-" if it is not a number.
std::string rounded_cell(double value, const ColumnScale& scale);

/// Numbers in rows under a heading of "name [unit]" columns, as CSV.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace twum::inline v0_1::cli
