// SPDX-License-Identifier: Apache-2.0
// Derivatives of parameters that follow from others, and metrics beyond the largest load.
#include "entries_support.hpp"
#include "kinds/sensitivity/metric_gradients.hpp"
#include "problem/metric_values.hpp"
#include "support/constants.hpp"

#include <twum/core/motor.hpp>
#include <twum/studies/distribution.hpp>
#include <twum/studies/elementary_effects.hpp>
#include <twum/studies/estimate.hpp>
#include <twum/studies/sobol_indices.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using P = Parameter;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// All of the layer follows from E, nu, the loss factor, the density and h.
MotorDesign from_material() {
  MotorDesign motor;
  motor.friction = {0.2, 0.3};
  return motor;
}

// All of it is given outright.
MotorDesign outright() {
  MotorDesign motor;
  motor.layer.given_shear_modulus = 1.1e9;
  motor.layer.given_shear_viscosity = 220;
  motor.layer.given_inertia = 5.4e-5;
  return motor;
}

double slope(const MotorDesign& motor, P of, P by, bool fixed = false) {
  return parameter_value(motor, of, fixed).gradient[index_of(by)];
}

// A few roundings of products and quotients.
Approx near(double value) { return Approx(value).epsilon(1e-14).margin(0); }

}  // namespace

TEST_CASE("a parameter in use is its own slope of 1", "[studies][problem]") {
  const MotorDesign motor = from_material();
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(motor, row.parameter)) continue;
    CAPTURE(row.name);
    CHECK(slope(motor, row.parameter, row.parameter) == 1);
    CHECK(parameter_value(motor, row.parameter, false).value.value == get(motor, row.parameter));
  }
}

TEST_CASE("what follows from the material has the slopes of its definition", "[studies][problem]") {
  const MotorDesign motor = from_material();
  const double e = 3e9;
  const double nu = 0.35;
  const double g = e / (2 * (1 + nu));
  const double omega = 2 * std::numbers::pi * 40e3;
  // G = E / (2 (1 + nu))
  CHECK(slope(motor, P::shear_modulus, P::youngs_modulus) == near(1 / (2 * (1 + nu))));
  CHECK(slope(motor, P::shear_modulus, P::poisson_ratio) == near(-g / (1 + nu)));
  CHECK(slope(motor, P::shear_modulus, P::shear_modulus) == 0);  // not in use
  // gamma = loss_factor G / omega
  CHECK(slope(motor, P::shear_viscosity, P::loss_factor) == near(g / omega));
  CHECK(slope(motor, P::shear_viscosity, P::youngs_modulus) == near(0.05 / (2 * (1 + nu)) / omega));
  CHECK(slope(motor, P::shear_viscosity, P::frequency) == near(-0.05 * g / omega / 40e3));
  // m = rho h^2 / 3
  CHECK(slope(motor, P::inertia, P::density) == near(0.3e-3 * 0.3e-3 / 3));
  CHECK(slope(motor, P::inertia, P::thickness) == near(2 * 1800 * 0.3e-3 / 3));
}

TEST_CASE("what is given outright tells the material it stands for", "[studies][problem]") {
  const MotorDesign motor = outright();
  const double omega = 2 * std::numbers::pi * 40e3;
  // nu = E / (2 G) - 1
  CHECK(slope(motor, P::poisson_ratio, P::youngs_modulus) == near(1 / (2 * 1.1e9)));
  CHECK(slope(motor, P::poisson_ratio, P::shear_modulus) == near(-3e9 / (2 * 1.1e9 * 1.1e9)));
  // loss_factor = gamma omega / G
  CHECK(slope(motor, P::loss_factor, P::shear_viscosity) == near(omega / 1.1e9));
  CHECK(slope(motor, P::loss_factor, P::shear_modulus) == near(-220 * omega / (1.1e9 * 1.1e9)));
  CHECK(slope(motor, P::loss_factor, P::frequency) == near(220 * omega / 1.1e9 / 40e3));
  // rho = 3 m / h^2
  CHECK(slope(motor, P::density, P::inertia) == near(3 / (0.3e-3 * 0.3e-3)));
  CHECK(slope(motor, P::density, P::thickness) ==
        near(-2 * 3 * 5.4e-5 / (0.3e-3 * 0.3e-3 * 0.3e-3)));
}

TEST_CASE("a product that is zero has the slope of its zero factor alone", "[studies][problem]") {
  MotorDesign motor = from_material();
  motor.layer.loss_factor = 0;
  motor.layer.density = 0;
  const double g = 3e9 / (2 * 1.35);
  const double omega = 2 * std::numbers::pi * 40e3;
  CHECK(slope(motor, P::shear_viscosity, P::loss_factor) == near(g / omega));
  CHECK(slope(motor, P::shear_viscosity, P::youngs_modulus) == 0);
  CHECK(slope(motor, P::shear_viscosity, P::frequency) == 0);
  CHECK(slope(motor, P::inertia, P::density) == near(0.3e-3 * 0.3e-3 / 3));
  CHECK(slope(motor, P::inertia, P::thickness) == 0);
}

TEST_CASE("static friction follows the kinetic one in proportion, unless it is held",
          "[studies][problem]") {
  MotorDesign motor = from_material();
  CHECK(slope(motor, P::static_friction, P::kinetic_friction) == near(1.5));
  CHECK(slope(motor, P::static_friction, P::kinetic_friction, true) == 0);
  CHECK(slope(motor, P::static_friction, P::static_friction) == 1);
  motor.friction.kinetic = 0;  // then it becomes what the kinetic one does
  CHECK(slope(motor, P::static_friction, P::kinetic_friction) == 1);
}

TEST_CASE("gradients of metrics and parameters come in the order asked, by the variables",
          "[studies][sensitivity]") {
  const ScratchFolder folder;
  const MotorDesign motor = study_in(folder, "{kind: curve, points: 3}").motor.design;
  const std::vector<MetricExpression> metrics{parse_metric("preload"), parse_metric("stall_torque"),
                                              parse_metric("poisson_ratio")};
  const VariedParameters varied(motor, {P::kinetic_friction, P::preload, P::shear_modulus}, {});
  const auto gradients = MetricGradients(metrics, varied)
                             .at(std::vector<double>{0.2, 160, get(motor, P::shear_modulus)});
  REQUIRE(gradients.size() == 3);
  CHECK(gradients[0].values == std::vector<double>{0, 1, 0});
  // mu F_N r; solutions are good to about 1e-12.
  CHECK(gradients[1].values[0] == Approx(160 * 0.0265).epsilon(1e-9));
  CHECK(gradients[1].values[1] == Approx(0.2 * 0.0265).epsilon(1e-9));
  CHECK(gradients[2].values[2] == near(-3e9 / (2 * 1.1e9 * 1.1e9)));
}

TEST_CASE("beyond its largest torque a motor is asked just below it", "[studies][problem]") {
  const ScratchFolder folder;
  MotorDesign design = study_in(folder, "{kind: curve, points: 3}").motor.design;
  const Motor motor(design);
  // On the plateau the elastic layer carries mu F_N r, so 0.999 of that is what is asked at.
  const double load = kReachable * 0.2 * 160 * 0.0265;
  const MetricDerivative torque = differentiate_at_share(motor, Metric::torque_at, kReachable);
  CHECK(torque.value.value == Approx(load).epsilon(1e-9));
  CHECK(torque.gradient[index_of(P::preload)] == Approx(load / 160).epsilon(1e-6));
  const MetricValue speed = evaluate_at_share(motor, Metric::speed_at, kReachable);
  CHECK(motor.operating_point(speed.value).torque == Approx(load).epsilon(1e-9));
  design.preload = 0;  // no torque at all
  const MetricDerivative none = differentiate_at_share(Motor(design), Metric::speed_at, kReachable);
  CHECK(none.value.status == MetricStatus::unreachable);
  CHECK(std::isnan(none.value.value));
}

TEST_CASE("metrics asked twice are answered twice", "[studies][problem]") {
  const ScratchFolder folder;
  const Motor motor(study_in(folder, "{kind: curve, points: 3}").motor.design);
  const std::vector<MetricExpression> asked{
      parse_metric("torque_at(1 rpm)"), parse_metric("torque_at(2 rpm)"),
      parse_metric("torque_at(1 rpm)"), parse_metric("speed_at(0.5 N.m)"),
      parse_metric("stall_torque")};
  const auto values = metric_values(motor, asked, false, false);
  REQUIRE(values.size() == 5);
  CHECK(values[0].value.value == values[2].value.value);
  CHECK(motor.operating_point(values[3].value.value).torque == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("bounds from derivatives need the derivatives of every sample", "[studies][sobol]") {
  // f = u_1 + 2 u_2: variances 1/12 and 4/12, slopes 1 and 2.
  const SobolDesign design(2, 1);
  constexpr std::uint64_t kBlocks = 256;
  std::vector<std::uint64_t> places{kBlocks};  // none is missing, then one in each replicate
  for (std::uint64_t r = 0; r <= SobolDesign::kReplicates; ++r) places.push_back(r);
  for (const std::uint64_t missing : places) {
    CAPTURE(missing);
    SobolIndices indices(2);
    for (std::uint64_t block = 0; block < kBlocks; ++block) {
      std::vector<double> values;
      std::vector<double> unit(2);
      for (std::size_t member = 0; member < design.block_size(); ++member) {
        design.point(block, member, unit);
        values.push_back(unit[0] + 2 * unit[1]);
      }
      CHECK(indices.add(block, values));
      std::vector<double> gradient{1, 2};
      if (block == missing) gradient[block % 2] = block % 2 == 0 ? kNaN : kInfinity;
      indices.add_gradient(block, gradient);
    }
    const auto shares = indices.shares(0.95);
    CHECK(shares[0].total.value == Approx(0.2).margin(0.02));  // of 256 well spread points
    const double pi = std::numbers::pi;
    for (std::size_t j = 0; j < 2; ++j) {
      const double slope_square = j == 0 ? 1 : 4;
      const double bound = shares[j].derivative_bound.value;
      // By the variance as it was sampled, which is good to a few per cent.
      if (missing == kBlocks)
        CHECK(bound == Approx(slope_square / (pi * pi * 5 / 12)).epsilon(0.05));
      else
        CHECK(std::isnan(bound));
    }
  }
  // Of fewer blocks than replicates: each of them that has one needs its derivative.
  for (std::uint64_t filled = 2; filled <= 9; ++filled) {
    for (std::uint64_t missing = 0; missing <= filled; ++missing) {
      SobolIndices few(2);
      for (std::uint64_t block = 0; block < filled; ++block) {
        const auto f = static_cast<double>(block);
        few.add(block, std::vector<double>{f, 1 - f, f * f, 2});
        if (block != missing) few.add_gradient(block, std::vector<double>{1, 2});
      }
      CHECK(std::isnan(few.shares(0.95)[0].derivative_bound.value) == (missing < filled));
    }
  }
  SobolIndices whole(2);
  CHECK(std::isnan(whole.mean()));
  CHECK(std::isnan(whole.variance()));
  CHECK_FALSE(whole.constant());
  CHECK(std::isnan(whole.shares(0.95)[0].total.value));
  whole.add(0, std::vector<double>{1, 2, 3, 4});
  CHECK(std::isnan(whole.shares(0.95)[0].total.value));  // one replicate has no interval
}

TEST_CASE("the widest interval is the widest of all, without end if one is none",
          "[studies][sobol]") {
  std::vector<SobolShares> shares(2);
  shares[0].first = {0.1, 0.0, 0.3};
  shares[0].total = {0.1, 0.0, 0.1};
  shares[1].first = {0.1, 0.0, 0.2};
  shares[1].total = {0.5, 0.1, 0.8};
  CHECK(widest(shares) == Approx(0.7).epsilon(1e-15));
  shares[1].total = {0.5, kNaN, kNaN};
  CHECK(widest(shares) == kInfinity);
  CHECK(widest({}) == 0);
}

TEST_CASE("distributions cut off at an end without limit lose nothing there",
          "[studies][distribution]") {
  CHECK(Distribution::normal(0, 1).within(-kInfinity, kInfinity).cut_off() == 0);
  CHECK(Distribution::normal(0, 1).within(0, kInfinity).cut_off() == Approx(0.5).epsilon(1e-15));
  CHECK(Distribution::normal(0, 1).within(-kInfinity, 0).cut_off() == Approx(0.5).epsilon(1e-15));
  CHECK(Distribution::lognormal(1, 0.5).within(-1, kInfinity).cut_off() == 0);
  CHECK(Distribution::triangular(0, 1, 2).within(1, 2).cut_off() == Approx(0.5).epsilon(1e-15));
  CHECK(Distribution::triangular(0, 1, 2).within(-1, 3).cut_off() == 0);
  CHECK(Distribution::uniform(0, 4).within(1, kInfinity).cut_off() == Approx(0.25).epsilon(1e-15));
  // A draw at the very end stays inside.
  const Distribution tail = Distribution::normal(0, 1).within(9, 10);
  for (const double p : {0.0, 0.5, 1.0}) {
    CHECK(tail.quantile(p) >= 9);
    CHECK(tail.quantile(p) <= 10);
  }
}
