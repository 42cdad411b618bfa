// SPDX-License-Identifier: Apache-2.0
#include "store/seal.hpp"

#include "text/checksum.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

constexpr std::string_view kEnd("\0", 1);  // between two texts

// Index of a row's first value among the columns of the table.
constexpr int kFirstValue = 2;

std::string bytes_of(double value) {
  if (std::isnan(value)) return "NaN";
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string name_of(const StoredRow& row) {
  return "row " + std::to_string(row.index) + " of stage " + std::to_string(row.stage);
}

Seal stored_seal(sqlite::Connection& connection) {
  sqlite::Statement select(connection, "SELECT rows, sum FROM seal");
  if (!select.step()) fail_damaged(connection.path(), "it has no seal");
  return {select.count(0), static_cast<std::uint64_t>(select.integer(1))};
}

// After the values stand status, detail and checksum.
std::uint64_t stored_checksum(const sqlite::Statement& select, std::size_t columns) {
  return static_cast<std::uint64_t>(select.integer(kFirstValue + static_cast<int>(columns) + 2));
}

// Reads the rows in the order of the pages: a page in the place of another one changes the order or the sum.
Seal seal_of_rows(sqlite::Connection& connection, std::size_t columns) {
  Seal seal;
  sqlite::Statement select(connection, "SELECT * FROM evaluations ORDER BY stage, \"index\"");
  std::optional<std::pair<std::uint64_t, std::uint64_t>> last;
  while (select.step()) {
    const StoredRow row = read_row(connection, select, columns);
    const std::pair key(row.stage, row.index);
    if (last && key <= *last) fail_damaged(connection.path(), name_of(row) + " is out of order");
    last = key;
    ++seal.rows;
    seal.sum += stored_checksum(select, columns);
  }
  return seal;
}

}  // namespace

void fail_damaged(const std::string& path, const std::string& what) {
  throw StoreError(path + ": is damaged: " + what +
                   "; restore it from a copy, or run the study again with --fresh");
}

std::uint64_t checksum_of(const StoredRow& row, std::size_t columns) {
  std::uint64_t sum = checksum(bytes_of(static_cast<double>(row.stage)));
  sum = checksum(bytes_of(static_cast<double>(row.index)), sum);
  for (std::size_t i = 0; i < columns; ++i) {
    sum = checksum(
        bytes_of(i < row.values.size() ? row.values[i] : std::numeric_limits<double>::quiet_NaN()),
        sum);
  }
  sum = checksum(row.status, sum);
  sum = checksum(kEnd, sum);
  return checksum(row.detail, sum);
}

std::uint64_t checksum_of_fact(std::string_view name, std::string_view value) {
  return checksum(value, checksum(kEnd, checksum(name)));
}

std::uint64_t checksum_of(const std::vector<StoredColumn>& columns) {
  std::uint64_t sum = checksum("columns");
  for (const StoredColumn& column : columns)
    sum = checksum(kEnd, checksum(column.unit, checksum(kEnd, checksum(column.name, sum))));
  return sum;
}

StoredRow read_row(const sqlite::Connection& connection, const sqlite::Statement& select,
                   std::size_t columns) {
  const int after_values = kFirstValue + static_cast<int>(columns);
  StoredRow row;
  row.stage = select.count(0);
  row.index = select.count(1);
  row.values.reserve(columns);
  for (int i = kFirstValue; i < after_values; ++i) row.values.push_back(select.real(i));
  row.status = select.text(after_values);
  row.detail = select.blob(after_values + 1);
  if (stored_checksum(select, columns) != checksum_of(row, columns))
    fail_damaged(connection.path(), name_of(row) + " is not what was written");
  return row;
}

Facts read_facts(sqlite::Connection& connection) {
  Facts facts;
  sqlite::Statement select(connection, "SELECT name, value FROM facts");
  while (select.step()) facts.emplace(select.text(0), select.text(1));
  return facts;
}

Seal checked_seal(sqlite::Connection& connection, const std::vector<StoredColumn>& columns,
                  const Facts& facts) {
  const Seal stored = stored_seal(connection);
  Seal found = seal_of_rows(connection, columns.size());
  if (found.rows != stored.rows) {
    fail_damaged(connection.path(), "it holds " + std::to_string(found.rows) + " rows, but " +
                                        std::to_string(stored.rows) + " were written");
  }
  found.sum += checksum_of(columns);
  for (const auto& [name, value] : facts) found.sum += checksum_of_fact(name, value);
  if (found != stored) fail_damaged(connection.path(), "its content is not what was written");
  return stored;
}

}  // namespace twum::inline v0_1::io
