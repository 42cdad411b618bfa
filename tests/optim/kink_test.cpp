// SPDX-License-Identifier: Apache-2.0
// Kinks whose one-sided derivatives the evaluator tells, and names of solvers that do not exist.
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;

namespace {

constexpr double kPull = 3.0;   // of the second variable on the objective
constexpr double kLean = 0.5;   // of the third on the limit of the second
constexpr double kUnit = 1e-3;  // of the objective
constexpr double kRest = 2.0;   // where the third has its kink

// The objective falls by kPull with x2 and has the slopes left and right in x3 beside its kink; the
// limit is x2 - kLean x3 <= 4. Along it the slopes are left - kPull kLean and right - kPull kLean: a
// minimum, in this convex problem, where the first is below and the second above zero. x1 is fixed,
// x3 is searched on a logarithmic scale.
Problem hinged(double left, double right, bool maximize) {
  Problem p;
  p.variables = {{"x1", 3.0, 3.0}, {"x2", -10.0, 30.0, 1.0}, {"x3", 0.5, 8.0, 4.0, Scale::log}};
  p.objectives = {{"f", maximize ? Sense::maximize : Sense::minimize}};
  p.constraints = {{"leaning", -kInfinity, 4.0}, {"loose", -kInfinity, 50.0}};
  const double unit = maximize ? -kUnit : kUnit;
  p.evaluate = [=](std::span<const double> x, bool) {
    Evaluation e;
    const double s = x[2] - kRest, slope = s < 0.0 ? left : right;
    const double t = x[1] - 5.0;  // |x2 - 5| has a kink at the optimum too, and matters to nobody
    e.values = {unit * (slope * s - kPull * x[1]), x[1] - kLean * x[2], std::abs(t)};
    e.jacobian = {0, -unit * kPull, unit * slope, 0, 1, -kLean, 0, t < 0 ? -1.0 : 1.0, 0};
    e.kinks.push_back({0, 1, Slope::smooth, -unit * kPull, -unit * kPull});
    if (s == 0.0) e.kinks.push_back({0, 2, Slope::one_sided, unit * left, unit * right});
    if (t == 0.0) e.kinks.push_back({2, 1, Slope::one_sided, -1.0, 1.0});
    return e;
  };
  return p;
}

// With calls for the start and the design and no more: what is told has to do.
Certificate certified(const Problem& p) {
  SolveOptions options;
  options.budget.evaluations = 2;
  return certify(p, std::vector<double>{3.0, 4.0 + kLean * kRest, kRest}, options);
}

void check_kink(const Certificate& c) {
  REQUIRE(c.findings.size() == 1);
  CHECK(c.findings[0].kind == Degeneracy::kink);
  CHECK(c.findings[0].names == std::vector<std::string>{"x3"});
}

std::string refusal(const std::string& name) {
  try {
    find_solver(name);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("kinks in two variables are not mixed into a certificate", "[optim][certificate]") {
  // |x + y| + (x - y) / 2 falls along (-1, 1), by 1 per unit, though each variable alone has slopes of both signs.
  Problem p;
  p.variables = {{"x", -1.0, 1.0, 0.5}, {"y", -1.0, 1.0, 0.25}};
  p.objectives = {{"f"}};
  p.evaluate = [](std::span<const double> x, bool) {
    Evaluation e;
    const double sum = x[0] + x[1], side = sum < 0 ? -1.0 : 1.0;
    e.values = {std::abs(sum) + 0.5 * (x[0] - x[1])};
    e.jacobian = {side + 0.5, side - 0.5};
    if (sum == 0) {
      e.kinks.push_back({0, 0, Slope::one_sided, -0.5, 1.5});
      e.kinks.push_back({0, 1, Slope::one_sided, -1.5, 0.5});
    }
    return e;
  };
  const Certificate c = certify(p, std::vector<double>{0.0, 0.0}, {});
  CHECK_FALSE(c.passed);
  CHECK(c.stationarity > 0.1);
}

TEST_CASE("a kink between the slopes that balance a limit is an optimum, with the limit's price",
          "[optim][certificate][kink]") {
  const bool maximize = GENERATE(false, true);
  const double balance = kPull * kLean;
  for (const auto& [left, right] :
       {std::pair{0.95 * balance, 1.05 * balance}, std::pair{-20.0, 1.01 * balance},
        std::pair{0.99 * balance, 40.0}}) {
    CAPTURE(maximize, left, right);
    const Certificate c = certified(hinged(left, right, maximize));
    CHECK(c.passed);
    check_kink(c);
    REQUIRE(c.limits.size() == 2);
    CHECK(c.limits[0].active);
    CHECK_FALSE(c.limits[1].active);
    // Of x2 alone, as x2 alone makes room; the rest is rounding of a least-squares solution.
    CHECK(c.limits[0].multiplier == Approx(kUnit * kPull).epsilon(1e-9));
  }
}

TEST_CASE("a kink that still falls on one side is none", "[optim][certificate][kink]") {
  const bool maximize = GENERATE(false, true);
  const double balance = kPull * kLean;
  for (const auto& [left, right] :
       {std::pair{1.05 * balance, 1.15 * balance}, std::pair{0.85 * balance, 0.95 * balance},
        std::pair{-40.0, -20.0}, std::pair{1.05 * balance, 0.95 * balance}}) {
    CAPTURE(maximize, left, right);
    const Certificate c = certified(hinged(left, right, maximize));
    CHECK_FALSE(c.passed);
    CHECK(c.reason == "not stationary: by its derivatives the objective can still improve");
    check_kink(c);
  }
}

TEST_CASE("a misspelt solver is answered with the name at most three letters from it",
          "[optim][error]") {
  const std::pair<const char*, const char*> meant[] = {
      {"nlopt:slsq", "nlopt:slsqp"},
      {"nlopt:slsqpp", "nlopt:slsqp"},
      {"nlopt:slsxp", "nlopt:slsqp"},
      {"lopt:mma", "nlopt:mma"},
      {"xnlopt:mma", "nlopt:mma"},
      {"nlopt:cobila", "nlopt:cobyla"},
      {"iptop", "ipopt"},
      {"mma", "nlopt:mma"},
      {"direct_l", "nlopt:direct_l"},
      {"nlopt:direct_m", "nlopt:direct_l"},
      {"a", "auto"},
      {"axyz", "auto"},
      {"xyzauto", "auto"},
      {"autoxyz", "auto"},
      {"xyto", "auto"},
      {"nlopt:tnewton_restar", "nlopt:tnewton_restart"}};
  for (const auto& [name, right] : meant)
    CHECK_THAT(refusal(name),
               Contains(std::string("unknown solver '") + name + "' (did you mean '" + right +
                        "'?); there are auto nlopt:slsqp"));
  // Four letters from auto, and further from every other.
  for (const std::string name : {"xyz", "wxyzauto", "autowxyz", "wxyz", ""})
    CHECK_THAT(refusal(name), Contains("unknown solver '" + name + "'; there are auto"));
}
