// SPDX-License-Identifier: Apache-2.0
// Many designs at once are the same designs one by one.
#include "support/test_motors.hpp"

#include <twum/base/error.hpp>
#include <twum/core/performance/batch.hpp>

#include <catch2/catch.hpp>

#include <cstring>

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
    const double mu_0 = batch[i].friction.static_, load = batch[i].preload;
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
