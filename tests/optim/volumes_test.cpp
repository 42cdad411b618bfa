// SPDX-License-Identifier: Apache-2.0
// Hypervolumes of points with whole coordinates, as the number of unit cells that they dominate, and
// choices of points among all that there are. Whole numbers of this size are exact in floating point.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;
using Positions = std::vector<std::size_t>;

// A cell is dominated if a point is at or below its lower corner in every coordinate.
bool dominated(const Points& points, const Point& cell) {
  return std::any_of(points.begin(), points.end(), [&](const Point& p) {
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k] > cell[k]) return false;
    return true;
  });
}

// Of the cells between the origin and the reference.
double cells(const Points& points, const Point& reference) {
  Point cell(reference.size(), 0.0);
  double count = 0.0;
  for (;;) {
    if (dominated(points, cell)) count += 1.0;
    std::size_t k = 0;
    while (k < cell.size() && (cell[k] += 1.0) == reference[k]) cell[k++] = 0.0;
    if (k == cell.size()) return count;
  }
}

Points random_points(std::size_t count, std::size_t dimension, int size, std::uint64_t seed) {
  Random random(11, seed, count);
  Points points(count, Point(dimension));
  for (Point& p : points)
    for (double& x : p) x = static_cast<double>(random.below(static_cast<std::uint64_t>(size)));
  return points;
}

Points moved(Points points, double by) {
  for (Point& p : points)
    for (double& x : p) x += by;
  return points;
}

// A permutation of 0 to count - 1.
Positions shuffled(std::size_t count, Random& random) {
  Positions order;
  for (std::size_t i = 0; i < count; ++i) {
    order.push_back(i);
    std::swap(order[i], order[random.below(i + 1)]);
  }
  return order;
}

// The area of every choice of positions, as bits, that holds the first and the last.
std::vector<std::pair<Positions, double>> choices(const Points& front, const Point& reference) {
  std::vector<std::pair<Positions, double>> all;
  for (std::size_t bits = 0; bits < (std::size_t{1} << front.size()); ++bits) {
    Positions chosen;
    Points points;
    for (std::size_t i = 0; i < front.size(); ++i) {
      if ((bits >> i & 1U) == 0) continue;
      chosen.push_back(i);
      points.push_back(front[i]);
    }
    if (chosen.size() < 2 || chosen.front() != 0 || chosen.back() + 1 != front.size()) continue;
    all.emplace_back(chosen, cells(points, reference));
  }
  return all;
}

double best_of(const std::vector<std::pair<Positions, double>>& all, std::size_t count) {
  double best = -1.0;
  for (const auto& [chosen, area] : all)
    if (chosen.size() == count) best = std::max(best, area);
  return best;
}

double area_of(const std::vector<std::pair<Positions, double>>& all, const Positions& positions) {
  for (const auto& [chosen, area] : all)
    if (chosen == positions) return area;
  return -1.0;  // no choice with both ends, in order
}

}  // namespace

TEST_CASE("the volume of whole points is the number of cells that they dominate, wherever they are",
          "[optim][pareto][brute_force]") {
  constexpr int kSize = 8;
  for (const std::size_t dimension : {2U, 3U}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const Points points = random_points(12, dimension, kSize, seed);
      const double exact = cells(points, Point(dimension, kSize));
      for (const double by : {0.0, -10.0, -4.0, 3.0}) {
        CAPTURE(dimension, seed, by);
        CHECK(hypervolume(moved(points, by), Point(dimension, kSize + by)) == exact);
      }
    }
  }
}

TEST_CASE("a long staircase at one level is its area times the height",
          "[optim][pareto][closed_form]") {
  // Steps (i, n - i): the column right of i is i + 1 high up to n + 1, the last one twice as wide.
  for (const int n : {1, 16, 17, 40}) {
    Points points;
    for (int i = 0; i < n; ++i) points.push_back({double(i), double(n - i), 1.0});
    CAPTURE(n);
    CHECK(hypervolume(points, {n + 1.0, n + 1.0, 2.0}) == 0.5 * n * (n - 1) + 2.0 * n);
  }
}

TEST_CASE("the best choice of any size with both ends is the best of all, in any order and unit",
          "[optim][pareto][brute_force]") {
  constexpr std::size_t kPoints = 9;
  constexpr double kSize = 28.0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Random random(17, seed, 0);
    Points front;  // in steps of 1 to 3 to the right and down
    double x = 1.0, y = kSize - 1.0;
    const auto step = [&] { return 1.0 + static_cast<double>(random.below(3)); };
    for (std::size_t i = 0; i < kPoints; ++i) {
      front.push_back({x, y});
      x += step();
      y -= step();
    }
    // A reference at the height of the second point leaves nothing for the first two to add.
    for (const double top : {kSize, front[1][1]}) {
      const auto all = choices(front, {kSize, top});
      for (const auto& [unit, shift] :
           {std::pair{1.0, 0.0}, std::pair{1.0, -100.0}, std::pair{1000.0, 0.0}}) {
        const Positions order = shuffled(kPoints, random);
        Points given;
        for (const std::size_t i : order)
          given.push_back({unit * (front[i][0] + shift), front[i][1] + shift});
        for (std::size_t count = 2; count < kPoints; ++count) {
          Positions chosen = best_subset(given, count, {unit * (kSize + shift), top + shift});
          for (std::size_t& i : chosen) i = order[i];
          CAPTURE(seed, top, unit, shift, count, chosen);
          REQUIRE(chosen.size() == count);
          CHECK(area_of(all, chosen) == best_of(all, count));
        }
      }
    }
  }
}

TEST_CASE("a front of two points is its two ends", "[optim][pareto][closed_form]") {
  // Squared distances from (0, 0) and (1, 0) on the unit square.
  using D = Dual<double, 2>;
  Problem p;
  p.variables = test::box(2, 0.0, 1.0, {0.6, 0.5});
  p.objectives = {{"near"}, {"far"}};
  p.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1] * x[1];
    r[1] = (x[0] - 1.0) * (x[0] - 1.0) + x[1] * x[1];
  });
  ParetoOptions options;
  options.points = 2;
  const Front front = pareto_front(p, options);
  CHECK(front.outcome == Outcome::optimal);
  REQUIRE(front.points.size() == 2);
  // The search for the best of one objective leaves the other a room of 1e-8, and limits give way by
  // 1e-8, both in units of slopes at the start, at most 1.2: together a quarter of this.
  CHECK(front.points[0].evaluation.values[0] == Approx(0.0).margin(1e-7));
  CHECK(front.points[1].evaluation.values[1] == Approx(0.0).margin(1e-7));
}
