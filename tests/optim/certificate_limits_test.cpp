// SPDX-License-Identifier: Apache-2.0
// What limits and bounds do to a certificate: curvature along them, what their slack is worth, and
// numbers of very different size. All slopes and curvatures are worked out by hand.
#include "optim/bank/posed.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

// Central differences of exact slopes err by 1e-9 of the slope at the start, and curvatures here are
// of its size: a thousand times that.
constexpr double kDifferences = 1e-6;

}  // namespace

TEST_CASE("a limit that curves away from the design adds to the curvature along it",
          "[optim][certificate][closed_form]") {
  // x + 10 (x + 1)^2 on the disc x^2 + y^2 <= 1 is least at (-1, 0), where the slope 1 is held by the
  // limit's slope -2 with a multiplier of 1/2. The Lagrangian has the curvatures 20 + 1 and 0 + 1, of
  // which only the second is along the limit. The limit is said from above or, negative, from below.
  for (const double s : {1.0, -1.0}) {
    const double low = s > 0.0 ? -kInfinity : -1.0, high = s > 0.0 ? 1.0 : kInfinity;
    const Problem p = test::posed<2>(test::box(2, -2.0, 2.0, {1.0, 1.0}),
                                     {{"inactive", -kInfinity, 50.0}, {"disc", low, high}},
                                     [s](const D* x, D* r) {
                                       r[0] = x[0] + 10.0 * (x[0] + 1.0) * (x[0] + 1.0);
                                       r[1] = 3.0 * x[0] + x[1];
                                       r[2] = s * (x[0] * x[0] + x[1] * x[1]);
                                     });
    const Certificate c = certify(p, Design{-1.0, 0.0});
    CAPTURE(s, c.reason);
    CHECK(c.passed);
    CHECK(c.curvature == Approx(1.0 / 21.0).epsilon(kDifferences));
    REQUIRE(c.limits.size() == 2);
    CHECK(c.limits[1].multiplier == Approx(0.5).epsilon(1e-12));  // rounding of one quotient
  }
}

TEST_CASE("a limit that curves towards the design takes from the curvature along it",
          "[optim][certificate][closed_form]") {
  // The same objective outside the disc, turned about: -x + 10 (x + 1)^2 with x^2 + y^2 >= 1 at
  // (-1, 0), which the slope -1 pulls into the disc. The Lagrangian has the curvatures 20 - 1 and
  // 0 - 1, so that along the limit the objective falls.
  const Problem p =
      test::posed<2>(test::box(2, -2.0, 2.0, {1.0, 1.0}), {{"disc", 1.0}}, [](const D* x, D* r) {
        r[0] = -x[0] + 10.0 * (x[0] + 1.0) * (x[0] + 1.0);
        r[1] = x[0] * x[0] + x[1] * x[1];
      });
  const Certificate c = certify(p, Design{-1.0, 0.0});
  CHECK_FALSE(c.passed);
  CHECK(c.reason == "stationary, but not a minimum");
  CHECK(c.curvature == Approx(-1.0 / 19.0).epsilon(kDifferences));
}

TEST_CASE("curvature beside a bound is taken from inside the box",
          "[optim][certificate][closed_form]") {
  // A bowl whose bottom is 1e-4 from a bound; its curvatures are 2 and 6, for sizes of 1 - 1e-4 and of 1.
  for (const double side : {1.0, -1.0}) {
    const double bottom = side * (1.0 - 1e-4);
    const Problem p =
        test::posed<2>(test::box(2, -1.0, 1.0, {0.0, 0.5}), {}, [bottom](const D* x, D* r) {
          r[0] = (x[0] - bottom) * (x[0] - bottom) + 3.0 * x[1] * x[1];
        });
    const Certificate c = certify(p, Design{bottom, 0.0});
    CAPTURE(side, c.reason);
    CHECK(c.passed);
    CHECK(c.curvature == Approx(bottom * bottom / 3.0).epsilon(kDifferences));
  }
}

TEST_CASE("complementarity is the slack in parts of the slope that its limit holds",
          "[optim][certificate][closed_form]") {
  // x^2 with x >= 10, just inside the limit. Nothing but the limit holds the slope 2 x, so what the slack could gain is
  // 2 x times the slack, and in parts of the steeper of the objective and its slope for a step of x, 2 x^2, it is
  // slack / x (O3.4).
  const Problem p = test::posed<2>({{"x", 0.0, 20.0, 0.1}}, {{"ten", 10.0}}, [](const D* x, D* r) {
    r[0] = x[0] * x[0];
    r[1] = x[0];
  });
  for (const double slack : {5e-6, 5e-8}) {
    const Certificate c = certify(p, Design{10.0 + slack});
    CHECK(c.passed == (slack < 1e-7));
    CHECK(c.complementarity ==
          Approx(0.1 * slack).epsilon(1e-6));  // 10 + 5e-8 is rounded to 4e-8 of 5e-8
  }
}

TEST_CASE("a steep slope into a bound does not make the others small",
          "[optim][certificate][pareto][closed_form]") {
  // At (0, 0.9) both objectives press x against its bound with a slope of 2000, and both would have y fall. The second
  // has less to gain: a slope of 0.4 for the size 0.9 of y, whose curvature for this size is 2 * 0.81 (O3.2).
  const Problem p = test::posed<2>(
      {{"x", 0.0, 1.0, 1.0}, {"y", 0.0, 1.0, 0.0}}, {},
      [](const D* x, D* r) {
        const D press = 2000.0 * x[0] - 1000.0 * x[0] * x[0];
        r[0] = press + (x[1] - 0.5) * (x[1] - 0.5);
        r[1] = press + (x[1] - 0.7) * (x[1] - 0.7);
      },
      2);
  const Certificate c = certify(p, Design{0.0, 0.9});
  CHECK_FALSE(c.passed);
  CHECK(c.stationarity == Approx(0.4 * 0.9 / 1.62).epsilon(kDifferences));
}

TEST_CASE("a limit that is much steeper at the start has a multiplier like any other",
          "[optim][certificate][closed_form]") {
  // exp(60 x) / 1e9 at 0: the slope 60e-9 there is e^-54 of the one at the start. x falls until it.
  const Problem p =
      test::posed<2>({{"x", -1.0, 1.0, 0.9}}, {{"steep", 1e-9}}, [](const D* x, D* r) {
        r[0] = x[0];
        r[1] = 1e-9 * exp(60.0 * x[0]);
      });
  const Certificate c = certify(p, Design{0.0});
  CAPTURE(c.reason);
  CHECK(c.passed);
  REQUIRE_FALSE(c.limits.empty());
  CHECK(c.limits[0].multiplier == Approx(1.0 / 60e-9).epsilon(1e-12));  // a few products
}

TEST_CASE("limits of very different slopes are not dependent for that",
          "[optim][certificate][degenerate]") {
  // Each holds a variable of its own; the slope of one has grown by e^21.6 since the start.
  const double steep = std::exp(12.0 * 0.9);
  for (const bool steep_first : {true, false}) {
    const std::size_t a = steep_first ? 1 : 2, b = 3 - a;
    std::vector<Constraint> limits(2);
    limits[a - 1] = {"steep", -kInfinity, steep};
    limits[b - 1] = {"plain", -kInfinity, 0.5};
    const Problem p =
        test::posed<2>(test::box(2, -1.0, 1.0, {-0.9, -0.9}), limits, [a, b](const D* x, D* r) {
          r[0] = -x[0] - x[1];
          r[a] = exp(12.0 * x[0]);
          r[b] = x[1];
        });
    const Certificate c = certify(p, Design{0.9, 0.5});
    CAPTURE(steep_first, c.reason);
    CHECK(c.passed);
    CHECK(c.findings.empty());
    REQUIRE(c.limits.size() == 2);
    CHECK(c.limits[a - 1].multiplier == Approx(1.0 / (12.0 * steep)).epsilon(1e-12));
    CHECK(c.limits[b - 1].multiplier == Approx(1.0).epsilon(1e-12));  // quotients of slopes
  }
}

TEST_CASE("an objective without slope in its only variable is flat",
          "[optim][certificate][degenerate]") {
  const Problem p =
      test::posed<2>({{"x", -1.0, 3.0, 2.0}}, {}, [](const D*, D* r) { r[0] = D(3.0); });
  const Certificate c = certify(p, Design{1.0});
  REQUIRE_FALSE(c.findings.empty());
  CHECK(c.findings[0].kind == Degeneracy::flat_objective);
  CHECK(c.findings[0].names == std::vector<std::string>{"x"});
}

TEST_CASE("where a derivative does not exist several objectives have no weights and no prices",
          "[optim][certificate][pareto]") {
  Problem p = test::posed<2>(
      {{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0], r[1] = -x[0]; }, 2);
  CHECK(certify(p, Design{0.25}).passed);
  p.evaluate = [smooth = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = smooth(x, gradient);
    if (x[0] == 0.25) e.kinks.push_back({1, 0, Slope::undefined, 0.0, 0.0});
    return e;
  };
  const Certificate c = certify(p, Design{0.25});
  CHECK_FALSE(c.passed);
  CHECK(c.reason == "a derivative does not exist");
  CHECK(c.stationarity == std::numeric_limits<double>::infinity());
  CHECK(c.weights == Design{0.0, 0.0});
  CHECK(c.prices == Design{0.0, 0.0});
}
