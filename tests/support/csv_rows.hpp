// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace twum::test {

/// A row of a reference table with words in it.
class CsvRow {
 public:
  explicit CsvRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}
  const std::string& word(const std::string& name) const { return cells_.at(name); }
  double operator[](const std::string& name) const { return std::stod(cells_.at(name)); }
  /// Numbers between blanks.
  std::vector<double> list(const std::string& name) const {
    std::istringstream text(cells_.at(name));
    std::vector<double> numbers;
    for (double x; text >> x;) numbers.push_back(x);
    return numbers;
  }

 private:
  std::map<std::string, std::string> cells_;
};

/// Cells of a line; those in quotes may hold commas.
inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

/// The rows of a table of tests/data/reference.
inline std::vector<CsvRow> csv_rows(const std::string& name) {
  std::ifstream file(std::string(TWUM_TEST_DATA "/reference/") + name);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("no table " + name);
  const std::vector<std::string> names = csv_cells(line);
  std::vector<CsvRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = csv_cells(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < cells.size() ? cells[i] : "";
    rows.emplace_back(std::move(row));
  }
  return rows;
}

}  // namespace twum::test
