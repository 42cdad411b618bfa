// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"
#include "studies/statistics/study_text.hpp"

#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

// On its plateau the elastic motor has the stall torque mu F_N r exactly, so a distribution of preload or
// friction is that of the torque.
namespace {

using namespace twum::studies;
namespace test = twum::test;
using twum::test::Coverage;
using twum::test::run;

constexpr double kRadius = 0.0265;
constexpr double kFriction = 0.2;

const std::string kNormal =
    "  kind: uncertainty\n"
    "  variables:\n"
    "    preload: {distribution: normal, mean: 140 N, sd: 5 N}\n";

const UncertaintyResult& uncertainty(const StudyResult& result) {
  return std::get<UncertaintyResult>(result.answer);
}

double below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }
double density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

}  // namespace

TEST_CASE("a normal preload gives a normal stall torque", "[studies][uncertainty]") {
  constexpr double kSamples = 4000;
  const StudyResult result =
      run(kNormal + "  samples: 4000\n  metrics: [stall_torque]\n  quantiles: [0.05, 0.5, 0.9]\n");
  CHECK(result.outcome == "done");
  CHECK(result.evaluations == 4000);
  const UncertaintyResult::Metric& torque = uncertainty(result).metrics.at(0);
  const double mean = kFriction * 140 * kRadius;
  const double sd = kFriction * 5 * kRadius;
  // Five standard errors: sd / sqrt n, sd / sqrt (2 n), sqrt(p (1 - p) / n) / density.
  CHECK(torque.mean.value == Approx(mean).margin(5 * sd / std::sqrt(kSamples)));
  CHECK(torque.sd.value == Approx(sd).margin(5 * sd / std::sqrt(2 * kSamples)));
  const double z[] = {-1.6448536269514722, 0, 1.2815515655446004};
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = torque.quantiles[k].probability;
    const double error = std::sqrt(p * (1 - p) / kSamples) / density(z[k]) * sd;
    CHECK(torque.quantiles[k].value.value == Approx(mean + z[k] * sd).margin(5 * error));
    CHECK(torque.quantiles[k].value.low < torque.quantiles[k].value.value);
    CHECK(torque.quantiles[k].value.high > torque.quantiles[k].value.value);
  }
}

TEST_CASE("a lognormal friction gives a lognormal stall torque", "[studies][uncertainty]") {
  const StudyResult result =
      run("  kind: uncertainty\n  samples: 4000\n  metrics: [stall_torque]\n  variables:\n"
          "    kinetic_friction: {distribution: lognormal, mean: 0.17, sd: 0.02}\n");
  const UncertaintyResult::Metric& torque = uncertainty(result).metrics.at(0);
  const double scale = 160 * kRadius;
  const double spread = 0.02 / 0.17;
  const double error = scale * 0.02 / std::sqrt(4000.0);
  CHECK(torque.mean.value == Approx(scale * 0.17).margin(5 * error));
  // The kurtosis of this lognormal is 3.2: sd has an error of sd sqrt(2.2 / 4 n).
  CHECK(torque.sd.value == Approx(scale * 0.02).margin(5 * error * std::sqrt(0.55)));
  // Median mean / sqrt(1 + (sd / mean)^2); its error is sqrt(pi / 2) that of the mean.
  CHECK(torque.quantiles[1].value.value ==
        Approx(scale * 0.17 / std::sqrt(1 + spread * spread)).margin(5 * 1.2533 * error));
}

TEST_CASE("yield is the probability of keeping all limits", "[studies][uncertainty]") {
  // mu F r between 0.69 and 0.77 N.m, F normal.
  const auto z = [](double torque) { return (torque / (kFriction * kRadius) - 140) / 5; };
  const double truth = below(z(0.77)) - below(z(0.69));
  Coverage yield;
  Coverage mean;
  Coverage sd;
  Coverage quantile;
  for (int seed = 1; seed <= 100; ++seed) {
    const StudyResult result =
        run(kNormal + "  samples: 200\n  metrics: [stall_torque]\n  seed: " + std::to_string(seed) +
            "\n  limits:\n    - stall_torque >= 0.69 N.m\n    - stall_torque <= 0.77 N.m\n");
    const UncertaintyResult& answer = uncertainty(result);
    REQUIRE(answer.yield);
    yield.count(*answer.yield, truth);
    mean.count(answer.metrics[0].mean, kFriction * kRadius * 140);
    sd.count(answer.metrics[0].sd, kFriction * kRadius * 5);
    quantile.count(answer.metrics[0].quantiles[0].value,
                   kFriction * kRadius * (140 - 5 * 1.6448536269514722));
  }
  INFO(yield.share() << ", " << mean.share() << ", " << sd.share() << ", " << quantile.share());
  CHECK(yield.hits >= yield.fewest(0.95));
  CHECK(mean.hits >= mean.fewest(0.95));
  CHECK(sd.hits >= sd.fewest(0.94));  // asymptotic, see its test
  CHECK(quantile.hits >= quantile.fewest(0.95));
}

TEST_CASE("a limit is told in SI, with its side and the metric that it looks at",
          "[studies][uncertainty]") {
  const StudyResult result = run(kNormal +
                                 "  samples: 10\n  metrics: [stall_torque]\n"
                                 "  limits: [stall_torque >= 690 mN.m, no_load_speed <= 30 rpm]\n");
  const std::vector<UncertaintyResult::Limit>& limits = uncertainty(result).limits;
  REQUIRE(limits.size() == 2);
  CHECK(limits[0].metric == "stall_torque");
  CHECK(std::isinf(limits[0].upper));
  CHECK(limits[0].lower == Approx(0.69).epsilon(1e-14));  // a few roundings of the unit
  CHECK(limits[1].metric == "no_load_speed");
  CHECK(std::isinf(limits[1].lower));
  CHECK(limits[1].upper == Approx(3.14159265358979323846).epsilon(1e-14));
}

TEST_CASE("beside limits no metrics need be named: what is limited is told",
          "[studies][uncertainty]") {
  const StudyResult result = run(kNormal +
                                 "  samples: 200\n"
                                 "  limits:\n    - stall_torque / preload >= 4 mm\n"
                                 "    - 100 rpm <= no_load_speed <= 200 rpm\n");
  const UncertaintyResult& answer = uncertainty(result);
  REQUIRE(answer.metrics.size() == 2);
  CHECK(answer.metrics[0].column.name == "stall_torque / preload");
  // mu r = 5.3 mm whatever the preload, so that all motors keep the first limit.
  CHECK(answer.metrics[0].mean.value == Approx(kFriction * kRadius).epsilon(1e-9));
  CHECK(answer.limits[0].kept.value == 1);
}

TEST_CASE("a motor without a value does not keep the limit, and is counted",
          "[studies][uncertainty]") {
  // A motor carries 0.74 N.m if mu F r reaches it; what it cannot carry has no speed.
  const StudyResult result = run(kNormal +
                                 "  samples: 2000\n  metrics: [stall_torque]\n"
                                 "  limits:\n    - speed_at(0.74 N.m) >= 0 rpm\n");
  const UncertaintyResult& answer = uncertainty(result);
  REQUIRE(answer.metrics.size() == 2);
  CHECK(answer.metrics[0].count == 2000);
  CHECK(answer.metrics[1].count + answer.no_value == 2000);
  CHECK(answer.failed == answer.no_value);
  CHECK(result.failures.size() == 1);
  REQUIRE(answer.yield);
  const double truth = 1 - below((0.74 / (kFriction * kRadius) - 140) / 5);
  CHECK(answer.yield->value == Approx(static_cast<double>(answer.metrics[1].count) / 2000));
  CHECK(answer.yield->value ==
        Approx(truth).margin(5 * std::sqrt(truth * (1 - truth) / 2000)));  // standard errors
}

TEST_CASE("whole numbers are drawn evenly", "[studies][uncertainty]") {
  const StudyResult result =
      run("  kind: uncertainty\n  samples: 3000\n  metrics: [contact_ratio]\n"
          "  limits: [wavelengths <= 8.5, wavelengths >= 7.5]\n  variables:\n"
          "    wavelengths: {distribution: uniform, min: 8, max: 10}\n");
  // 8, 9 and 10 have a third each: five standard errors.
  CHECK(uncertainty(result).yield->value == Approx(1.0 / 3).margin(5 * std::sqrt(2.0 / 9 / 3000)));
}

TEST_CASE("distributions that reach far beyond the admissible are refused",
          "[studies][uncertainty]") {
  const auto study = [](const std::string& distribution) {
    return twum::test::elastic_study(
        "  kind: uncertainty\n  metrics: [stall_torque]\n  variables:\n"
        "    preload: {distribution: " +
        distribution + "}\n");
  };
  CHECK_THROWS_WITH(study("normal, mean: 20 N, sd: 10 N"),
                    Catch::Contains("2.28 % of the distribution lies outside"));
  CHECK_NOTHROW(study("normal, mean: 24 N, sd: 10 N"));  // 0.82 %
  CHECK_NOTHROW(study("lognormal, mean: 20 N, sd: 10 N"));
  CHECK_THROWS_AS(study("lognormal, mean: 0 N, sd: 10 N"), FileError);
}

TEST_CASE("uncertainty studies do not depend on the number of threads", "[studies][uncertainty]") {
  const std::string entries = kNormal +
                              "  samples: 500\n  metrics: [peak_power]\n"
                              "  limits: [no_load_speed >= 100 rpm]\n";
  const std::string one = twum::test::timeless_summary(run(entries, 1));
  CHECK(one == twum::test::timeless_summary(run(entries, 2)));
  CHECK(one == twum::test::timeless_summary(run(entries, 8)));
}

TEST_CASE("correlated tolerances change the share of motors as their sum does (U1.9)",
          "[studies][uncertainty][correlation]") {
  constexpr double kSamples = 40000;
  for (const double rho : {-0.7, 0.0, 0.7}) {
    CAPTURE(rho);
    // 5 and 7 % of spread; the sum of the shares is normal about 2.
    const StudyResult result =
        run("  kind: uncertainty\n  samples: 40000\n  variables: {preload: 5 %, kinetic_friction: "
            "7 %}\n"
            "  correlations: [[kinetic_friction, preload, " +
            std::to_string(rho) +
            "]]\n"
            "  limits: ['preload / (160 N) + kinetic_friction / 0.2 >= 1.87']\n");
    const double sd = std::sqrt(0.0025 + 0.0049 + 2 * rho * 0.05 * 0.07);
    const double share = below(0.13 / sd);
    REQUIRE(uncertainty(result).yield);
    CHECK(uncertainty(result).yield->value ==
          Approx(share).margin(5 * std::sqrt(share * (1 - share) / kSamples)));
  }
}

TEST_CASE("motors beyond the admissible range keep no limit", "[studies][uncertainty]") {
  // A friction of less than 0 cannot be: Phi(-1 / 0.42) of the motors.
  const StudyResult result =
      run("  kind: uncertainty\n  samples: 40000\n  variables: {kinetic_friction: 42 %}\n"
          "  limits: [holding_torque >= 1 mN.m]\n");
  // holding_torque = mu_0 F_N r: what is above 0 keeps the limit up to 1e-3 / 0.85 of the friction.
  const double least = 1e-3 / (0.2 * 160 * kRadius);
  const double share = below((1 - least) / 0.42);
  CHECK(uncertainty(result).yield->value ==
        Approx(share).margin(5 * std::sqrt(share * (1 - share) / 40000)));
  REQUIRE(uncertainty(result).inadmissible.size() == 1);
  CHECK(uncertainty(result).inadmissible[0].share == Approx(below(-1 / 0.42)).epsilon(1e-9));
}

TEST_CASE("measured parts are drawn whole, as often as their weights say",
          "[studies][uncertainty][parts]") {
  const test::ScratchFolder folder;
  std::ofstream(folder.path("parts.csv"))
      << "serial,kinetic_friction,preload [N],weight\na,0.18,150,1\nb,0.22,170,3\nc,0.2,160,0\n";
  std::ofstream(folder.path("study.yaml"))
      << "twum: 1\nmotor: " TWUM_SOURCE_DIR
         "/examples/motors/elastic-layer.yaml\nstudy:\n"
         "  kind: uncertainty\n  parts: parts.csv\n  samples: 4000\n  metrics: [stall_torque]\n";
  const StudyFile file = read_study_file(folder.path("study.yaml"));
  const StudyResult result = run_study(file);
  std::size_t first = 0, second = 0;
  result.rows->read([&](const StoredRow& row) {
    const bool of_first = row.values[0] == 0.18;
    REQUIRE(row.values[0] == (of_first ? 0.18 : 0.22));
    REQUIRE(row.values[1] == (of_first ? 150 : 170));
    // mu F_N r of the elastic layer, to the rounding of the motor's own sum.
    CHECK(row.values[2] == Approx(row.values[0] * row.values[1] * kRadius).epsilon(1e-9));
    ++(of_first ? first : second);
  });
  CHECK(first + second == 4000);
  CHECK(static_cast<double>(first) == Approx(1000).margin(5 * std::sqrt(4000 * 0.25 * 0.75)));
  CHECK(uncertainty(result).part_count == 3);
  REQUIRE(result.model_notes.size() > 0);
  CHECK(result.model_notes[0].find("'serial'") != std::string::npos);
}

TEST_CASE("wrong parts and correlations are refused with their place",
          "[studies][uncertainty][parts]") {
  const test::ScratchFolder folder;
  const auto error = [&](const std::string& table, const std::string& entries) -> std::string {
    std::ofstream(folder.path("parts.csv")) << table;
    std::ofstream(folder.path("study.yaml"))
        << "twum: 1\nmotor: " TWUM_SOURCE_DIR
           "/examples/motors/elastic-layer.yaml\nstudy:\n"
           "  kind: uncertainty\n  samples: 10\n  metrics: [stall_torque]\n"
        << entries;
    try {
      run_study(read_study_file(folder.path("study.yaml")));
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  const auto says = [](const std::string& text, const std::string& words) {
    INFO(text);
    CHECK(text.find(words) != std::string::npos);
  };
  says(error("preload [N]\n150\nx\n", "  parts: parts.csv\n"),
       "parts.csv:3: preload: 'x' is not a number");
  says(error("preload [N],weight\n150,-1\n", "  parts: parts.csv\n"), "parts.csv:2: weight: '-1'");
  says(error("preload [N],Weight\n150,0\n", "  parts: parts.csv\n"),
       "the weights of all parts are 0");
  says(error("preload [N],kinetic_friction\n150,0.2\n160,-0.2\n", "  parts: parts.csv\n"),
       "parts.csv:3: kinetic_friction: -0.2");
  says(error("voltage [V]\n150\n", "  parts: parts.csv\n"),
       "the column voltage does not fit the motor");
  says(error("preload [N],weight,weight\n150,1,2\n", "  parts: parts.csv\n"),
       "'weight' stands there twice");
  says(error("preload [N]\n", "  parts: parts.csv\n"), "no part");
  says(error("preload [N]\n150\n", "  parts: parts.csv\n  variables: {preload: 5 %}\n"),
       "study.variables.preload: has a column in study.parts too");
  says(error("preload [N]\n150\n", "  parts: none.csv\n"), "none.csv");
  says(error("", "  samples: 10\n"), "variables");
  const std::string three = "  variables: {preload: 5 %, kinetic_friction: 5 %, thickness: 5 %}\n";
  says(error("", three + "  correlations: [[preload, youngs_modulus, 0.5]]\n"),
       "correlations[0]: 'youngs_modulus' does not scatter");
  says(error("", three + "  correlations: [[preload, thickness, 1.5]]\n"), "'1.5'");
  says(error("", three + "  correlations: [[preload, nothing, 0.5]]\n"), "'nothing'");
  says(error("",
             three +
                 "  correlations: [[preload, thickness, 0.9], [thickness, kinetic_friction, 0.9], "
                 "[preload, kinetic_friction, -0.9]]\n"),
       "correlations[1]: 'thickness' and 'kinetic_friction' with 0.9");
}

TEST_CASE("a result grows by more samples, with the bytes of one that began with them",
          "[studies][uncertainty]") {
  const auto asked = [](int samples) {
    return test::elastic_study(
        "  kind: uncertainty\n  variables: {preload: 5 %}\n  metrics: "
        "[stall_torque]\n  samples: " +
        std::to_string(samples) + "\n");
  };
  const auto content = [](const std::string& path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const test::ScratchFolder folder;
  run_study(asked(50), folder.path("grown"));
  const StudyResult grown = run_study(asked(120), folder.path("grown"));
  CHECK(grown.evaluations == 120);
  CHECK_FALSE(grown.was_complete);
  const StudyResult whole = run_study(asked(120), folder.path("whole"));
  CHECK(content(folder.path("grown/results.csv")) == content(folder.path("whole/results.csv")));
  CHECK(test::timeless_summary(grown) == test::timeless_summary(whole));
  CHECK(run_study(asked(120), folder.path("grown")).was_complete);
  CHECK_THROWS_AS(run_study(asked(80), folder.path("grown")), twum::InputError);
}

TEST_CASE("a result with measured parts, or from another result, is verified from its folder alone",
          "[studies][uncertainty][parts]") {
  const test::ScratchFolder folder;
  const auto written = [&](const std::string& name, const std::string& entries) {
    std::ofstream(folder.path(name + ".yaml"))
        << "twum: 1\nmotor: " TWUM_SOURCE_DIR "/examples/motors/elastic-layer.yaml\nstudy:\n"
        << entries;
    run_study(read_study_file(folder.path(name + ".yaml")), folder.path(name));
    return verify_study(folder.path(name));
  };
  std::ofstream(folder.path("parts.csv")) << "serial,preload [N]\na,150\nb,160\n";
  const Verification parts =
      written("parts",
              "  kind: uncertainty\n  parts: parts.csv\n  samples: 9\n  metrics: [stall_torque]\n");
  CHECK(parts.complaints == std::vector<std::string>{});
  written("first",
          "  kind: optimize\n  maximize: stall_torque\n  variables: {preload: {min: 100 N, max: "
          "150 N}}\n");
  const Verification start = written("second",
                                     "  kind: uncertainty\n  start: first\n  variables: {preload: "
                                     "3 %}\n  samples: 9\n  metrics: [stall_torque]\n");
  CHECK(start.complaints == std::vector<std::string>{});
}
