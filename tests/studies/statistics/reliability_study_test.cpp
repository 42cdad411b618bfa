// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"
#include "studies/statistics/study_text.hpp"
#include "support/scratch_folder.hpp"

#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <variant>

// On its plateau the elastic motor has the stall torque mu F_N r exactly: with a lognormal preload and friction it is lognormal.
namespace {

using namespace twum::studies;
namespace test = twum::test;
using twum::test::run;

constexpr double kRadius = 0.0265, kPreload = 160, kFriction = 0.17;

double below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }
double log_variance(double ratio) { return std::log1p(ratio * ratio); }

const std::string kLognormal =
    "  kind: uncertainty\n"
    "  variables:\n"
    "    preload: {distribution: lognormal, sd: 3 %}\n"
    "    kinetic_friction: {distribution: lognormal, mean: 0.17, sd: 10 %}\n";

// The torque below which a motor lies with Phi(-index).
std::string torque_at(double index) {
  const double variance = log_variance(0.03) + log_variance(0.1);
  return std::to_string(kFriction * kPreload * kRadius *
                        std::exp(-variance / 2 - index * std::sqrt(variance))) +
         " N.m";
}

const UncertaintyResult& uncertainty(const StudyResult& result) {
  return std::get<UncertaintyResult>(result.answer);
}

std::string content(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Twice the half width is 4.3 standard errors of Student's t with 15 degrees of freedom: one of 1,500; the seed is fixed. The typed torque
// has 6 digits after the point, 1e-6 of it, which moves the share by 1e-5 times the index over the deviation of 0.1: less than 1e-3.
void check_share(const Estimate& share, double exact) {
  CAPTURE(share.value, share.low, share.high, exact);
  CHECK(std::abs(share.value - exact) <= 2 * (share.high - share.value));
  CHECK(share.high - share.value < 0.15 * exact);
}

}  // namespace

TEST_CASE("the share of motors with too little torque is exact down to 1e-9",
          "[studies][uncertainty][reliability]") {
  for (const double index : {3.0, 4.7534, 5.9978}) {  // 1.3e-3, 1e-6, 1e-9
    const StudyResult result =
        run(kLognormal + "  method: importance\n  limits: [stall_torque >= " + torque_at(index) +
            "]\n");
    CHECK(result.outcome == "done");
    CHECK(result.evaluations == 16384);
    const UncertaintyResult& answer = uncertainty(result);
    CHECK(answer.weighted);
    check_share(answer.broken, below(-index));
    check_share(answer.limits[0].broken, below(-index));
    CHECK(1 - answer.yield->value == Approx(answer.broken.value).margin(1e-15));
    // The design point of a plane in the logarithms; Newton's method ends within 1e-9, the torque is typed to 1e-6.
    CHECK(answer.limits[0].index == Approx(index).margin(1e-4));
    // The cause of failures is the share in the variance of the logarithm.
    REQUIRE(answer.limits[0].causes.size() == 2);
    const double share = log_variance(0.1) / (log_variance(0.1) + log_variance(0.03));
    check_share(answer.causes[1], share);
    CHECK(answer.causes[0].value + answer.causes[1].value == Approx(1).epsilon(1e-12));
    CHECK(answer.limits[0].likeliest[1] < kFriction);
  }
}

TEST_CASE("every law with a smooth quantile has its exact tail",
          "[studies][uncertainty][reliability]") {
  // A preload below c, by laws about 160 N.
  const auto share = [](const std::string& law, double c) {
    const StudyResult result = run(
        "  kind: uncertainty\n  method: importance\n  variables: {preload: " + law +
        "}\n  limits: [preload + 0 N * stall_torque / (1 N.m) >= " + std::to_string(c) + " N]\n");
    return uncertainty(result).broken;
  };
  check_share(share("8 N", 120), below(-5));
  // Uniform from 150 to 170 N: 1e-4 of it lies below 150.002 N.
  check_share(share("{range: 10 N}", 150.002), 1e-4);
  // Normal, 160 +- 4 N, cut at 140 N (5 deviations): below 142 N (4.5).
  check_share(share("{distribution: truncated, sd: 4 N, from: 140 N, to: 180 N}", 142),
              (below(-4.5) - below(-5)) / (1 - 2 * below(-5)));
  // Beta with the exponents 2, 2 between 150 and 170 N has the variance 20 N^2; F(x) = 3 x^2 - 2 x^3 of the share x.
  check_share(share("{distribution: beta, sd: 4.472135955 N, from: 150 N, to: 170 N}", 150.02),
              3e-6 - 2e-9);
}

TEST_CASE("several limits have a share each, also the rare one",
          "[studies][uncertainty][reliability]") {
  const StudyResult result =
      run("  kind: uncertainty\n  method: importance\n  variables: {preload: 5 N, thickness: 2 %}\n"
          "  limits: [\"145 N <= preload + 0 N * stall_torque / (1 N.m)\", \"preload + 0 N * "
          "stall_torque / (1 N.m) <= 187.5 N\"]\n");
  const UncertaintyResult& answer = uncertainty(result);
  check_share(answer.limits[0].broken, below(-3));
  check_share(answer.limits[1].broken, below(-5.5));
  check_share(answer.broken, below(-3) + below(-5.5));
}

TEST_CASE("weighted motors are the same for any number of threads, resumed or grown",
          "[studies][uncertainty][reliability]") {
  const std::string entries = kLognormal +
                              "  method: importance\n  limits: [stall_torque >= " + torque_at(4) +
                              "]\n  samples: ";
  const std::string few = test::timeless_summary(run(entries + "4096\n", 1));
  CHECK(test::timeless_summary(run(entries + "4096\n", 7)) == few);
  const test::ScratchFolder folder;
  const std::string directory = folder.path("grown");
  run_study(test::elastic_study(entries + "4096\n"), directory, {});
  const StudyResult grown = run_study(test::elastic_study(entries + "8192\n"), directory, {});
  CHECK(std::get<UncertaintyResult>(grown.answer).broken.value ==
        uncertainty(run(entries + "8192\n")).broken.value);
  const auto verified = verify_study(directory);
  CHECK(verified.holds());
  CHECK(verified.rows == 8192);
  CHECK(content(directory + "/results.csv").find("weight [1]") != std::string::npos);
}

TEST_CASE("what weighted motors cannot answer is refused", "[studies][uncertainty][reliability]") {
  const auto refused = [](const std::string& entries) {
    try {
      test::elastic_study("  kind: uncertainty\n  method: importance\n" + entries);
    } catch (const twum::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string limits = "  limits: [stall_torque >= 0.4 N.m]\n";
  CHECK(refused("  variables: {preload: 3 %}\n").find("study.limits") != std::string::npos);
  CHECK(refused("  variables: {preload: 3 %}\n  metrics: [stall_torque]\n" + limits)
            .find("do not show how a metric scatters") != std::string::npos);
  CHECK(refused("  parts: parts.csv\n" + limits).find("too short for rare failures") !=
        std::string::npos);
  CHECK(refused("  variables: {wavelengths: {distribution: uniform, min: 8, max: 10}}\n" + limits)
            .find("whole number") != std::string::npos);
  CHECK(refused("  variables: {preload: 3 %}\n" + limits).empty());
}

TEST_CASE("plain motors that fail tell which tolerance causes it (U8.4)",
          "[studies][uncertainty][reliability]") {
  const StudyResult result =
      run(kLognormal + "  samples: 20000\n  limits: [stall_torque >= " + torque_at(1.5) + "]\n");
  const UncertaintyResult& answer = uncertainty(result);
  const double share = log_variance(0.1) / (log_variance(0.1) + log_variance(0.03));
  REQUIRE(answer.causes.size() == 2);
  // 1,336 failing motors: twice the half width, one of 1,500 seeds.
  CHECK(std::abs(answer.causes[1].value - share) <=
        2 * (answer.causes[1].high - answer.causes[1].value));
  CHECK(answer.causes[1].high - answer.causes[1].value < 0.1);
  CHECK(std::isnan(answer.tighter[0].value));  // the laws are not normal
}

TEST_CASE("a tighter tolerance brings as much yield as the law says (U6.6)",
          "[studies][uncertainty][reliability]") {
  // F normal, 160 +- 5 N, at least 150 N: dY = phi(2) 2 for 100 % of the spread.
  const StudyResult result =
      run("  kind: uncertainty\n  samples: 20000\n  variables: {preload: 5 N, thickness: 1 %}\n"
          "  limits: [preload + 0 N * stall_torque / (1 N.m) >= 150 N]\n");
  const UncertaintyResult& answer = uncertainty(result);
  const double exact = 0.01 * 2 * std::exp(-2.0) / std::sqrt(2 * std::numbers::pi);
  REQUIRE(answer.causes.size() == 2);
  CHECK(std::abs(answer.tighter[0].value - exact) <=
        2 * (answer.tighter[0].high - answer.tighter[0].value));
  CHECK(answer.tighter[0].high - answer.tighter[0].value < 0.3 * exact);
  CHECK(std::abs(answer.causes[1].value) <=
        2 * (answer.causes[1].high - answer.causes[1].value));  // the thickness causes none
}
