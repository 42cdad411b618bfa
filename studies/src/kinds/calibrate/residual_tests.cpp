// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/residual_tests.hpp"

#include "results/calibration_notes.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/offset_test.hpp>
#include <twum/studies/fit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// A point that counts, and its number among these.
struct Counted {
  const CalibrateResult::Point* point;
  std::size_t number;

  const CalibrateResult::Point* operator->() const { return point; }
  const CalibrateResult::Point& operator*() const { return *point; }
};
using Points = std::vector<Counted>;

// Sorts points by what they have in common, the groups in the order of their first ones.
template <typename KeyOf>
std::vector<Points> grouped(const Points& points, KeyOf key_of) {
  std::map<decltype(key_of(points.front())), std::size_t> places;
  std::vector<Points> groups;
  for (const Counted& point : points) {
    const auto [known, fresh] = places.try_emplace(key_of(point), groups.size());
    if (fresh) groups.emplace_back();
    groups[known->second].push_back(point);
  }
  return groups;
}

// Points that count, by kind, in the order of the data.
std::vector<Points> kinds_of(const CalibrateResult& result) {
  Points points;
  for (const CalibrateResult::Point& point : result.data)
    if (point.counts) points.push_back({&point, points.size()});
  return grouped(points, [](const Counted& point) { return point->quantity; });
}

// Bonferroni's inequality: how often chance puts one of so many p as low.
double of_many(double p, std::size_t count) {
  return std::min(1.0, static_cast<double>(count) * p);
}

// Neighbours have one table, and one setting of the bench but for what is varied.
std::pair<std::string, std::map<std::string, double>> series_of(const Counted& point,
                                                                const std::string& varied) {
  std::map<std::string, double> set;
  for (const NamedValue& one : point->set) set[one.name] = one.name == varied ? 0 : one.value;
  if (point->after) set[load_of(*point).name] = point->at;
  return {table_of(*point), std::move(set)};
}

// Residuals and their rows of the points that count.
optim::Residuals counting(const optim::Residuals& all, const CalibrateResult& result) {
  optim::Residuals some;
  const std::size_t n = all.jacobian.size() / all.values.size();
  for (std::size_t i = 0; i < result.data.size(); ++i) {
    if (!result.data[i].counts) continue;
    some.values.push_back(all.values[i]);
    for (std::size_t j = 0; j < n; ++j) some.jacobian.push_back(all.jacobian[i * n + j]);
  }
  return some;
}

// The points of a kind in the order of what the bench varied, by their numbers.
std::vector<std::vector<std::size_t>> all_series(Points kind, const NamedValue& over) {
  std::erase_if(kind, [&](const Counted& point) { return std::isnan(place_on(*point, over)); });
  std::vector<std::vector<std::size_t>> numbers;
  for (Points& one :
       grouped(kind, [&](const Counted& point) { return series_of(point, over.name); })) {
    std::ranges::stable_sort(one, {}, [&](const Counted& point) { return place_on(*point, over); });
    numbers.emplace_back();
    for (const Counted& point : one) numbers.back().push_back(point.number);
  }
  return numbers;
}

void test_neighbours(CalibrateResult& result, const std::vector<Points>& kinds,
                     const optim::Residuals& residuals, const optim::LeastSquaresResult& fit) {
  std::size_t count = 0;
  for (const Points& kind : kinds) {
    const std::optional<NamedValue> over = axis_of(result.data, *kind.front());
    if (!over) continue;
    const auto test = optim::neighbour_test(residuals, fit, all_series(kind, *over));
    if (test.count == 0) continue;
    ++count;
    if (result.neighbours && result.neighbours->p <= test.p) continue;
    result.neighbours = test;
    result.neighbours_of = {kind.front()->quantity, over->name};
  }
  if (result.neighbours) result.neighbours->p = of_many(result.neighbours->p, count);
}

// Those of one table that counts. Where columns have a scatter of their own, these are the columns.
std::vector<Points> by_table(const Points& kind) {
  return grouped(kind, [](const Counted& point) { return table_of(*point); });
}

// An instrument that was not set to zero shifts all that it reads. Where every reading was taken at the same place, they have
// no neighbours, and a scatter that is estimated from them holds the shift.
void test_offsets(CalibrateResult& result, const std::vector<Points>& kinds,
                  const optim::Residuals& residuals, const optim::LeastSquaresResult& fit,
                  double known) {
  CalibrateResult::ColumnOffset rarest;
  std::size_t count = 0;
  for (const Points& kind : kinds) {
    for (const Points& column : by_table(kind)) {
      std::vector<std::size_t> rows;
      std::vector<double> slopes;
      for (const Counted& point : column) {
        rows.push_back(point.number);
        slopes.push_back(std::sqrt(point->weight));
      }
      const auto test =
          optim::offset_test(residuals, fit, {rows, slopes, !result.columns.empty()}, known);
      if (!(test.deviation > 0)) continue;
      ++count;
      const CalibrateResult::Point& one = *column.front();
      if (test.p < rarest.p)
        rarest = {one.quantity, one.unit, table_of(one), column.size(), -test.offset, test.p};
    }
  }
  if (count == 0) return;
  rarest.p = of_many(rarest.p, count);
  if (rarest.p < kUnlikely) result.offset = rarest;
}

double sum_of(const Points& points) {
  double sum = 0;
  for (const Counted& point : points) sum += std::pow(point->residual / point->deviation, 2);
  return sum;
}

// A kind that misses its deviations can hide behind others whose deviations are stated too large. Its degrees of freedom are at
// most its numbers.
void test_kinds(CalibrateResult& result, const std::vector<Points>& kinds) {
  if (kinds.size() < 2) return;
  CalibrateResult::KindScatter worst;
  for (const Points& kind : kinds) {
    const double sum = sum_of(kind);
    const double p =
        of_many(optim::chi_square_tail(static_cast<double>(kind.size()), sum), kinds.size());
    if (p < worst.p) worst = {kind.front()->quantity, sum, kind.size(), p};
  }
  if (worst.p < kUnlikely) result.worst_kind = worst;
}

}  // namespace

std::vector<std::vector<std::size_t>> measured_series(const CalibrateResult& result) {
  std::vector<std::vector<std::size_t>> list;
  for (const Points& kind : kinds_of(result))
    if (const std::optional<NamedValue> over = axis_of(result.data, *kind.front()))
      for (auto& one : all_series(kind, *over)) list.push_back(std::move(one));
  return list;
}

void test_residuals(CalibrateResult& result, const optim::Residuals& residuals,
                    const optim::LeastSquaresResult& fit, bool deviations, double known) {
  if (result.exact || result.degrees_of_freedom == 0) return;
  const std::vector<Points> kinds = kinds_of(result);
  const optim::Residuals some = counting(residuals, result);
  test_neighbours(result, kinds, some, fit);
  test_offsets(result, kinds, some, fit, known);
  const std::size_t freedom = result.counting_freedom();
  if (!deviations || !result.columns.empty() || freedom == 0) return;
  double sum = 0;
  for (const Points& kind : kinds) sum += sum_of(kind);
  result.chi_square = sum;
  result.chi_square_p = optim::chi_square_tail(static_cast<double>(freedom), sum);
  test_kinds(result, kinds);
}

}  // namespace twum::inline v0_1::studies
