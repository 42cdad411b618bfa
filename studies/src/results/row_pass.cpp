// SPDX-License-Identifier: Apache-2.0
#include "results/row_pass.hpp"

#include <twum/io/csv.hpp>
#include <twum/io/number.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16U;  // bytes written at a time

std::string header(const std::vector<StoredColumn>& columns, bool stages) {
  std::string line = stages ? "stage," : "";
  for (const StoredColumn& column : columns) {
    append_cell(line, column.words.empty() ? column.name + " [" + column.unit + "]" : column.name);
    line += ',';
  }
  return line + "status\n";
}

void append_line(const StoredRow& row, const std::vector<StoredColumn>& columns, bool stages,
                 std::string& out) {
  if (stages) out += std::to_string(row.stage) + ",";
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    if (const std::string* word = columns[i].word(row.values[i]))
      append_cell(out, *word);
    else
      append_number(out, row.values[i]);
    out += ',';
  }
  append_cell(out, row.status);
  out += '\n';
}

}  // namespace

void FailureCount::see(const StoredRow& row) {
  if (row.status == "ok") return;
  FailureRegion& region = by_reason_[row.status];
  if (region.count++ == 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    region.reason = row.status;
    for (const StoredColumn& variable : variables_)
      region.where.push_back({variable, kNone, kNone});
  }
  for (std::size_t i = 0; i < variables_.size() && i < row.values.size(); ++i) {
    region.where[i].low = std::fmin(region.where[i].low, row.values[i]);
    region.where[i].high = std::fmax(region.where[i].high, row.values[i]);
  }
}

std::vector<FailureRegion> FailureCount::regions() const {
  std::vector<FailureRegion> regions;
  for (const auto& [reason, region] : by_reason_) regions.push_back(region);
  std::stable_sort(
      regions.begin(), regions.end(),
      [](const FailureRegion& a, const FailureRegion& b) { return a.count > b.count; });
  return regions;
}

FailureCount write_rows(const ResultStore& store, const std::vector<StoredColumn>& columns,
                        std::size_t variables, const std::function<void(std::string_view)>& put) {
  FailureCount failures(
      {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(variables)});
  const bool stages = store.stages().size() > 1;
  std::string piece = header(columns, stages);
  store.read([&](const StoredRow& row) {
    failures.see(row);
    append_line(row, columns, stages, piece);
    if (piece.size() < kPiece) return;
    put(piece);
    piece.clear();
  });
  put(piece);
  return failures;
}

}  // namespace twum::inline v0_1::studies
