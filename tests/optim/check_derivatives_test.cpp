// SPDX-License-Identifier: Apache-2.0
// Wrong entries of a Jacobian are found by differences, right ones pass.
#include "optim/bank/dual_problem.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/check_derivatives.hpp>

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

using Pair = Dual<double, 2>;

// x^2 y and x + exp(y / 2), differentiated by dual numbers.
Problem smooth() {
  Problem p;
  p.variables = test::box(2, -3.0, 5.0, {2.0, 1.0});
  p.objectives = {{.name = "f"}};
  p.constraints = {{.name = "g", .upper = 100}};
  p.evaluate = test::dual_evaluator<2>(2, [](const Pair* x, Pair* r) {
    using std::exp;
    r[0] = x[0] * x[0] * x[1];
    r[1] = x[0] + exp(0.5 * x[1]);
  });
  return p;
}

// The same with one entry of the Jacobian changed.
Problem with_entry(std::size_t entry, double factor) {
  Problem p = smooth();
  p.evaluate = [=, right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    if (!e.jacobian.empty()) e.jacobian[entry] *= factor;
    return e;
  };
  return p;
}

const std::vector<double> kDesign{1.5, 2.0};

}  // namespace

TEST_CASE("a right Jacobian agrees with differences in the interior and at bounds",
          "[optim][derivatives]") {
  for (const std::vector<double>& design : {kDesign, {-3.0, 5.0}, {5.0, -3.0}}) {
    const auto checks = check_derivatives(smooth(), design);
    REQUIRE(checks.size() == 4);
    for (const DerivativeCheck& one : checks) {
      CAPTURE(one.response, one.variable, one.given, one.difference, one.uncertainty);
      CHECK(one.agrees);
    }
  }
}

TEST_CASE("each entry with a wrong sign or off by a thousandth is found, and no other",
          "[optim][derivatives]") {
  for (const double factor : {-1.0, 1.001}) {
    for (std::size_t entry = 0; entry < 4; ++entry) {
      CAPTURE(entry, factor);
      const auto checks = check_derivatives(with_entry(entry, factor), kDesign);
      REQUIRE(checks.size() == 4);
      for (std::size_t k = 0; k < 4; ++k) CHECK(checks[k].agrees == (k != entry));
      CHECK(checks[entry].response == (entry < 2 ? "f" : "g"));
    }
  }
}

TEST_CASE("entries that are known not to be smooth are left out", "[optim][derivatives]") {
  Problem p = smooth();
  p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    e.kinks.push_back({.response = 0, .variable = 1, .slope = Slope::undefined});
    return e;
  };
  CHECK(check_derivatives(p, kDesign).size() == 3);
}

TEST_CASE("a check of derivatives without a design is refused", "[optim][derivatives]") {
  CHECK_THROWS_AS(check_derivatives(smooth(), std::vector<double>{1.0}), InputError);
  Problem none = smooth();
  none.evaluate = [](std::span<const double>, bool) {
    return Evaluation{.values = {}, .jacobian = {}, .kinks = {}, .failure = "no answer"};
  };
  CHECK_THROWS_WITH(check_derivatives(none, kDesign), Catch::Contains("no answer"));
}
