// SPDX-License-Identifier: Apache-2.0
// What the certificate of a design promises, on functions whose slopes are known by hand.
#include "optim/bank/posed.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;
using Names = std::vector<std::string>;

// A quotient of a few products of numbers near 1.
constexpr double kRounding = 1e-12;

Certificate certified(const Problem& p, const std::vector<double>& design,
                      std::size_t evaluations = 1000) {
  SolveOptions options;
  options.budget.evaluations = evaluations;
  return certify(p, design, options);
}

// |x - 2| + 5 in the first of two free variables, with both slopes told.
Problem told_kink(std::size_t free) {
  Problem p;
  p.variables = {{"x", 0.0, 4.0, 1.0}, {"y", -1.0, free > 1 ? 1.0 : -1.0, -1.0}};
  p.objectives = {{"f"}};
  p.evaluate = [](std::span<const double> x, bool) {
    Evaluation e;
    const double t = x[0] - 2.0;
    e.values = {std::abs(t) + 5.0 + 0.1 * x[1]};
    e.jacobian = {t < 0.0 ? -1.0 : 1.0, 0.1};
    if (t == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, -1.0, 1.0});
    return e;
  };
  return p;
}

}  // namespace

TEST_CASE("stationarity is the slope left over in parts of slope and curvature (O3.1, O3.2)",
          "[optim][certificate][closed_form]") {
  // (x - 1)^2 + 100 at x: for a step of the size x of the variable the slope is 2 (x - 1) x, and it changes by 2 x^2.
  // Neither the range nor the start matters.
  for (const double width : {4.0, 1e4, 1e10}) {
    for (const double start : {-3.0, 2.0}) {
      const Problem p = test::posed<3>({{"x", -width, width, start}}, {}, [](const D* x, D* r) {
        r[0] = (x[0] - 1.0) * (x[0] - 1.0) + 100.0;
      });
      for (const double x : {0.25, 1.5, 3.0}) {
        const double slope = std::abs(x - 1.0), size = std::max(slope, x);
        const Certificate c = certified(p, {x});
        CHECK(c.stationarity == Approx(slope / size).epsilon(1e-6));  // differences of slopes
        // A step of slope / curvature reaches the bottom if it is no longer than x (O3.3).
        if (x >= 1.0) CHECK(c.gain == Approx(slope * slope).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("a logarithmic scale is the linear one of the logarithm",
          "[optim][certificate][identity]") {
  using Case = std::vector<double>;  // in the linear problem's variables
  const double u = std::log(100.0), v = std::log(7.0);
  const auto f = [](const D& s, const D& t) { return exp(s) + 0.5 * exp(2.0 * t); };
  const Problem linear =
      test::posed<3>({{"s", 0.0, u, 0.5}, {"t", 0.0, v, 0.6}}, {{"sum", 0.0, 20.0}},
                     [&](const D* x, D* r) { r[0] = f(x[0], x[1]), r[1] = exp(x[0]) + exp(x[1]); });
  const Problem log = test::posed<3>(
      {{"x", 1.0, 100.0, std::exp(0.5), Scale::log}, {"y", 1.0, 7.0, std::exp(0.6), Scale::log}},
      {{"sum", 0.0, 20.0}},
      [](const D* x, D* r) { r[0] = x[0] + 0.5 * x[1] * x[1], r[1] = x[0] + x[1]; });
  // A magnitude of 1 is also the size of a variable on a log scale.
  for (const Case& at : {Case{1.0, 1.0}, Case{0.0, 1.0}, Case{1.0, 0.0}}) {
    const Certificate a = certified(linear, at);
    const Certificate b = certified(log, {std::exp(at[0]), std::exp(at[1])});
    CHECK(a.stationarity == Approx(b.stationarity).epsilon(kRounding));
    CHECK(a.stationarity > 0.01);
  }
}

TEST_CASE("a kink in a single variable is told once and has the weights of one objective",
          "[optim][certificate][kink]") {
  for (const std::size_t free : {1U, 2U}) {
    const Certificate c = certified(told_kink(free), {2.0, -1.0}, 2);
    CAPTURE(free, c.reason);
    CHECK(c.passed);
    REQUIRE(c.findings.size() == 1);
    CHECK(c.findings[0].kind == Degeneracy::kink);
    CHECK(c.findings[0].names == Names{"x"});
    CHECK(c.weights == std::vector<double>{1.0});
    CHECK(c.prices == std::vector<double>{1.0});
  }
}

TEST_CASE("a fixed variable needs no derivative", "[optim][certificate]") {
  // (x - 2)^2 + 3 has its minimum at 2 whatever is known of the variable that cannot move.
  Problem p = test::posed<3>({{"still", 1.0, 1.0}, {"x", 0.0, 5.0, 1.0}}, {},
                             [](const D* x, D* r) { r[0] = (x[1] - 2.0) * (x[1] - 2.0) + 3.0; });
  CHECK(certified(p, {1.0, 2.0}).findings.empty());
  p.evaluate = [smooth = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = smooth(x, gradient);
    e.kinks.push_back({0, 0, Slope::undefined, 0.0, 0.0});
    e.kinks.push_back({0, 0, Slope::one_sided, -1.0, 1.0});
    return e;
  };
  const Certificate c = certified(p, {1.0, 2.0});
  CHECK(c.passed);
  CHECK(c.findings.empty());
}

TEST_CASE("where nothing can move the design is stationary and its weights add up to one",
          "[optim][certificate]") {
  for (const std::size_t objectives : {1U, 2U, 3U}) {
    const Problem p = test::posed<3>(
        {{"x", 2.0, 2.0}, {"y", 3.0, 3.0}}, {},
        [=](const D* x, D* r) {
          for (std::size_t k = 0; k < objectives; ++k) r[k] = x[0] + x[1];
        },
        objectives);
    const Certificate c = certified(p, {2.0, 3.0});
    CHECK(c.passed);
    CHECK(c.findings.empty());
    double sum = 0.0;
    for (const double weight : c.weights) sum += weight;
    CHECK(c.weights.size() == objectives);
    CHECK(sum == Approx(1.0).epsilon(kRounding));
  }
}

TEST_CASE("a kink that nobody tells is named by its variable, and smooth ones are not",
          "[optim][certificate][kink]") {
  // 5 + 3 |x| + (y^2 - x^2) / 10 has its minimum at the origin, where x has a steeper slope than
  // at the start; the limit is far away, and steep.
  Problem p = test::posed<3>(test::box(2, -1.0, 1.0, {0.5, 0.5}), {{"far", -kInfinity, 100.0}},
                             [](const D* x, D* r) {
                               const D size = x[0].v < 0.0 ? -x[0] : x[0];
                               r[0] = 5.0 + 3.0 * size + 0.1 * (x[1] * x[1] - x[0] * x[0]);
                               r[1] = 7.0 * x[0] + 20.0 * x[1];
                             });
  const Certificate c = certified(p, {0.0, 0.0});
  CHECK(c.passed);
  REQUIRE(c.findings.size() == 1);
  CHECK(c.findings[0].kind == Degeneracy::kink);
  CHECK(c.findings[0].names == Names{"x1"});
}

TEST_CASE("only an objective without slope here and at the start is flat", "[optim][certificate]") {
  const std::vector<Variable> box = test::box(2, -1.0, 3.0, {2.0, 2.0});
  const std::vector<Constraint> limit{{"far", -kInfinity, 100.0}};
  for (const double level : {3.0, -4.0}) {  // the slope of the bowls vanishes at (1, 1), exactly
    const Problem bowl = test::posed<3>(box, limit, [=](const D* x, D* r) {
      r[0] = (x[0] - 1.0) * (x[0] - 1.0) + (x[1] - 1.0) * (x[1] - 1.0) + level;
      r[1] = 9.0 * x[0];
    });
    CHECK(certified(bowl, {1.0, 1.0}).passed);
    CHECK(certified(bowl, {1.0, 1.0}).findings.empty());
  }
  for (const double level : {0.0, 3.0, -4.0, 1e-3}) {
    const Problem flat = test::posed<3>(box, limit, [=](const D* x, D* r) {
      r[0] = D(level);
      r[1] = 9.0 * x[0];
    });
    const Certificate c = certified(flat, {1.0, 1.0});
    REQUIRE_FALSE(c.findings.empty());
    CHECK(c.findings[0].kind == Degeneracy::flat_objective);
    CHECK(c.findings[0].names == Names{"x1", "x2"});
  }
}

TEST_CASE("a budget without room for the curvature leaves it out and still certifies",
          "[optim][certificate][budget]") {
  // The design, and two neighbours for each of three variables: 7 calls.
  const Problem p =
      test::posed<3>(test::box(3, -1.0, 2.0, {2.0, 2.0, 2.0}), {}, [](const D* x, D* r) {
        r[0] = D(3.0);
        for (int i = 0; i < 3; ++i) r[0] = r[0] + (x[i] - 1.0) * (x[i] - 1.0);
      });
  for (std::size_t evaluations = 1; evaluations <= 9; ++evaluations) {
    const Certificate c = certified(p, {1.0, 1.0, 1.0}, evaluations);
    CAPTURE(evaluations, c.reason);
    CHECK(c.passed);
    CHECK(std::isnan(c.curvature) == (evaluations < 7));
    CHECK(c.second_order == (evaluations >= 7));
    // Of a sphere every curvature is the largest one; differences of exact slopes err by 1e-9.
    if (evaluations >= 7) CHECK(c.curvature == Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("a limit without slope where it is met takes no part", "[optim][certificate]") {
  // x^2 + y^2 >= 0 holds everywhere and is met at the minimum of x^2 + y^2 + 1, where it is flat.
  const Problem p =
      test::posed<3>(test::box(2, -1.0, 2.0, {1.0, 1.0}), {{"round", 0.0}}, [](const D* x, D* r) {
        r[1] = x[0] * x[0] + x[1] * x[1];
        r[0] = r[1] + 1.0;
      });
  const Certificate c = certified(p, {0.0, 0.0});
  CHECK(c.passed);
  CHECK(c.stationarity == 0.0);
  CHECK(c.limits[0].multiplier == 0.0);
}

TEST_CASE("a maximized objective that was taken back leaves no trace", "[optim][certificate]") {
  Problem p =
      test::posed<3>(test::box(2, -4.0, 4.0, {2.0, 3.0}), {{"sum", 2.0}}, [](const D* x, D* r) {
        r[0] = x[0] * x[0] + x[1] * x[1];
        r[1] = x[0] + x[1];
      });
  p.objectives.push_back({"second thought", Sense::maximize});
  p.objectives.pop_back();
  const Certificate c = certified(p, {1.0, 1.0});
  CHECK(c.passed);
  // f is least^2 / 2, whose slope at 2 is 2.
  CHECK(c.limits[0].multiplier == Approx(2.0).epsilon(kRounding));
}
