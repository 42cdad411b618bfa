// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/optim/random_input.hpp>

#include <cmath>
#include <vector>

namespace {

using twum::optim::Law;
using twum::optim::RandomInput;

RandomInput input(Law law, double spread, double above, bool relative) {
  return {"p", law, spread, above, relative, {}, 0.0};
}

const std::vector<RandomInput> kInputs{
    input(Law::normal, 0.03, 0, true),      input(Law::normal, 2.0, 0, false),
    input(Law::lognormal, 0.1, 0, true),    input(Law::lognormal, 16.0, 0, false),
    input(Law::uniform, 0.05, 0, true),     input(Law::uniform, 8.0, 0, false),
    input(Law::triangular, 0.1, 0.2, true), input(Law::triangular, 16.0, 8.0, false)};

// E[f(P)] by the trapezoid rule on |z| <= 8, which converges beyond any power for the smooth laws; a triangle's kink
// at its mode leaves h^2.
template <typename F>
double expectation(const RandomInput& law, double x, F f) {
  constexpr int kSteps = 16000;
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double z = -8.0 + 16.0 * i / kSteps;
    const double w = std::exp(-0.5 * z * z);
    sum += w * f(law.at(x, z).value);
    weights += w;
  }
  return sum / weights;
}

}  // namespace

TEST_CASE("mean and spread of a built input are those of its law (U1.1 to U1.4)",
          "[optim][robust]") {
  struct Case {
    RandomInput law;
    double mean, variance;  // textbook moments at x = 160
  };
  const double x = 160;
  const std::vector<Case> cases{
      {input(Law::normal, 0.03, 0, true), x, 4.8 * 4.8},
      {input(Law::lognormal, 0.1, 0, true), x, 256},
      {input(Law::lognormal, 16, 0, false), x, 256},
      {input(Law::uniform, 0.05, 0, true), x, 64.0 / 3.0},
      // mode x, a = 16 below and b = 32 above: mean x + (b - a) / 3, variance (a^2 + b^2 + a b) / 18
      {input(Law::triangular, 0.1, 0.2, true), x + 16.0 / 3.0, (256.0 + 1024 + 512) / 18}};
  for (const Case& c : cases) {
    CAPTURE(static_cast<int>(c.law.law), c.law.relative);
    const double mean = expectation(c.law, x, [](double p) { return p; });
    const double variance =
        expectation(c.law, x, [&](double p) { return (p - mean) * (p - mean); });
    // The triangle's kink: h^2 times the jump of slope, 1e-6 of the width; the others are exact to rounding.
    CHECK(mean == Approx(c.mean).epsilon(1e-7));
    CHECK(variance == Approx(c.variance).epsilon(1e-5));
  }
}

TEST_CASE("derivatives of a built input agree with differences (U1.5, U1.6, U1.7)",
          "[optim][robust]") {
  const double x = 160, h = 1e-5;
  for (const RandomInput& law : kInputs) {
    // z = -0.43 is the mode of the second triangle's neighbour, so no point sits on a kink.
    for (const double z : {-3.1, -0.7, 0.2, 2.4}) {
      CAPTURE(static_cast<int>(law.law), law.relative, z);
      const auto at = law.at(x, z);
      const auto scaled = [&](double factor) {
        RandomInput other = law;
        other.spread *= factor;
        other.above *= factor;
        return other.at(x, z).value;
      };
      const double by_x =
          (law.at(x * (1 + h), z).value - law.at(x * (1 - h), z).value) / (2 * h * x);
      const double by_z = (law.at(x, z + h).value - law.at(x, z - h).value) / (2 * h);
      const double by_s = (scaled(1 + h) - scaled(1 - h)) / (2 * h);
      // Central differences: h^2 = 1e-10 of the third derivative, and rounding 160 eps / h = 4e-9.
      CHECK(at.by_design == Approx(by_x).epsilon(1e-7).margin(1e-8));
      CHECK(at.by_normal == Approx(by_z).epsilon(1e-7).margin(1e-7));
      CHECK(at.by_spread == Approx(by_s).epsilon(1e-7).margin(1e-7));
    }
  }
}

TEST_CASE("bounded laws stay within their ends in the far tails", "[optim][robust]") {
  const auto uniform = input(Law::uniform, 0.05, 0, true);
  const auto triangle = input(Law::triangular, 0.1, 0.2, true);
  for (const double z : {8.2, 20.0}) {
    CHECK(uniform.at(100, z).value <= 105.0);
    CHECK(uniform.at(100, -z).value >= 95.0);
    CHECK(triangle.at(100, z).value <= 120.0);
    CHECK(triangle.at(100, -z).value >= 90.0);
    // phi(8.2) is 1e-15: what is left of the width is of that size, for a triangle its root.
    CHECK(uniform.at(100, z).value == Approx(105.0).epsilon(1e-14));
    CHECK(triangle.at(100, z).value == Approx(120.0).epsilon(1e-7));
  }
}
