// SPDX-License-Identifier: Apache-2.0
// The ends of a front: from where they are searched, when kicks go on, which bounds they meet.
#include "scaled_search.hpp"

#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace twum;
using namespace twum::optim;
using test::D3;

namespace {

using Design = std::vector<double>;

// x^2 and (x - 1)^2 in the unit box, and a price of a second variable on both.
Problem priced(std::function<D3(const D3&)> price) {
  return test::posed<3>(
      test::box(2, 0.0, 1.0, {0.5, 0.5}), {},
      [price = std::move(price)](const D3* x, D3* r) {
        const D3 g = price(x[1]);
        r[0] = x[0] * x[0] + g;
        r[1] = (x[0] - 1.0) * (x[0] - 1.0) + g;
      },
      2);
}

// Valleys of f1 at the multiples of about 2 pi / 6 = 1.05, the lowest at 0.
Problem valleys(double level) {
  return test::posed<3>(
      test::box(1, -10.0, 10.0, {9.3}), {},
      [level](const D3* x, D3* r) {
        r[0] = x[0] * x[0] / 100.0 - cos(6.0 * x[0]) + level;
        r[1] = (x[0] - 20.0) * (x[0] - 20.0);
      },
      2);
}

}  // namespace

TEST_CASE("an end that stops just short of a bound is put on it, to the last bit",
          "[optim][pareto][identity]") {
  // A slope of 1e-12 is below what the solver moves a variable for, but the least is on the bound.
  for (const double off : {9e-8, 5e-8, 2e-8}) {
    for (const bool top : {false, true}) {
      Problem p = priced([top](const D3& z) { return (top ? -1e-12 : 1e-12) * z; });
      p.variables[0].lower = -1.0;  // both ends are inside of x, which is left as it is
      p.variables[0].upper = 2.0;
      test::ScaledSearch s(std::move(p));
      REQUIRE(s.front.find_ends({{0.3, top ? 1.0 - off : off}}));
      CAPTURE(off, top);
      for (const Solved& end : s.front.ends()) CHECK(end.unit[1] == (top ? 1.0 : 0.0));
    }
  }
}

TEST_CASE("an end is not put on a bound where that is worse", "[optim][pareto][closed_form]") {
  // z + 1e-14 / (z + 1e-8) is least where (z + 1e-8)^2 = 1e-14, and five times that at z = 0.
  test::ScaledSearch s(priced([](const D3& z) { return z + 1e-14 / (z + 1e-8); }));
  REQUIRE(s.front.find_ends({{0.3, 9e-8}}));
  // It starts there, and nothing pulls it on the way to x = 0 and x = 1; a tenth off costs 1e-9.
  for (const Solved& end : s.front.ends()) CHECK(end.design[1] == Approx(9e-8).epsilon(0.1));
}

TEST_CASE("an end is not put on a bound that breaks a limit", "[optim][pareto][closed_form]") {
  // z >= 9e-8, scaled by the limit's slope at the start; 1e-8 of that is tolerated.
  const Constraint inactive{"inactive", -1e9}, floor{"floor", 9e-14},
      ceiling{"ceiling", -kInfinity, -9e-14};
  const std::vector<std::vector<Constraint>> sets{
      {floor}, {inactive, floor}, {ceiling}, {inactive, ceiling}};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const std::size_t limits = sets[set].size();
    const double sign = set < 2 ? 1.0 : -1.0;
    test::ScaledSearch s(test::posed<3>(
        test::box(2, 0.0, 1.0, {0.5, 0.5}), sets[set],
        [=](const D3* x, D3* r) {
          r[0] = x[0] * x[0] + x[1];
          r[1] = (x[0] - 1.0) * (x[0] - 1.0) + x[1];
          r[2] = x[0];
          r[limits + 1] = sign * 1e-6 * x[1];
        },
        2));
    REQUIRE(s.front.find_ends({{0.3, 2e-7}}));
    CAPTURE(set);
    for (const Solved& end : s.front.ends()) {
      CHECK(end.design[1] >= 8e-8);
      CHECK(end.design[1] < 1e-7);  // near the bound it is
    }
  }
}

TEST_CASE("of the best designs for one objective an end is the best for the other",
          "[optim][pareto][closed_form]") {
  // All of x = 0 is best for the first, whatever its level there.
  for (const double level : {10.0, -10.0, 0.0}) {
    test::ScaledSearch s(test::posed<3>(
        test::box(2, 0.0, 1.0, {0.5, 0.9}), {},
        [level](const D3* x, D3* r) {
          r[0] = level + x[0];
          r[1] = (x[0] - 1.0) * (x[0] - 1.0) + (x[1] - 0.3) * (x[1] - 0.3);
        },
        2));
    REQUIRE(s.front.find_ends({s.start()}));
    CAPTURE(level);
    // The room is 1e-8 of 1 and the level. A step that gains less than 1e-14 of the objective ends
    // the search, and 1e-14 is what the last 1e-7 of z are worth.
    CHECK(s.front.ends()[0].design[0] == Approx(0.0).margin(1e-6));
    CHECK(s.front.ends()[0].design[1] == Approx(0.3).margin(1e-6));
  }
}

TEST_CASE("kicks find the lowest of the valleys wherever its objective is",
          "[optim][pareto][closed_form]") {
  for (const double level : {-100.0, 0.0, 100.0}) {
    test::ScaledSearch s(valleys(level));
    REQUIRE(s.front.find_ends({{0.965}, {0.9}}));
    // A kick counts if it gains 1e-6 of the objective, at most 1e-4; that is sqrt(1e-4 / 18) in x.
    CAPTURE(level);
    CHECK(s.front.ends()[0].design[0] == Approx(0.0).margin(0.003));
  }
}

TEST_CASE("where all starts lead to the same place nothing is kicked",
          "[optim][pareto][definition]") {
  std::size_t calls[2];
  for (const bool kicks : {false, true}) {
    test::ScaledSearch s(priced([](const D3& z) { return (z - 0.3) * (z - 0.3); }));
    s.options.hops = kicks ? 200 : 0;
    REQUIRE(s.front.find_ends({s.start(), {0.9, 0.1}, {0.2, 0.7}}));
    calls[kicks] = s.calls();
  }
  CHECK(calls[0] > 6);  // three starts for each of two ends
  CHECK(calls[1] == calls[0]);
}

TEST_CASE("kicks of several variables at once cross what those of one cannot",
          "[optim][pareto][closed_form]") {
  // Valleys along x = y, 2 pi / 6 apart in x + y. A move of x by that with y held costs 3.3 in the
  // first term and gains 1.3 at most, so kicks of one variable end nowhere. The lowest valley has -1,
  // those beside it (2 pi / 6)^2 / 20 = 0.055 more.
  test::ScaledSearch s(test::posed<3>(
      test::box(3, -10.0, 10.0, {4.0, 4.0, 1.0}), {},
      [](const D3* x, D3* r) {
        const D3 sum = x[0] + x[1], d = x[0] - x[1];
        r[0] = 3.0 * d * d + sum * sum / 20.0 - cos(6.0 * sum) + x[2] * x[2];
        r[1] = (x[0] - 20.0) * (x[0] - 20.0);
      },
      2));
  REQUIRE(s.front.find_ends({{0.7, 0.7, 0.5}, {0.8, 0.8, 0.5}}));
  CHECK(s.front.ends()[0].evaluation.values[0] < -0.97);
}

TEST_CASE("objectives that agree at all ends leave a front of the others",
          "[optim][pareto][closed_form]") {
  for (const double level : {100.0, -100.0, 0.0}) {
    const Problem p = test::posed<3>(
        test::box(2, -1.0, 2.0, {0.4, 0.5}), {},
        [level](const D3* x, D3* r) {
          r[0] = x[0] * x[0];
          r[1] = (x[0] - 1.0) * (x[0] - 1.0);
          r[2] = x[1] * x[1] + level;
        },
        3);
    ParetoOptions options;
    options.points = 10;
    const Front front = pareto_front(p, options);
    CAPTURE(level);
    CHECK(front.outcome == Outcome::optimal);
    CHECK(front.points.size() == 10);
  }
}

TEST_CASE("the ends are searched from as many starts as asked for", "[optim][pareto][definition]") {
  const Problem p = priced([](const D3& z) { return (z - 0.3) * (z - 0.3); });
  for (const std::size_t starts : {1U, 2U, 3U}) {
    std::map<std::uint64_t, Design> first;
    ParetoOptions options;
    options.points = 2;
    options.coarse = 0;
    options.solve.starts = starts;
    options.solve.observer = [&](const Observation& o) {
      first.try_emplace(o.stage, o.design.begin(), o.design.end());
    };
    pareto_front(p, options);
    // The box is the unit box. Stage 0 scales.
    auto expected = sobol_points(2, starts, options.solve.seed);
    const Design beyond = expected.back();
    expected.pop_back();
    expected.insert(expected.begin(), {0.5, 0.5});
    CAPTURE(starts);
    for (std::size_t i = 0; i < starts; ++i) CHECK(first.at(i + 1) == expected[i]);
    CHECK(first.at(starts + 1) != beyond);
  }
}

TEST_CASE("a stop long after the best design of a stage leaves a front of whole points",
          "[optim][pareto][budget]") {
  // From some stage on the Jacobian has the wrong sign: a line search then makes many calls that are worse
  // than its start, until the start is no longer remembered.
  std::uint64_t stage = 0, last = 0;
  Problem p = priced([](const D3& z) { return (z - 0.3) * (z - 0.3); });
  p.evaluate = [&, honest = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = honest(x, gradient);
    if (stage + 1 < last) return e;  // the stage of the call before this one
    for (double& d : e.jacobian) d = -d;
    return e;
  };
  ParetoOptions options;
  options.solve.starts = 2;
  options.coarse = 1;
  double least = kInfinity;
  std::size_t since = 0, stopped = 0, points = 0;
  for (last = 1; last <= 40; ++last) {
    stage = 0;
    std::stop_source source;
    options.solve.stop = source.get_token();
    options.solve.observer = [&](const Observation& o) {
      const double sum = o.evaluation.values[0] + o.evaluation.values[1];
      const bool fresh = o.stage != stage || o.index == 0;
      since = fresh || sum < least ? 0 : since + 1;
      least = fresh ? sum : std::min(least, sum);
      stage = o.stage;
      if (stage == last && since == 5) source.request_stop();
    };
    const Front front = pareto_front(p, options);
    if (!source.stop_requested()) continue;
    ++stopped;
    CAPTURE(last);
    CHECK(front.outcome == Outcome::budget);
    points += front.points.size();
    for (const FrontPoint& point : front.points) CHECK(point.evaluation.values.size() == 2);
  }
  CHECK(stopped >= 10);
  CHECK(points >= stopped);
}
