// SPDX-License-Identifier: Apache-2.0
// Many designs at once are the same designs one by one.
#include "support/test_motors.hpp"

#include <twum/base/error.hpp>
#include <twum/core/batch.hpp>

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <variant>

using namespace twum;
using Catch::Matchers::Contains;

namespace {

const std::vector<MetricRequest> kAsked{{Metric::stall_torque},
                                        {Metric::no_load_speed},
                                        {Metric::torque_at, Argument::speed, 10.0},
                                        {Metric::speed_at, Argument::torque, 0.4}};

// More than a block of the batch, so that several threads have something to do; among them motors that
// cannot carry 0.4 N.m, whose answers are NaN.
std::vector<MotorDesign> designs() {
  test::Uniform random(7);
  std::vector<MotorDesign> list;
  for (int i = 0; i < 70; ++i) list.push_back(test::realistic_design(random));
  return list;
}

// To the bit, NaN included.
bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same(const MetricValue& a, const MetricValue& b) {
  return a.status == b.status && same(a.value, b.value);
}

bool same(const MetricDerivative& a, const MetricDerivative& b) {
  return same(a.value, b.value) && a.smoothness == b.smoothness &&
         std::memcmp(a.gradient.data(), b.gradient.data(), sizeof a.gradient) == 0;
}

template <typename Answer>
bool same(const std::vector<std::vector<Answer>>& a, const std::vector<std::vector<Answer>>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].size() != b[i].size()) return false;
    for (std::size_t k = 0; k < a[i].size(); ++k)
      if (!same(a[i][k], b[i][k])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a batch of metrics is its designs one by one, on any number of threads",
          "[core][batch]") {
  const std::vector<MotorDesign> batch = designs();
  std::vector<std::vector<MetricValue>> one_by_one;
  for (const MotorDesign& design : batch) one_by_one.push_back(evaluate(Motor(design), kAsked));
  CHECK(same(evaluate_designs(batch, kAsked, 1), one_by_one));
  CHECK(same(evaluate_designs(batch, kAsked, 3), one_by_one));
}

TEST_CASE("a batch of derivatives is its designs one by one, on any number of threads",
          "[core][batch][derivative]") {
  const std::vector<MotorDesign> batch = designs();
  for (const bool fixed_static_friction : {false, true}) {
    std::vector<std::vector<MetricDerivative>> one_by_one;
    for (const MotorDesign& design : batch)
      one_by_one.push_back(differentiate(Motor(design), kAsked, fixed_static_friction));
    CHECK(same(differentiate_designs(batch, kAsked, fixed_static_friction, 3), one_by_one));
    if (!fixed_static_friction) CHECK(same(differentiate_designs(batch, kAsked), one_by_one));
  }
}

TEST_CASE("a batch has the derivatives of the holding torque mu_0 F_N r",
          "[core][batch][derivative]") {
  const std::vector<MotorDesign> batch = designs();
  const std::vector<MetricRequest> asked{{Metric::holding_torque}};
  const auto rows = differentiate_designs(batch, asked, true, 2);
  REQUIRE(rows.size() == batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto& gradient = rows[i].at(0).gradient;
    const double mu_0 = batch[i].friction.threshold, load = batch[i].preload;
    const double r = batch[i].stator.contact_radius;
    // Products of two numbers: three roundings at most.
    CHECK(gradient[index_of(Parameter::preload)] == Approx(mu_0 * r).epsilon(1e-15));
    CHECK(gradient[index_of(Parameter::static_friction)] == Approx(load * r).epsilon(1e-15));
    CHECK(gradient[index_of(Parameter::contact_radius)] == Approx(mu_0 * load).epsilon(1e-15));
    CHECK(gradient[index_of(Parameter::thickness)] == 0);
  }
}

TEST_CASE("a batch names the first design that cannot be", "[core][batch]") {
  std::vector<MotorDesign> batch(3);
  batch[1].layer.thickness = -3e-4;
  const auto refused = Contains("design 1: thickness must be at least 1e-08 m, but is -0.0003 m");
  CHECK_THROWS_WITH(evaluate_designs(batch, kAsked), refused);
  CHECK_THROWS_WITH(differentiate_designs(batch, kAsked), refused);
  batch[0] = batch[1];
  CHECK_THROWS_WITH(evaluate_designs(batch, kAsked), Contains("design 0: thickness"));
  CHECK(evaluate_designs({}, kAsked).empty());
  CHECK(differentiate_designs({}, kAsked).empty());
}

TEST_CASE("designs are asked one by one: each has its answer or the reason why it cannot be",
          "[core][batch]") {
  const auto preload = [](std::uint64_t i) { return 20.0 * static_cast<double>(i) - 60; };  // [N]
  const auto make = [&](std::uint64_t i) {
    if (i == 7) throw std::runtime_error("out of memory, say");
    return with(MotorDesign{}, Parameter::preload, preload(i));
  };
  const auto ask = [](const Motor& motor) { return motor.holding_torque(); };
  const MotorDesign usual;
  for (const unsigned jobs : {1U, 3U}) {
    std::vector<DesignOutcome<double>> outcomes;
    const std::uint64_t next = ask_designs({0, 100, jobs, {}}, make, ask, [&](auto, auto& block) {
      for (auto& outcome : block) outcomes.push_back(std::move(outcome));
    });
    CHECK(next == 100);
    REQUIRE(outcomes.size() == 100);
    for (std::uint64_t i = 0; i < 100; ++i) {
      CAPTURE(i);
      const double* torque = std::get_if<double>(&outcomes[i]);
      const auto* failure = std::get_if<DesignFailure>(&outcomes[i]);
      const bool refused = i < 3;  // preloads below zero
      REQUIRE((torque == nullptr) == (refused || i == 7));
      if (refused) {
        CHECK(failure->kind == DesignFailure::Kind::refused);
        CHECK_THAT(failure->text, Contains("preload must be at least 0 N, but is -"));
      } else if (i == 7) {
        CHECK(failure->kind == DesignFailure::Kind::error);
        CHECK(failure->text == "internal-error");  // never the text of another library
      } else {  // (T7.8); a product of three numbers: two roundings, in any order
        const double expected = usual.friction.threshold * preload(i) * usual.stator.contact_radius;
        CHECK(*torque == Approx(expected).epsilon(1e-15));
      }
    }
  }
}

TEST_CASE("a batch that may not proceed ends with the rows so far", "[core][batch]") {
  const auto stopped = [] { return false; };
  const std::vector<MotorDesign> batch(1000);
  CHECK(evaluate_designs(batch, kAsked, 2, stopped).size() < batch.size());
  CHECK(differentiate_designs(batch, kAsked, false, 2, stopped).size() < batch.size());
}
