// SPDX-License-Identifier: Apache-2.0
// A certificate is not given where values contradict the Jacobian, and never refused for that where the Jacobian is right.
#include "optim/bank/hock_schittkowski.hpp"
#include "optim/bank/posed.hpp"

#include <twum/optim/certify.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>

using namespace twum;
using namespace twum::optim;
using Catch::Contains;

namespace {

using Slopes = Dual<double, 3>;
using Design = std::vector<double>;

constexpr const char* kReason = "contradict its derivatives";

// One entry of the Jacobian times a factor.
Problem with_entry(Problem p, std::size_t entry, double factor) {
  p.evaluate = [=, right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    if (e.ok() && !e.jacobian.empty()) e.jacobian[entry] *= factor;
    return e;
  };
  return p;
}

// A number in [-1, 1] that is another one for each argument, however near: splitmix64 of its bits.
double scattered(double x, std::uint64_t seed) {
  std::uint64_t z = std::bit_cast<std::uint64_t>(x) + seed * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>(z ^ (z >> 31U)) / 0x1p63 - 1.0;
}

// Values with noise of this part of them, Jacobians without.
Problem noisy(Problem p, double part, std::uint64_t seed) {
  p.evaluate = [=, right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    double mixed = 0.0;
    for (const double one : x) mixed = 3.7 * mixed + one;
    for (std::size_t r = 0; r < e.values.size(); ++r)
      e.values[r] *= 1.0 + part * scattered(mixed, seed + r);
    return e;
  };
  return p;
}

// max(-x, slope x) + y^2: the slope in x jumps from -1 at x = 0, of which the evaluator gives one side alone.
Problem kinked(double slope) {
  return test::posed<3>({{"x", -1.0, 2.0}, {"y", -1.0, 2.0}}, {},
                        [slope](const Slopes* x, Slopes* r) {
                          r[0] = (x[0].v < 0.0 ? -1.0 : slope) * x[0] + x[1] * x[1];
                        });
}

// (x - a)^2 / a^2 + (y / b - 1)^2 with x y >= 2 a b, whose optimum has x / a = y / b = sqrt 2.
Problem scaled_by(double a, double b) {
  return test::posed<3>({{"x", 1e-3 * a, 1e3 * a, 3.0 * a}, {"y", 1e-3 * b, 1e3 * b, 3.0 * b}},
                        {{"area", 2.0 * a * b}}, [=](const Slopes* x, Slopes* r) {
                          const Slopes u = x[0] / a - 1.0, v = x[1] / b - 1.0;
                          r[0] = u * u + v * v;
                          r[1] = x[0] * x[1];
                        });
}

}  // namespace

TEST_CASE(
    "what is certified with a wrong entry of the Jacobian is optimal with the right one (O5.1)",
    "[optim][certificate]") {
  SolveOptions options;
  options.solver = "nlopt:slsqp";
  options.budget.evaluations = 2000;
  std::size_t certified = 0, refused = 0;
  for (const auto& known : test::hock_schittkowski()) {
    const std::size_t entries = known.problem.responses() * known.problem.variables.size();
    for (std::size_t entry = 0; entry < entries; ++entry) {
      for (const double factor : {-1.0, 0.0, 1.1}) {
        const Result r = solve(with_entry(known.problem, entry, factor), options);
        if (r.certificate.reason.find(kReason) != std::string::npos) ++refused;
        if (!r.certificate.passed) continue;
        ++certified;
        CAPTURE(known.name, entry, factor, r.design);
        CHECK(certify(known.problem, r.design).passed);
      }
    }
  }
  CHECK(refused > 100);
  CHECK(certified > 0);  // entries that are zero, of limits that do not matter
}

TEST_CASE("noise of the values alone never refuses a certificate", "[optim][certificate]") {
  const Problem right = scaled_by(1.0, 1.0);
  const Result optimum = solve(right);
  REQUIRE(optimum.certificate.passed);
  std::size_t contradicted = 0;
  for (int digits = 2; digits <= 14; ++digits)
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const Problem p = noisy(right, std::pow(10.0, -digits), seed);
      SolveOptions loose;
      loose.feasibility_tolerance = 0.5;  // the noise moves the value of the limit
      const Certificate c = certify(p, optimum.design, loose);
      if (c.reason.find(kReason) != std::string::npos) ++contradicted;
    }
  CHECK(contradicted == 0);
}

TEST_CASE("a kink is no contradiction, however near to the design it lies (O5.2)",
          "[optim][certificate]") {
  for (const double slope : {-0.5, 0.5, 20.0})
    for (const double x : {0.0, 1e-15, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
      for (const double sign : {1.0, -1.0}) {
        const Certificate c = certify(kinked(slope), Design{sign * x, 0.0});
        CAPTURE(slope, sign * x, c.reason);
        CHECK_THAT(c.reason, !Contains(kReason));
      }
}

TEST_CASE("variables of any size keep their certificate, and wrong signs lose it",
          "[optim][certificate][scaling]") {
  for (const double a : {1e-9, 1.0, 1e9})
    for (const double b : {1e-9, 1.0, 1e9}) {
      const Result right = solve(scaled_by(a, b));
      CAPTURE(a, b, right.certificate.reason);
      CHECK(right.certificate.passed);
      for (std::size_t entry = 0; entry < 4; ++entry) {
        const Result wrong = solve(with_entry(scaled_by(a, b), entry, -1.0));
        CAPTURE(entry, wrong.design);
        CHECK_FALSE(wrong.certificate.passed);
      }
    }
}

TEST_CASE("a front with a wrong sign is not certified", "[optim][certificate][pareto]") {
  const Problem right = test::posed<3>(
      {{"x", -1.0, 2.0}, {"y", -1.0, 2.0}}, {},
      [](const Slopes* x, Slopes* r) {
        r[0] = x[0] * x[0] + x[1] * x[1];
        const Slopes far = x[0] - 1.0;
        r[1] = far * far + 2.0 * x[1] * x[1];
      },
      2);
  ParetoOptions few;
  few.points = 5;
  const Front front = pareto_front(right, few);
  CHECK(front.outcome == Outcome::optimal);
  for (const std::size_t entry : {0U, 2U}) {
    const Front wrong = pareto_front(with_entry(right, entry, -1.0), few);
    for (const auto& point : wrong.points) {
      CAPTURE(entry, point.design);
      CHECK((!point.certificate.passed || certify(right, point.design).passed));
    }
  }
}
