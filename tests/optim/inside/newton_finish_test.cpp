// SPDX-License-Identifier: Apache-2.0
// Newton steps on equalities, on limits that hold nothing back and on fronts; curvature of mixed sizes.
#include "polished_stage.hpp"

#include "optim/bank/posed.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

// Polishing ends where the scaled slope is 1e-11; curvatures here are about 1 of that scale, the
// boxes up to 6 wide.
constexpr double kExact = 1e-9;

// With curvatures below a millionth of the largest as none.
ConeCurvature free_curvature(const Eigen::VectorXd& diagonal) {
  const Eigen::MatrixXd none(diagonal.size(), 0);
  return cone_curvature(Eigen::MatrixXd(diagonal.asDiagonal()), {none, none},
                        1e-6 * diagonal.maxCoeff());
}

}  // namespace

TEST_CASE("Newton steps mend an equality from either side, whatever its target",
          "[optim][polish][closed_form]") {
  // The point of the line x + y = target nearest to the origin.
  for (const double target : {2.0, 0.5, -2.0}) {
    const Problem p = test::posed<2>(test::box(2, -3.0, 3.0, {2.0, 2.5}), {{"sum", target, target}},
                                     [](const D* x, D* r) {
                                       r[0] = x[0] * x[0] + x[1] * x[1];
                                       r[1] = x[0] + x[1];
                                     });
    for (const double off : {1e-3, -1e-3, 1e-5}) {
      const auto nearest = test::Stage(p).polished({0.5 * target + off, 0.5 * target + 2.0 * off});
      CAPTURE(target, off);
      REQUIRE(nearest);
      for (const double x : *nearest) CHECK(x == Approx(0.5 * target).margin(kExact));
    }
  }
}

TEST_CASE("Newton steps mend a broken limit that holds nothing back",
          "[optim][polish][closed_form]") {
  // The objective does not ask for x, and only the limit does.
  for (const double s : {1.0, -1.0}) {
    const double low = s > 0.0 ? 0.5 : -kInfinity, high = s > 0.0 ? kInfinity : -0.5;
    const Problem p = test::posed<2>(test::box(2, -1.0, 1.0, {0.9, 0.9}), {{"half", low, high}},
                                     [s](const D* x, D* r) {
                                       r[0] = (x[1] - 0.3) * (x[1] - 0.3);
                                       r[1] = s * x[0];
                                     });
    const auto better = test::Stage(p).polished({0.4999, 0.301});
    CAPTURE(s);
    REQUIRE(better);
    CHECK((*better)[0] == Approx(0.5).margin(kExact));
    CHECK((*better)[1] == Approx(0.3).margin(kExact));
  }
}

TEST_CASE("a design beside a front is led to the nearest point of it, not to that of its weights",
          "[optim][polish][pareto][closed_form]") {
  // Squared distances from (0, 0) and (1, 0), in a box 0.2 wide at whose start both slopes are as
  // large: the point of the front with weights (1 - t, t) is (t, 0).
  const Problem p = test::posed<2>(
      {{"x", 0.3, 0.5, 0.5}, {"y", -0.1, 0.1, 0.01}}, {},
      [](const D* x, D* r) {
        r[0] = x[0] * x[0] + x[1] * x[1];
        r[1] = (x[0] - 1.0) * (x[0] - 1.0) + x[1] * x[1];
      },
      2);
  for (const double off : {0.005, -0.005}) {
    const auto nearest = test::Stage(p).polished({0.4, 0.001}, {0.6 - off, 0.4 + off});
    CAPTURE(off);
    REQUIRE(nearest);
    // Stationary are the pairs of a place t and a weight t. The shortest way to one of them is
    // perpendicular in scaled places and weights. The size of x is its range 0.2, as a power of two 1/4:
    // u / 4 + (a weight) = off, of which u takes 0.25 off / (1 + 0.25^2), times 0.25 in x. What a step neglects is the
    // product of both shares, less than off^2.
    CHECK((*nearest)[0] - 0.4 == Approx(off * 0.0625 / 1.0625).margin(off * off));
    CHECK((*nearest)[1] == Approx(0.0).margin(kExact));
  }
}

TEST_CASE("curvature counts on the critical cone only, and on all of it (O4.1)",
          "[optim][certificate][closed_form]") {
  // -2 x y on the quadrant x, y >= 0: curvature -1 along (1, 1), none along the axes.
  Eigen::MatrixXd saddle(2, 2);
  saddle << 0.0, -1.0, -1.0, 0.0;
  const Eigen::MatrixXd none(2, 0), quadrant = Eigen::MatrixXd::Identity(2, 2);
  const ConeCurvature within = cone_curvature(saddle, {none, quadrant}, 1e-9);
  CHECK(within.decided);
  CHECK(within.smallest == Approx(-1.0).epsilon(1e-14));
  REQUIRE(within.direction.size() == 2);
  CHECK(within.direction[0] == Approx(within.direction[1]).epsilon(1e-14));
  CHECK(within.direction[0] > 0.0);
  // + 2 x y: the same eigenvalues, but the direction (1, -1) leaves the quadrant.
  const ConeCurvature outside = cone_curvature(-saddle, {none, quadrant}, 1e-9);
  CHECK(outside.smallest == 0.0);
  CHECK(outside.direction.size() == 0);
  // Held by a multiplier, an axis leaves nothing of it.
  const ConeCurvature held =
      cone_curvature(saddle, {quadrant.leftCols(1), quadrant.rightCols(1)}, 1e-9);
  CHECK(held.direction.size() == 0);
  // x^2 - 3 x y + y^2 has curvature -1 along (1, 1); x^2 + 5 x y - 3/2 y^2 has its least on the axis x = 0.
  Eigen::MatrixXd h(2, 2);
  h << 2.0, -3.0, -3.0, 2.0;
  CHECK(cone_curvature(h, {none, quadrant}, 1e-9).smallest == Approx(-1.0).epsilon(1e-14));
  h << 2.0, 5.0, 5.0, -3.0;
  CHECK(cone_curvature(h, {none, quadrant}, 1e-9).smallest == Approx(-3.0).epsilon(1e-14));
}

TEST_CASE("a direction is flat in parts of the largest curvature", "[optim][certificate]") {
  Eigen::VectorXd diagonal(3);
  diagonal << 1e8, 10.0, 1e8;
  const ConeCurvature valley = free_curvature(diagonal);
  // Rounding of eigenvalues: 1e-16 of the largest.
  CHECK(valley.smallest == Approx(10.0).epsilon(1e-8));
  REQUIRE(valley.flat.cols() == 1);
  CHECK(std::abs(valley.flat(1, 0)) == Approx(1.0).epsilon(1e-12));
  const ConeCurvature bowl = free_curvature(Eigen::Vector2d(1e8, 1e4));
  CHECK(bowl.smallest == Approx(1e4).epsilon(1e-11));
  CHECK(bowl.flat.cols() == 0);
}
