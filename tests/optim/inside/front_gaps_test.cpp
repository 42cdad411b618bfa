// SPDX-License-Identifier: Apache-2.0
// Points between the ends of a front: what is held on the way to one, how even they lie, and where
// a hole begins and ends.
#include "scaled_search.hpp"

#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace twum;
using namespace twum::optim;
using test::D3;

namespace {

// 1 in the middle between the ends, at x = 0.5, and 0 with three derivatives near the ends.
D3 bump(const D3& x) {
  const D3 away = (x - 0.5) / 0.3;
  const D3 inside = std::abs(away.v) < 1.0 ? 1.0 - away * away : D3(0.0);
  return inside * inside * inside;
}

// x^2 and (x - 1)^2, at which a second variable's bound 0, or if mirrored 2, is best at the ends
// x = 0 and x = 1, but not in the middle.
Problem bumpy(bool swapped, bool mirrored) {
  return test::posed<3>(
      test::box(2, 0.0, 2.0, {0.4, 0.4}), {},
      [=](const D3* v, D3* r) {
        const D3 x = v[swapped ? 1 : 0];
        const D3 z = mirrored ? 2.0 - v[swapped ? 0 : 1] : v[swapped ? 0 : 1];
        const D3 miss = z - (bump(x) - 0.1);
        r[0] = x * x + 0.1 * miss * miss;
        r[1] = (x - 1.0) * (x - 1.0) + 0.1 * miss * miss;
      },
      2);
}

// x and f(x) for x in the unit interval, or f(x) and x.
Problem over_x(std::function<D3(const D3&)> f, bool exchanged = false) {
  return test::posed<3>(
      test::box(1, 0.0, 1.0, {0.2}), {},
      [f = std::move(f), exchanged](const D3* x, D3* r) {
        r[exchanged ? 1 : 0] = x[0];
        r[exchanged ? 0 : 1] = f(x[0]);
      },
      2);
}

std::vector<double> sorted_x(const Front& front) {
  std::vector<double> x;
  for (const FrontPoint& p : front.points) x.push_back(p.design[0]);
  std::sort(x.begin(), x.end());
  return x;
}

double nearest_to(const std::vector<double>& values, double at) {
  double least = kInfinity;
  for (const double v : values) least = std::min(least, std::abs(v - at));
  return least;
}

}  // namespace

TEST_CASE("what both neighbours have on a bound is held there, and nothing else",
          "[optim][pareto][manufactured]") {
  const bool swapped = GENERATE(false, true), mirrored = GENERATE(false, true);
  CAPTURE(swapped, mirrored);
  const std::size_t ix = swapped ? 1 : 0, iz = swapped ? 0 : 1;
  test::ScaledSearch s(bumpy(swapped, mirrored));
  REQUIRE(s.front.find_ends({s.start()}));
  Solved a = s.front.ends()[0], b = s.front.ends()[1];
  const double bound = mirrored ? 1.0 : 0.0;
  REQUIRE(a.unit[iz] == bound);
  REQUIRE(b.unit[iz] == bound);
  std::vector<double> start(2, bound);
  start[ix] = 0.2;
  const auto search = [&] { return s.front.scalarize_within({0.5, 0.5}, {1.0, 1.0}, start, a, b); };
  const auto found = search();
  REQUIRE(found);
  CHECK(found->unit[iz] == bound);
  // By symmetry. A front takes whatever lies a thousandth of the gap away from its neighbours.
  CHECK(found->design[ix] == Approx(0.5).margin(1e-3));
  a.unit[iz] = b.unit[iz] = 0.3;  // inside the box
  CHECK_FALSE(search());
  a.unit[iz] = bound;  // one of them
  CHECK_FALSE(search());
}

TEST_CASE("what neighbours agree in all along a front is predicted",
          "[optim][pareto][manufactured]") {
  // All variables but the first are best on their bound wherever x is.
  for (const std::size_t n : {2U, 3U}) {
    test::ScaledSearch s(test::posed<3>(
        test::box(n, 0.0, 2.0, std::vector<double>(n, 0.4)), {},
        [n](const D3* x, D3* r) {
          D3 rest(0.0);
          for (std::size_t j = 1; j < n; ++j) rest = rest + (x[j] + 1.0) * (x[j] + 1.0);
          r[0] = x[0] * x[0] + rest;
          r[1] = (x[0] - 1.0) * (x[0] - 1.0) + rest;
        },
        2));
    REQUIRE(s.front.find_ends({s.start()}));
    const std::size_t before = s.calls();
    const auto found =
        s.front.scalarize_predicted({0.5, 0.5}, {1.0, 1.0}, s.front.ends()[0], s.front.ends()[1]);
    CAPTURE(n);
    REQUIRE(found);
    CHECK(s.calls() - before <= 30);  // more it may not take, and it is right without Newton steps
    // By symmetry, and as above.
    CHECK(found->design[0] == Approx(0.5).margin(1e-3));
    for (std::size_t j = 1; j < n; ++j) CHECK(found->design[j] == 0.0);
  }
}

TEST_CASE("a prediction that Newton steps cannot confirm is discarded",
          "[optim][pareto][manufactured]") {
  // Both objectives rise with z near the ends and fall with it, as linearly, in the middle: there
  // the bound is no place for z, and nothing curved tells how far off it is.
  test::ScaledSearch s(test::posed<3>(
      test::box(2, 0.0, 2.0, {0.4, 0.4}), {},
      [](const D3* x, D3* r) {
        const D3 price = x[1] * (0.02 - 0.05 * bump(x[0]));
        r[0] = x[0] * x[0] + price;
        r[1] = (x[0] - 1.0) * (x[0] - 1.0) + price;
      },
      2));
  REQUIRE(s.front.find_ends({{0.1, 0.1}}));
  const Solved &a = s.front.ends()[0], &b = s.front.ends()[1];
  REQUIRE(a.design[1] == 0.0);
  REQUIRE(b.design[1] == 0.0);
  CHECK_FALSE(s.front.scalarize_predicted({0.5, 0.5}, {1.0, 1.0}, a, b));
}

TEST_CASE("the coarse points divide a straight front evenly, each from all its starts",
          "[optim][pareto][definition]") {
  test::ScaledSearch s(over_x([](const D3& x) { return 1.0 - x; }));
  s.options.points = 2;  // the ends and the coarse points are more than enough
  s.options.coarse = GENERATE(2U, 5U, 12U);
  s.options.coarse_starts = GENERATE(0U, 3U);
  REQUIRE(s.front.find_ends({s.start()}));
  const auto before = s.front.runner().next_stage();
  const auto points = two_objective_front(s.front, s.options);
  const std::size_t coarse = s.options.coarse;
  CAPTURE(coarse, s.options.coarse_starts);
  REQUIRE(points.size() == coarse + 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(points[i].design[0] ==
          Approx(static_cast<double>(i) / static_cast<double>(coarse + 1)).margin(1e-6));
  // One from the nearest known point, and the others.
  CHECK(s.front.runner().next_stage() - before == coarse * (1 + s.options.coarse_starts));
}

TEST_CASE("a front stops at both sides of a band that no design may be in",
          "[optim][pareto][closed_form]") {
  const Problem p = test::posed<3>(
      test::box(1, 0.0, 1.0, {0.2}), {{"outside", 0.0}},
      [](const D3* x, D3* r) {
        r[0] = x[0];
        r[1] = 1.0 - x[0];
        r[2] = (x[0] - 0.3) * (x[0] - 0.6);
      },
      2);
  ParetoOptions options;
  options.points = 20;
  const Front front = pareto_front(p, options);
  CHECK(front.outcome == Outcome::optimal);  // and not the end of the budget
  REQUIRE(front.points.size() == 20);
  // The limit's tolerance is 1e-8 times its slope at the start, 0.5; at the band's sides it is 0.3.
  const auto x = sorted_x(front);
  CHECK(nearest_to(x, 0.3) < 1e-7);
  CHECK(nearest_to(x, 0.6) < 1e-7);
  CHECK(std::none_of(x.begin(), x.end(), [](double v) { return v > 0.3001 && v < 0.5999; }));
}

TEST_CASE("a front stops where a hump begins and goes on where it is left behind",
          "[optim][pareto][closed_form]") {
  // The second objective is 1 at x = 0.3, its minimum with the curvature 4, above 1 up to 0.7, and
  // falls on from there with the slope 0.8. It spans about 1, as does the first.
  const bool exchanged = GENERATE(false, true);
  CAPTURE(exchanged);
  test::ScaledSearch s(
      over_x([](const D3& x) { return 1.0 - 5.0 * (x - 0.3) * (x - 0.3) * (x - 0.7); }, exchanged));
  s.options.points = 20;
  REQUIRE(s.front.find_ends({s.start(), {0.95}}));
  const auto points = two_objective_front(s.front, s.options);
  CHECK(points.size() >= 20);
  double left = 0.0, right = 1.0;
  for (const Solved& p : points) {
    const double x = p.design[0];
    if (x < 0.5) left = std::max(left, x);
    if (x > 0.5) right = std::min(right, x);
  }
  // A search may stop within 1e-6 of the front. Half the curvature is 2.
  CHECK(2.0 * (left - 0.3) * (left - 0.3) < 1e-6);
  CHECK(right == Approx(0.7).margin(1e-5));
}

TEST_CASE("a front leaves out a part along which one objective gains nothing",
          "[optim][pareto][closed_form]") {
  const bool exchanged = GENERATE(false, true);
  CAPTURE(exchanged);
  const Problem p = over_x(
      [](const D3& x) {
        const D3 left = x.v < 0.3 ? 0.3 - x : D3(0.0);
        const D3 right = x.v > 0.6 ? x - 0.6 : D3(0.0);
        return 1.0 + left * left - right * right;
      },
      exchanged);
  ParetoOptions options;
  options.points = 20;
  const Front front = pareto_front(p, options);
  CHECK(front.outcome == Outcome::optimal);  // and not the end of the budget
  CHECK(front.points.size() == 20);
  // Of designs with the same second objective one is best.
  const auto x = sorted_x(front);
  CHECK(std::count_if(x.begin(), x.end(), [](double v) { return v > 0.301 && v < 0.599; }) <= 1);
}

TEST_CASE("a wide gap is searched from other starts too", "[optim][pareto][manufactured]") {
  // With z = 0 no design between x = 0.3 and 0.6 is allowed. With z = 0.8 all are, for 0.00064 of the
  // second objective, but from z = 0 the way there leads uphill: z^2 (z - 0.6) falls until 0.4.
  Problem p = test::posed<3>(
      test::box(2, 0.0, 1.0, {0.5, 0.0}), {{"way", 0.0}},
      [](const D3* x, D3* r) {
        const D3 off = x[0] - 0.45;
        r[0] = x[0];
        r[1] = 1.0 - x[0] + 1e-3 * x[1] * x[1];
        r[2] = off * off - 0.0225 + x[1] * x[1] * (x[1] - 0.6);
      },
      2);
  ParetoOptions options;
  options.points = 20;
  options.coarse = 0;
  options.solve.seed = GENERATE(1U, 2U, 3U, 4U, 5U, 6U);
  CAPTURE(options.solve.seed);
  const Front front = pareto_front(p, options);
  REQUIRE(front.points.size() == 20);
  const auto x = sorted_x(front);
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) widest = std::max(widest, x[i + 1] - x[i]);
  // Twenty points of a straight front are 0.05 apart, with gaps halved as a whole up to twice that.
  CHECK(widest < 0.15);
}

TEST_CASE("points of a round front do not crowd where it is steep or level",
          "[optim][pareto][closed_form]") {
  const bool hollow = GENERATE(false, true);
  CAPTURE(hollow);
  test::ScaledSearch s(test::posed<3>(
      {{"t", 0.0, 0.5 * std::numbers::pi, 0.7}}, {},
      [hollow](const D3* x, D3* r) {
        r[0] = hollow ? sin(x[0]) : 1.0 - sin(x[0]);
        r[1] = hollow ? cos(x[0]) : 1.0 - cos(x[0]);
      },
      2));
  s.options.points = 200;
  REQUIRE(s.front.find_ends({s.start()}));
  const auto points = two_objective_front(s.front, s.options);
  REQUIRE(points.size() == 400);  // twice what was asked for, to choose from
  double sum = 0.0, least = kInfinity;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double area =
        (points[i + 1].y[0] - points[i].y[0]) * (points[i].y[1] - points[i + 1].y[1]);
    sum += area;
    least = std::min(least, area);
  }
  // What was halved was the largest then, so no less than the mean in the end. Of the rectangle of a
  // chord h its halves have a quarter, and an eighth at an end, where its area goes as h^3.
  CHECK(least > 0.1 * sum / static_cast<double>(points.size() - 1));
}

TEST_CASE("a front of three objectives reaches its corners where no end is",
          "[optim][pareto][closed_form]") {
  // Of x, 3 y and 7 z, each divided by its slope. Least x takes y and no z, least y takes x, and
  // least z takes y: a unit of them lifts the floor more.
  test::ScaledSearch s(test::posed<3>(
      test::box(3, 0.0, 1.0, {0.5, 0.5, 0.5}), {{"floor", 1.0}},
      [](const D3* x, D3* r) {
        r[0] = x[0];
        r[1] = 3.0 * x[1];
        r[2] = 7.0 * x[2];
        r[3] = 2.0 * x[0] + 4.0 * x[1] + x[2];
      },
      3));
  s.options.points = GENERATE(1U, 4U, 6U);
  REQUIRE(s.front.find_ends({s.start()}));
  const auto found = three_objective_front(s.front, s.options);
  for (const std::vector<double>& corner :
       {std::vector<double>{0.5, 0.0, 0.0}, {0.0, 0.25, 0.0}, {0.0, 0.0, 1.0}}) {
    CAPTURE(corner);
    CHECK(std::any_of(found.begin(), found.end(), [&](const Solved& p) {
      double off = 0.0;
      for (std::size_t k = 0; k < 3; ++k) off = std::max(off, std::abs(p.design[k] - corner[k]));
      return off < 1e-5;  // a zero of a direction is 1e-6
    }));
  }
}
