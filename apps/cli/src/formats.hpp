// SPDX-License-Identifier: Apache-2.0
#pragma once

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
};

/// Adds --format and -o.
void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats);

/// A number for a CSV cell; empty if it is not a number.
std::string cell_of(double value);

/// Numbers in rows under a heading of "name [unit]" columns, as CSV.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace twum::cli
