// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"
#include "studies/statistics/study_text.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

// On its plateau the elastic motor has the stall torque mu F_N r: a product, whose indices are known, and
// in which the amplitude has no influence.
namespace {

using namespace twum::studies;
using twum::test::Coverage;
using twum::test::run;

constexpr double kRadius = 0.0265;

struct Uniform {
  double min;
  double max;
  double mean() const { return (min + max) / 2; }
  double variance() const { return (max - min) * (max - min) / 12; }
  double square() const { return variance() + mean() * mean(); }
};
constexpr Uniform kPreload{120, 160};
constexpr Uniform kFriction{0.15, 0.2};

const std::string kVariables =
    "  variables:\n"
    "    amplitude: {min: 1.5 um, max: 1.8 um}\n"
    "    preload: {min: 120 N, max: 160 N}\n"
    "    kinetic_friction: {min: 0.15, max: 0.2}\n";

double torque_variance() {
  const double mean = kPreload.mean() * kFriction.mean();
  return kPreload.square() * kFriction.square() - mean * mean;
}

const SensitivityResult& sensitivity(const StudyResult& result) {
  return std::get<SensitivityResult>(result.answer);
}

template <typename Effects>
const Effects& effects_of(const SensitivityResult& result, std::size_t metric = 0) {
  return std::get<Effects>(result.metrics.at(metric).effects);
}

bool inside(const Estimate& e, double truth) { return e.low <= truth && truth <= e.high; }

}  // namespace

TEST_CASE("Sobol indices of a motor on its plateau are those of a product",
          "[studies][sensitivity]") {
  const StudyResult result =
      run("  kind: sensitivity\n  method: sobol\n  samples: 1024\n  confidence: 0.99999\n" +
          kVariables + "  metrics: [stall_torque]\n");
  CHECK(result.outcome == "done");
  CHECK(result.evaluations == 1024 * 5);
  const SensitivityResult& answer = sensitivity(result);
  const auto& shares = effects_of<MetricSensitivity::Sobol>(answer);
  const double v = torque_variance();
  const double first[] = {0, kPreload.variance() * kFriction.mean() * kFriction.mean() / v,
                          kFriction.variance() * kPreload.mean() * kPreload.mean() / v};
  const double total[] = {0, kPreload.variance() * kFriction.square() / v,
                          kFriction.variance() * kPreload.square() / v};
  for (std::size_t j = 1; j < 3; ++j) {
    CHECK(inside(shares[j].first, first[j]));
    CHECK(inside(shares[j].total, total[j]));
    // E[(dT/du)^2] = (max - min)^2 E[other^2] = 12 V_j E[other^2]: the bound is 12 / pi^2 of the index.
    CHECK(
        inside(shares[j].derivative_bound, 12 / (std::numbers::pi * std::numbers::pi) * total[j]));
  }
  // The torque does not know the amplitude: its index is that of rounding, 1e-12 squared or less.
  CHECK(std::abs(shares[0].total.value) < 1e-20);
  CHECK(answer.metrics[0].value ==
        Approx(kRadius * kPreload.mean() * kFriction.mean()).epsilon(0.01));
}

TEST_CASE("Sobol rounds double until the intervals are narrow", "[studies][sensitivity]") {
  const std::string start = "  kind: sensitivity\n  method: sobol\n  samples: 256\n" + kVariables +
                            "  metrics: [stall_torque]\n";
  const StudyResult narrow = run(start + "  width: 0.05\n");
  CHECK(sensitivity(narrow).narrow);
  CHECK(widest(effects_of<MetricSensitivity::Sobol>(sensitivity(narrow))) <= 0.05);
  CHECK(sensitivity(narrow).samples > 256);
  CHECK(narrow.evaluations == 5 * sensitivity(narrow).samples);
  // Rounds are the same points as one study of as many samples.
  const StudyResult once = run("  kind: sensitivity\n  method: sobol\n  samples: " +
                               std::to_string(sensitivity(narrow).samples) + "\n" + kVariables +
                               "  metrics: [stall_torque]\n");
  CHECK(effects_of<MetricSensitivity::Sobol>(sensitivity(once))[1].first.value ==
        effects_of<MetricSensitivity::Sobol>(sensitivity(narrow))[1].first.value);
  const StudyResult capped = run(start + "  width: 0.0001\n  max_samples: 1024\n");
  CHECK_FALSE(sensitivity(capped).narrow);
  CHECK(sensitivity(capped).samples == 1024);
}

TEST_CASE("elementary effects of a motor on its plateau are those of a product",
          "[studies][sensitivity]") {
  const StudyResult result =
      run("  kind: sensitivity\n  method: morris\n  samples: 200\n  confidence: 0.99999\n" +
          kVariables + "  metrics: [stall_torque]\n");
  CHECK(result.evaluations == 200 * 4);
  const auto& torque = effects_of<MetricSensitivity::Morris>(sensitivity(result));
  // The effect of one factor is its range times the other factor, whose mean over levels is its mean.
  CHECK(inside(torque[1].mu_star, kRadius * 40 * kFriction.mean()));
  CHECK(inside(torque[2].mu_star, kRadius * 0.05 * kPreload.mean()));
  CHECK(torque[0].mu_star.value < 1e-10);
  // Spread over four even levels of a range is sqrt(5) / 6 of it.
  CHECK(inside(torque[1].sigma, kRadius * 40 * 0.05 * std::sqrt(5.0) / 6));
}

TEST_CASE("elementary effects of a metric that is linear are exact", "[studies][sensitivity]") {
  const StudyResult result =
      run("  kind: sensitivity\n  method: morris\n  variables:\n"
          "    preload: {min: 120 N, max: 160 N}\n  metrics: [holding_torque, no_load_speed]\n");
  CHECK(result.evaluations == 32 * 2);
  // mu_0 F r, to rounding over a step of two thirds of the range.
  const auto& torque = effects_of<MetricSensitivity::Morris>(sensitivity(result));
  CHECK(torque[0].mu == Approx(0.2 * kRadius * 40).epsilon(1e-12));
  CHECK(torque[0].mu_star.value == Approx(0.2 * kRadius * 40).epsilon(1e-12));
  CHECK(torque[0].sigma.value == Approx(0).margin(1e-13));
  CHECK(effects_of<MetricSensitivity::Morris>(sensitivity(result), 1)[0].mu < 0);
}

TEST_CASE("local sensitivities of a motor on its plateau", "[studies][sensitivity]") {
  const StudyResult result =
      run("  kind: sensitivity\n  method: local\n  variables:\n"
          "    preload: {min: 100 N, max: 200 N, start: 150 N}\n"
          "    kinetic_friction: {min: 0.1, max: 0.3}\n"
          "    contact_radius: {min: 20 mm, max: 30 mm}\n"
          "    amplitude: {min: 1.5 um, max: 1.8 um}\n"
          "  metrics: [stall_torque, no_load_speed]\n");
  CHECK(result.evaluations == 1);
  const SensitivityResult& answer = sensitivity(result);
  const auto& torque = effects_of<MetricSensitivity::Local>(answer);
  // T = mu F r, and the metric comes from a closed form: relative accuracy 1e-10.
  CHECK(torque[0].gradient == Approx(0.2 * kRadius).epsilon(1e-10));
  CHECK(torque[1].gradient == Approx(150 * kRadius).epsilon(1e-10));
  for (std::size_t j = 0; j < 3; ++j) CHECK(torque[j].elasticity == Approx(1).epsilon(1e-10));
  CHECK(torque[3].gradient == 0);
  CHECK(answer.metrics[0].smoothness == twum::Smoothness::flat);
  CHECK(answer.metrics[1].smoothness == twum::Smoothness::smooth);
  // Friction does not enter the speed at which an elastic layer drives nothing.
  const auto& speed = effects_of<MetricSensitivity::Local>(answer, 1);
  CHECK(speed[0].elasticity < 0);
  CHECK(speed[3].elasticity > 0);
}

TEST_CASE("a box where too many motors have no value has no indices", "[studies][sensitivity]") {
  // Preload and friction of the box allow 0.48 to 0.85 N.m: many motors cannot carry 0.6 N.m.
  const StudyResult result = run("  kind: sensitivity\n  method: sobol\n  samples: 256\n" +
                                 kVariables + "  metrics: [speed_at(0.6 N.m), stall_torque]\n");
  const SensitivityResult& answer = sensitivity(result);
  CHECK(result.outcome == "done");
  CHECK(answer.metrics[0].dropped > 26);
  CHECK(answer.metrics[0].dropped + answer.metrics[0].samples == 256);
  CHECK(std::visit([](const auto& e) { return e.empty(); }, answer.metrics[0].effects));
  CHECK_FALSE(answer.metrics[0].note.empty());
  // The other metric of the same motors keeps all of its blocks.
  CHECK(answer.metrics[1].dropped == 0);
  CHECK(effects_of<MetricSensitivity::Sobol>(answer, 1).size() == 3);
}

TEST_CASE("sensitivity studies do not depend on the number of threads", "[studies][sensitivity]") {
  for (const char* method : {"local", "morris", "sobol"}) {
    const std::string entries = std::string("  kind: sensitivity\n  method: ") + method + "\n" +
                                kVariables + "  metrics: [peak_power]\n";
    const std::string one = twum::test::timeless_summary(run(entries, 1));
    CHECK(one == twum::test::timeless_summary(run(entries, 2)));
    CHECK(one == twum::test::timeless_summary(run(entries, 8)));
  }
}

TEST_CASE(
    "tolerances in place of ranges give the scatter of a metric, to first order and by variance",
    "[studies][sensitivity]") {
  const std::string entries =
      "  kind: sensitivity\n  tolerances: {preload: 3 %, kinetic_friction: 10 %, thickness: 2 %}\n"
      "  metrics: [stall_torque]\n  method: ";
  // On the plateau the torque is mu F r, with mu = 0.2, F = 160 N, r = 26.5 mm.
  constexpr double kTorque = 0.2 * 160 * 0.0265;
  const auto local = std::get<SensitivityResult>(twum::test::run(entries + "local\n").answer);
  CHECK(local.tolerances);
  const auto& effects = std::get<MetricSensitivity::Local>(local.metrics[0].effects);
  // Derivatives are exact to rounding; the standard deviation of a law is a sum over 328 points, exact to 1e-10.
  CHECK(effects[0].spread == Approx(0.03 * kTorque).epsilon(1e-9));
  CHECK(effects[1].spread == Approx(0.1 * kTorque).epsilon(1e-9));
  CHECK(effects[2].spread == Approx(0).margin(1e-9 * kTorque));
  CHECK(local.metrics[0].sd == Approx(std::hypot(0.03, 0.1) * kTorque).epsilon(1e-9));

  // A product of independent numbers with the relative variances a and b has the variance a + b + a b.
  const auto sobol = std::get<SensitivityResult>(twum::test::run(entries + "sobol\n").answer);
  const auto& shares = std::get<MetricSensitivity::Sobol>(sobol.metrics[0].effects);
  constexpr double a = 0.03 * 0.03, b = 0.1 * 0.1, all = a + b + a * b;
  const auto holds = [](const Estimate& share, double exact) {
    // Twice the half width is 6.4 standard errors of Student's t with 3 degrees of freedom: one of 130; the seed is fixed.
    CHECK(std::abs(share.value - exact) <= 2 * (share.high - share.value));
    CHECK(share.high - share.value < 0.02);
  };
  holds(shares[0].first, a / all);
  holds(shares[1].first, b / all);
  holds(shares[0].total, (a + a * b) / all);
  holds(shares[1].total, (b + a * b) / all);
  CHECK(shares[2].total.value == 0);
  // The bound of a linear function of a normal number is its share: E[(df/dz)^2] / V.
  CHECK(shares[1].derivative_bound.value == Approx((b + a * b) / all).epsilon(0.02));
}
