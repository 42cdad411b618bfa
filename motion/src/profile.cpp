// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/profile.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::motion {
namespace {

std::string place(std::size_t row) { return "row " + std::to_string(row + 1); }

double between(const Profile::Row& a, const Profile::Row& b, double time) {
  return a.second + (b.second - a.second) * ((time - a.first) / (b.first - a.first));
}

}  // namespace

Profile::Profile(double constant) : rows_{{0, constant}} {
  if (!std::isfinite(constant)) throw InputError("a value that stays the same must be finite");
}

Profile::Profile(std::vector<Row> rows) : rows_(std::move(rows)) {
  if (rows_.empty()) throw InputError("a profile needs at least one row of time and value");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!std::isfinite(rows_[i].first) || !std::isfinite(rows_[i].second))
      throw InputError(place(i) + " of a profile is not finite");
    if (i > 0 && rows_[i].first < rows_[i - 1].first)
      throw InputError("times of a profile must rise, but that of " + place(i) +
                       " is before that of " + place(i - 1));
    if (i > 1 && rows_[i].first == rows_[i - 2].first)
      throw InputError("a step has two rows of one time, but " + place(i) + " is a third one");
  }
}

double Profile::before(double time) const {
  const auto next = std::ranges::lower_bound(rows_, time, {}, &Row::first);
  if (next == rows_.begin()) return rows_.front().second;
  if (next == rows_.end()) return rows_.back().second;
  return next->first == time ? next->second : between(*(next - 1), *next, time);
}

double Profile::after(double time) const {
  const auto next = std::ranges::upper_bound(rows_, time, {}, &Row::first);
  if (next == rows_.begin()) return rows_.front().second;
  if (next == rows_.end()) return rows_.back().second;
  return between(*(next - 1), *next, time);
}

double Profile::largest() const {
  return std::ranges::max_element(rows_, {}, &Row::second)->second;
}

}  // namespace twum::inline v0_1::motion
