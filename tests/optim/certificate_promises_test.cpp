// SPDX-License-Identifier: Apache-2.0
// Certificates where an optimum is not a plain one, and infeasible equalities.
#include "optim/bank/posed.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

}  // namespace

TEST_CASE("a concave kink never passes, whatever the Jacobian holds there",
          "[optim][certificate]") {
  for (const double entry : {-1.0, -0.5, 0.0, 0.5, 1.0}) {  // -|x|, top of a hill
    Problem p = test::posed<2>({{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0]; });
    p.evaluate = [entry](std::span<const double> x, bool) {
      Evaluation e{{-std::abs(x[0])}, {x[0] == 0.0 ? entry : x[0] < 0.0 ? 1.0 : -1.0}, {}, {}};
      if (x[0] == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, 1.0, -1.0});
      return e;
    };
    CAPTURE(entry);
    CHECK_FALSE(certify(p, Design{0.0}).passed);
  }
}

TEST_CASE("a gradient without weight does not make the others small",
          "[optim][certificate][pareto]") {
  // At (.95, .5) the gradients are (-1, 1) and (3.6e9, 0), (1, 0) at the start: y can fall to the good of f0
  // and to nobody's harm.
  const Problem two = test::posed<2>(
      {{"x", 0.0, 1.0, 0.0}, {"y", 0.0, 1.0, 0.5}}, {},
      [](const D* x, D* r) {
        r[0] = x[1] * x[1] - x[0];
        r[1] = exp(20.0 * x[0]);
      },
      2);
  CHECK_FALSE(certify(two, Design{0.95, 0.5}).passed);
  // max(-1e8 x, x) + y on its kink, with y free to fall.
  Problem kink = test::posed<2>({{"x", -1.0, 1.0, 0.5}, {"y", -1.0, 1.0, 0.5}}, {},
                                [](const D* x, D* r) { r[0] = x[0]; });
  kink.evaluate = [](std::span<const double> x, bool) {
    const double slope = x[0] < 0.0 ? -1e8 : 1.0;
    Evaluation e{{slope * x[0] + x[1]}, {slope, 1.0}, {}, {}};
    if (x[0] == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, -1e8, 1.0});
    return e;
  };
  CHECK_FALSE(certify(kink, Design{0.0, 0.0}).passed);
  CHECK(certify(kink, Design{0.0, -1.0}).passed);
}

TEST_CASE("of gradients that differ by eight orders the small ones balance each other",
          "[optim][certificate][pareto][closed_form]") {
  // Gradients (1, 0), (-1, 0) and (0, e^19): only equal weights of the first two leave nothing.
  const Problem p = test::posed<2>(
      {{"x", 0.0, 1.0, 0.5}, {"y", 0.0, 1.0, 0.0}}, {},
      [](const D* x, D* r) {
        r[0] = x[0], r[1] = -x[0];
        r[2] = exp(20.0 * x[1]);
      },
      3);
  const Certificate c = certify(p, Design{0.5, 0.95});
  CHECK(c.passed);
  REQUIRE(c.weights.size() == 3);
  // Rounding of least squares with columns of unit length.
  CHECK(c.weights[0] == Approx(0.5).epsilon(1e-12));
  CHECK(c.weights[1] == Approx(0.5).epsilon(1e-12));
  CHECK(std::abs(c.weights[2]) < 1e-12);
}

TEST_CASE("kinks in two variables, told and mixed by none, are found by looking about",
          "[optim][certificate][kink]") {
  const Problem smooth = test::posed<2>({{"x", -1.0, 1.0, 0.5}, {"y", -1.0, 1.0, 0.5}}, {},
                                        [](const D* x, D* r) { r[0] = x[0]; });
  for (const double tilt : {0.0, 1.5}) {  // |x| + |y| + tilt y is least at the origin up to 1
    Problem p = smooth;
    p.evaluate = [tilt](std::span<const double> x, bool) {
      const double a = x[0] < 0.0 ? -1.0 : 1.0, b = x[1] < 0.0 ? -1.0 : 1.0;
      Evaluation e{{a * x[0] + (b + tilt) * x[1]}, {a, b + tilt}, {}, {}};
      if (x[0] == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, -1.0, 1.0});
      if (x[1] == 0.0) e.kinks.push_back({0, 1, Slope::one_sided, tilt - 1.0, tilt + 1.0});
      return e;
    };
    const Certificate c = certify(p, Design{0.0, 0.0});
    CAPTURE(tilt, c.reason);
    CHECK(c.passed == (tilt < 1.0));
    CHECK(c.findings.size() == 2);  // each kink once, whoever finds it
  }
}

TEST_CASE("a side of a kink without a slope is a derivative that does not exist",
          "[optim][certificate][kink]") {
  for (const bool left : {true, false}) {
    Problem p = test::posed<2>({{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0]; });
    p.evaluate = [left](std::span<const double> x, bool) {
      Evaluation e{{std::abs(x[0])}, {x[0] < 0.0 ? -1.0 : 1.0}, {}, {}};
      if (x[0] == 0.0)
        e.kinks.push_back({0, 0, Slope::one_sided, left ? NAN : -1.0, left ? 1.0 : NAN});
      return e;
    };
    const Certificate c = certify(p, Design{0.0});
    CHECK_FALSE(c.passed);
    REQUIRE(c.findings.size() == 1);
    CHECK(c.findings[0].kind == Degeneracy::undefined_gradient);
  }
}

TEST_CASE("a certificate does not depend on whether the start can be evaluated",
          "[optim][certificate][failure]") {
  // The slope 20 beside the minimum is 5e-8 of that at the start, 4e8, and nothing in itself.
  Problem p = test::posed<2>({{"x", 0.0, 3.0, 3.0}}, {},
                             [](const D* x, D* r) { r[0] = 1e8 * (x[0] - 1.0) * (x[0] - 1.0); });
  CHECK(certify(p, Design{1.0 + 1e-7}).passed);
  p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
    return x[0] == 3.0 ? Evaluation{{}, {}, {}, "torn"} : right(x, gradient);
  };
  CHECK(certify(p, Design{1.0 + 1e-7}).passed);
}

TEST_CASE("x^2 + c is not flat, whatever c", "[optim][certificate]") {
  for (const double c :
       {0.0, 2.0, 3.0}) {  // slope 2 at the start; c = 2 makes value times factor 1
    const Problem p = test::posed<2>({{"x", 0.0, 1.0, 1.0}}, {},
                                     [c](const D* x, D* r) { r[0] = x[0] * x[0] + c; });
    CAPTURE(c);
    for (const Finding& f : certify(p, Design{0.0}).findings)
      CHECK(f.kind != Degeneracy::flat_objective);
  }
}

TEST_CASE("a curvature that was not tested is NaN", "[optim][certificate]") {
  const Problem p =
      test::posed<2>({{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0] * x[0]; });
  SolveOptions few;
  few.budget.evaluations = 2;
  CHECK(std::isnan(certify(p, Design{1e-9}, few).curvature));
  CHECK(std::isnan(certify(p, Design{0.3}).curvature));
}

TEST_CASE("an equality missed from above pulls down", "[optim][certificate]") {
  // x = target, and two limits that ask for x >= 2: the sum of violations is smallest at 2 when the
  // target is 1. Its mirror image, which is said right, has the same answer.
  std::vector<std::string> conflict;
  for (const double s : {1.0, -1.0}) {
    const double up = s > 0 ? kInfinity : -2.0, low = s > 0 ? 2.0 : -kInfinity;
    const Problem p =
        test::posed<2>({{"x", 0.0, 10.0, 5.0}}, {{"target", s, s}, {"a", low, up}, {"b", low, up}},
                       [s](const D* x, D* r) { r[0] = x[0], r[1] = r[2] = r[3] = s * x[0]; });
    const Result r = solve(p);
    CAPTURE(s);
    REQUIRE(r.outcome == Outcome::infeasible);
    CHECK(std::abs(r.infeasibility.design[0] - 2.0) < 1e-5);  // 1e-6 of the box, 10 wide, passes
    CHECK(r.infeasibility.certified);
    CHECK(r.infeasibility.conflict.size() >= 2);
    if (s < 0) CHECK(r.infeasibility.conflict == conflict);
    conflict = r.infeasibility.conflict;
  }
}

TEST_CASE("each point of a concave front is an optimum", "[optim][certificate]") {
  const Problem p = test::posed<2>(
      {{"t", 0.0, 1.5, 0.5}}, {}, [](const D* x, D* r) { r[0] = cos(x[0]), r[1] = sin(x[0]); }, 2);
  for (const double t : {0.3, 0.7, 1.2}) CHECK(certify(p, Design{t}).passed);
}

TEST_CASE("the best weights do not depend on the order of the objectives", "[optim][certificate]") {
  for (const bool swapped : {false, true}) {
    const Problem p = test::posed<2>(
        {{"x", -1.0, 1.0, 0.5}}, {},
        [swapped](const D* x, D* r) {
          r[swapped ? 1 : 0] = x[0];
          r[swapped ? 0 : 1] = x[0] * x[0];
        },
        2);
    CAPTURE(swapped);  // weight 1 for x^2 leaves a slope of 2e-8
    CHECK(certify(p, Design{1e-8}).stationarity < 1e-6);
  }
}

TEST_CASE("a design that has no neighbour to look at is not called a kink",
          "[optim][certificate][failure]") {
  // |x - 1/2|, which tells the slope on the right, and cannot be evaluated on one of its sides.
  for (const double blind : {-1.0, 1.0}) {
    Problem p = test::posed<2>({{"x", 0.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0]; });
    p.evaluate = [blind](std::span<const double> x, bool) {
      const double t = x[0] - 0.5, slope = t < 0.0 ? -1.0 : 1.0;
      if (blind * t > 0.0) return Evaluation{{}, {}, {}, "blind"};
      return Evaluation{{slope * t}, {slope}, {}, {}};
    };
    const Certificate c = certify(p, Design{0.5});
    CAPTURE(blind, c.reason);
    CHECK_FALSE(c.passed);
    CHECK(c.findings.empty());
  }
}

TEST_CASE("where one objective is at its best the others have no weight",
          "[optim][certificate][pareto][closed_form]") {
  const Problem p = test::posed<2>(
      {{"x", -1.0, 1.0, 0.5}, {"y", -1.0, 1.0, 0.5}}, {},
      [](const D* x, D* r) {
        r[0] = (x[0] - 1.0) * (x[0] - 1.0) + x[1];
        r[1] = x[0] * x[0] + x[1] * x[1];
      },
      2);
  const Certificate c = certify(p, Design{0.0, 0.0});
  CHECK(c.passed);
  REQUIRE(c.weights.size() == 2);
  CHECK(std::abs(c.weights[0]) <= 1e-15);  // of exact zeros, by least squares
  CHECK(c.weights[1] == Approx(1.0).epsilon(1e-15));
}
