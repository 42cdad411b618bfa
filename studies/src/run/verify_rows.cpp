// SPDX-License-Identifier: Apache-2.0
#include "run/verify_checks.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/optim/random.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::size_t kMostComplaints = 20;
constexpr std::uint64_t kDrawStage = 0x7E21F7;

std::string name_of(const StoredRow& row) {
  return "row " + std::to_string(row.index) +
         (row.stage > 0 ? " of stage " + std::to_string(row.stage) : "");
}

std::string shown(double value) { return std::isnan(value) ? "no value" : number_text(value); }

void compare(const std::vector<StoredColumn>& columns, const StoredRow& there, const StoredRow& now,
             Verification& found) {
  if (there.status != now.status) {
    complain(found, name_of(there) + ": status " + studies::quoted(there.status) + " there, " +
                        studies::quoted(now.status) + " now");
    return;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (note_deviation(found, there.values[i], now.values[i])) continue;
    complain(found, name_of(there) + ": " + columns[i].name + " is " + shown(there.values[i]) +
                        " there, " + shown(now.values[i]) + " now");
    return;  // one line for a row
  }
}

}  // namespace

void complain(Verification& found, const std::string& text) {
  ++found.failed;
  if (found.complaints.size() < kMostComplaints) found.complaints.push_back(text);
}

bool note_deviation(Verification& found, double there, double now) {
  if (there == now || (std::isnan(there) && std::isnan(now))) return true;
  const double deviation = std::abs(there - now) / std::max(std::abs(there), std::abs(now));
  if (!(deviation <= kVerifyTolerance)) return false;  // also true for NaN against a number
  found.deviation = std::max(found.deviation, deviation);
  return true;
}

// Selection sampling (Knuth, algorithm S): all sets of rows have the same probability; one pass without memory.
void verify_rows(const StudyKindRun& kind, const ResultStore& store, const VerifyOptions& options,
                 Verification& found) {
  found.rows = store.rows();
  optim::Random random(options.seed, kDrawStage, 0);
  std::uint64_t left = found.rows;
  std::uint64_t wanted = std::min(options.samples, found.rows);
  store.read([&](const StoredRow& row) {
    const bool drawn = left > 0 && random.below(left) < wanted;
    if (left > 0) --left;
    if (!drawn) return;
    if (options.stop.stop_requested()) throw Interrupted();
    --wanted;
    const std::optional<StoredRow> again = kind.recompute(row);
    ++(again ? found.rows_checked : found.rows_skipped);
    if (again) compare(store.columns(), row, *again, found);
  });
}

}  // namespace twum::inline v0_1::studies
