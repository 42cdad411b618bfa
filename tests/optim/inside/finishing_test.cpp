// SPDX-License-Identifier: Apache-2.0
// The parts of a certificate and the Newton steps that finish an answer, each by its definition.
#include "certificate/certify.hpp"
#include "certificate/nnls.hpp"
#include "polished_stage.hpp"
#include "problem/nlp.hpp"

#include "optim/bank/posed.hpp"

#include <twum/optim/certify.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;
using Eigen::Index;

Problem bowl() {
  return test::posed<2>(test::box(2, -3.0, 3.0, {2.0, 2.5}), {}, [](const D* x, D* r) {
    r[0] = (x[0] - 1.0) * (x[0] - 1.0) + 2.0 * (x[1] - 0.5) * (x[1] - 0.5) + 1.0;
  });
}

// Least distance from (2, 1) with x <= 1, where the slope of 1 + sqrt |1 - x| <= most does not exist. The best design is (1, 1).
Problem distance_beside_a_cusp(double most) {
  Problem p;
  p.variables = {{"x", -2.0, 3.0, 1.0}, {"y", -3.0, 3.0, 0.0}};
  p.objectives = {{"f"}};
  p.constraints = {{"x", -kInfinity, 1.0}, {"cusp", -kInfinity, most}};
  p.evaluate = [](std::span<const double> z, bool) {
    const double x = z[0] - 2, y = z[1] - 1, root = std::sqrt(std::fabs(1 - z[0]));
    const double slope =
        root > 0 ? std::copysign(0.5 / root, z[0] - 1) : std::numeric_limits<double>::quiet_NaN();
    return Evaluation{{x * x + y * y, z[0], 1 + root}, {2 * x, 2 * y, 1, 0, slope, 0}, {}, {}};
  };
  return p;
}

// Nobody can do better: no column outside the solution pulls, and none inside.
void check_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double tolerance) {
  const Eigen::VectorXd x =
      nonnegative_least_squares(a, b, std::vector<bool>(static_cast<std::size_t>(a.cols()), false));
  const Eigen::VectorXd pull = a.transpose() * (b - a * x);
  for (Index j = 0; j < a.cols(); ++j) {
    CAPTURE(j, x[j], pull[j]);
    CHECK(x[j] >= 0.0);
    CHECK(pull[j] <= tolerance);
    if (x[j] > 0.0) CHECK(pull[j] >= -tolerance);
  }
}

}  // namespace

TEST_CASE("non-negative least squares meets its conditions of optimality",
          "[optim][nnls][identity]") {
  std::mt19937_64 bits(7);
  for (Index columns = 1; columns <= 12; ++columns) {
    for (const Index rows : {2, 5, 12}) {
      const auto number = [&] { return static_cast<double>(bits() >> 11U) * 0x1.0p-52 - 1.0; };
      Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(rows, columns, number);
      a.colwise().normalize();
      // Rounding of a few hundred operations on numbers near 1.
      check_least_squares(a, Eigen::VectorXd::NullaryExpr(rows, number), 1e-12);
    }
  }
}

TEST_CASE("columns that all but cancel each other are all used", "[optim][nnls][closed_form]") {
  // The solution is (1e6, 1e6): the sum of the columns is 1e-5 high.
  const double angle = 1e-5;
  Eigen::MatrixXd a(2, 2);
  a << 1.0, -std::cos(angle), 0.0, std::sin(angle);
  const Eigen::VectorXd b = 1e6 * (a.col(0) + a.col(1));
  const Eigen::VectorXd x = nonnegative_least_squares(a, b, {false, false});
  // Rounding 1e-16 times the condition 1e5 squared.
  for (const Index j : {0, 1}) CHECK(x[j] == Approx(1e6).epsilon(1e-5));
}

TEST_CASE("as many directions are flat as the Hessian has zero eigenvalues",
          "[optim][certificate][closed_form]") {
  for (Index n = 1; n <= 6; ++n) {
    for (Index flat = 0; flat <= n; ++flat) {
      Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(n, 3.0);
      diagonal.head(flat).setZero();
      const Eigen::MatrixXd hessian = diagonal.asDiagonal(), none(n, 0);
      const ConeCurvature cone = cone_curvature(hessian, {none, none}, 1e-9);
      CAPTURE(n, flat);
      REQUIRE(cone.flat.cols() == flat);
      CHECK(cone.smallest == (flat > 0 ? 0.0 : 3.0));
      CHECK((hessian * cone.flat).norm() == 0.0);
    }
  }
}

TEST_CASE("a certificate costs no more than it says", "[optim][certificate][budget]") {
  // Curvature asks for two neighbours of each variable, kinks as well; the check of the Jacobian for two values on a line.
  for (const std::size_t n : {1U, 2U}) {
    const Problem smooth =
        test::posed<2>(test::box(n, -3.0, 3.0, {2.0, 2.5}), {}, [n](const D* x, D* r) {
          r[0] = D(1.0);
          for (std::size_t i = 0; i < n; ++i) r[0] = r[0] + x[i] * x[i];
        });
    test::Stage stage(smooth, certificate_cost(n));
    CHECK(certify_in(stage.session, stage.scaling, Design(n, 0.0))->certificate.curvature > 0.5);
    CHECK(stage.session.counters().evaluations == 2 * n + 3);
  }
}

TEST_CASE("slopes and factors of the unit box", "[optim][closed_form]") {
  const Problem p = test::posed<2>({{"still", 2.0, 2.0}, {"x", 0.5, 40.0, 3.0, Scale::log}}, {},
                                   [](const D* x, D* r) { r[0] = 5.0 * x[1]; });
  test::Stage stage(p);
  CHECK(stage.scaling.size() == 1);
  CHECK(stage.scaling.variable(0) == 1);
  // x = 0.5 * 80^u, so dx/du = x log 80; two roundings.
  for (const double x : {0.5, 3.0, 40.0})
    CHECK(stage.scaling.slope(0, Design{2.0, x}) == Approx(x * std::log(80.0)).epsilon(1e-14));
  CHECK(stage.scaling.factor(0) == Approx(1.0 / (15.0 * std::log(80.0))).epsilon(1e-14));
}

TEST_CASE("Newton steps bring a near optimum to machine precision",
          "[optim][polish][closed_form]") {
  // Polishing ends where the scaled slope is 1e-11; the curvatures here are about 1 of that scale,
  // the boxes up to 6 wide.
  constexpr double kExact = 1e-9;
  const Problem well = test::posed<2>(test::box(1, -3.0, 3.0, {2.0}), {},
                                      [](const D* x, D* r) { r[0] = exp(x[0]) - 2.0 * x[0]; });
  for (const double off : {1e-3, -1e-3, 1e-6}) {
    const auto bottom = test::Stage(well).polished({std::log(2.0) + off});
    REQUIRE(bottom);
    CHECK((*bottom)[0] == Approx(std::log(2.0)).margin(kExact));
  }
  const Problem held =
      test::posed<2>(test::box(2, -3.0, 3.0, {2.0, 2.5}), {{"sum", 2.0}}, [](const D* x, D* r) {
        r[0] = x[0] * x[0] + x[1] * x[1];
        r[1] = x[0] + x[1];
      });
  for (const double off : {1e-3, -1e-3, 1e-5}) {  // inside the limit, and beyond it
    const auto nearest = test::Stage(held).polished({1.0 + off, 1.0 + 2.0 * off});
    CAPTURE(off);
    REQUIRE(nearest);
    for (const double x : *nearest) CHECK(x == Approx(1.0).margin(kExact));
  }
}

TEST_CASE("a bound that holds a finished answer is met to the last bit",
          "[optim][polish][identity]") {
  for (const double upper : {13.07, 4.51, 1.82, 14.1, 0.3, 7.7, 1.1}) {
    for (const Scale scale : {Scale::linear, Scale::log}) {
      for (const bool top : {true, false}) {
        const double lower = upper / 9.7, held = top ? upper : lower, pull = top ? -1.0 : 1.0;
        const Problem p = test::posed<2>(
            {{"x", lower, upper, std::sqrt(lower * upper), scale}, {"y", -1.0, 2.0, 1.5}}, {},
            [=](const D* x, D* r) {
              const D t = x[1] - 0.3 * x[0] / upper;
              r[0] = pull * 400.0 * x[0] / upper + 300.0 * t * t;
            });
        for (const double off : {1e-7, 5e-8, 2e-8}) {
          const double x = held + pull * off * (upper - lower);
          const auto better = test::Stage(p).polished({x, 0.3 * held / upper + 0.14});
          CAPTURE(upper, top, off, x);
          REQUIRE(better);
          CHECK((*better)[0] == held);
        }
      }
    }
  }
}

TEST_CASE("polishing leaves an optimum, and what Newton steps do not improve, as it is",
          "[optim][polish]") {
  CHECK_FALSE(test::Stage(bowl()).polished({1.0, 0.5}));
  // Of |x|^1.5 a Newton step leads from x to -x, which is no better.
  const Problem spike =
      test::posed<2>(test::box(2, -1.0, 1.0, {0.5, 0.5}), {}, [](const D* x, D* r) {
        const D size = x[0].v < 0.0 ? -x[0] : x[0];
        r[0] = size * sqrt(size) + x[1] * x[1];
      });
  CHECK_FALSE(test::Stage(spike).polished({0.01, 0.0}));
  const Problem still =
      test::posed<2>({{"x", 2.0, 2.0}}, {}, [](const D* x, D* r) { r[0] = x[0]; });
  CHECK_FALSE(test::Stage(still).polished({2.0}));
}

TEST_CASE("polishing takes what a quota has room for and no more", "[optim][polish][budget]") {
  // The design, two neighbours for each of two variables, and the step's end: 6 calls. A parabola
  // is finished by one step.
  const Problem p = bowl();
  for (std::size_t quota = 1; quota <= 8; ++quota) {
    test::Stage stage(p, quota);
    std::optional<Design> better;
    CAPTURE(quota);
    CHECK_NOTHROW(better = stage.polished({1.01, 0.51}));
    CHECK(better.has_value() == (quota >= 6));
    if (!better) continue;
    CHECK((*better)[0] == Approx(1.0).margin(1e-7));  // differences of exact slopes err by 1e-9
  }
}

TEST_CASE("a polished design of a front lies on it", "[optim][polish][pareto][closed_form]") {
  // Squared distances from (0, 0) and (1, 0): the front is y = 0, 0 <= x <= 1. Beyond its ends the
  // weights that balance the slopes have different signs.
  const Problem p = test::posed<2>(
      test::box(2, -2.0, 2.0, {0.5, 1.0}), {},
      [](const D* x, D* r) {
        r[0] = x[0] * x[0] + x[1] * x[1];
        r[1] = (x[0] - 1.0) * (x[0] - 1.0) + x[1] * x[1];
      },
      2);
  const auto inside = test::Stage(p).polished({0.4, 0.01}, {0.6, 0.4});
  REQUIRE(inside);
  CHECK((*inside)[1] == Approx(0.0).margin(1e-9));  // scaled slopes of 1e-11, in a box of 4
  // Only some weight of the other objective leads back to the front.
  int mended = 0, refused = 0;
  for (const double beyond : {0.005, 0.02, 0.05}) {
    for (const auto& [far, own] : {std::pair{false, 1.0}, std::pair{true, 1.0},
                                   std::pair{false, 0.9}, std::pair{true, 0.9}}) {
      const double x = far ? 1.0 + beyond : -beyond;
      const auto end =
          test::Stage(p).polished({x, 0.01}, far ? Design{1.0 - own, own} : Design{own, 1.0 - own});
      CAPTURE(x);
      ++(end ? mended : refused);
      if (!end) continue;  // it stays as it is
      CHECK((*end)[0] >= -1e-9);
      CHECK((*end)[0] <= 1.0 + 1e-9);
    }
  }
  CHECK(mended >= 6);
  CHECK(refused >= 6);
}

TEST_CASE("a limit that is kept needs no derivative, one that binds does",
          "[optim][certificate][polish]") {
  const Problem kept = distance_beside_a_cusp(3.0), binds = distance_beside_a_cusp(1.0);
  const Design start{1.0, 0.95}, best{1.0, 1.0};
  test::Stage stage(kept), other(binds);
  const Scaling scaling(kept);
  Nlp nlp(stage.session, scaling, plain_formulation(kept, scaling)),
      bound(other.session, scaling, plain_formulation(binds, scaling));
  const std::vector<double> at = scaling.to_unit(start);
  REQUIRE(nlp.at(at, true) != nullptr);
  CHECK(nlp.at(at, true)->dc[2] == 0.0);
  CHECK(bound.at(at, true) == nullptr);
  const auto polished = stage.polished(start);
  REQUIRE(polished);
  // Newton's step is exact for a quadratic but for the curvature from differences, 1e-9.
  CHECK((*polished)[1] == Approx(1.0).epsilon(1e-8));
  CHECK_FALSE(other.polished(start));
  CHECK(certify(kept, best).passed);
  CHECK(certify(binds, best).reason == "a derivative does not exist");
}
