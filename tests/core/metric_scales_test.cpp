// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

// The scaling laws of theory section 8 for whatever is searched over speed: no threshold of a search may have a unit.
namespace {

using namespace twum;
using namespace twum::test;

struct Scale {
  double stress{1}, time{1}, length{1};  // of moduli and pressures, of frequencies, of lengths
};

// G, gamma and m are given outright; only materials and drives that a factor changes are listed.
MotorDesign scaled(MotorDesign d, const Scale& by) {
  Stator& s = d.stator;
  ContactLayer& layer = d.layer;
  const double l = by.length, p = by.stress, t = by.time;
  for (double* each : {&s.contact_radius, &s.contact_width, &s.neutral_plane_distance, &s.amplitude,
                       &layer.thickness})
    *each *= l;
  s.frequency *= t;
  layer.youngs_modulus *= p;
  layer.given_shear_modulus = p * *layer.given_shear_modulus;
  layer.given_shear_viscosity = p / t * *layer.given_shear_viscosity;
  layer.given_inertia = p / (t * t) * *layer.given_inertia;
  d.preload *= p * l * l;
  // Its loss is c (omega A)^2, a power.
  s.modal_damping *= p * l / t;
  return d;
}

double factor_of(std::string_view unit, const Scale& by) {
  const double l = by.length;
  if (unit == "N.m") return by.stress * l * l * l;
  if (unit == "W") return by.stress * by.time * l * l * l;
  if (unit == "rad/s") return by.time;
  if (unit == "m") return l;
  if (unit == "Pa") return by.stress;
  REQUIRE(unit == "1");
  return 1;
}

std::vector<MetricRequest> requests_of(const Motor& motor) {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none && !row.needs_modes && !row.needs_geometry &&
        !row.needs_thermal && !row.needs_wear)
      requests.push_back({row.metric});
  for (const double share : {0.3, 0.6})
    requests.push_back({Metric::speed_at, Argument::torque, share * motor.holding_torque()});
  requests.push_back(
      {Metric::speed_at, Argument::torque, evaluate(motor, {Metric::stall_torque}).value});
  return requests;
}

struct Tally {
  int values{0}, slopes{0}, kinks{0}, undefined{0};
};

// Both motors' numbers differ by powers of two alone, so that rounding is the same in both: to the bit.
void check_scale(const MotorDesign& design, const MotorDesign& larger, const Scale& by,
                 Tally& tally) {
  const Motor motor(design), larger_motor(larger);
  std::vector<MetricRequest> requests = requests_of(motor), larger_requests = requests;
  for (MetricRequest& each : larger_requests) each.at *= factor_of("N.m", by);
  const auto expected = differentiate(motor, requests),
             found = differentiate(larger_motor, larger_requests);
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const MetricInfo& row = info(requests[k].metric);
    const double factor = factor_of(row.unit, by);
    CAPTURE(row.name, k, by.stress, by.time, by.length, expected[k].value.value);
    REQUIRE(found[k].value.status == expected[k].value.status);
    CHECK(found[k].smoothness == expected[k].smoothness);
    tally.undefined += expected[k].smoothness == Smoothness::undefined;
    tally.kinks += expected[k].smoothness == Smoothness::one_sided;
    if (expected[k].value.status != MetricStatus::ok) continue;
    ++tally.values;
    const double value = expected[k].value.value;
    CHECK(found[k].value.value == factor * value);
    if (expected[k].smoothness == Smoothness::undefined ||
        found[k].smoothness == Smoothness::undefined)
      continue;
    for (const ParameterInfo& each : parameter_table()) {
      if (!in_use(design, each.parameter)) continue;
      const std::size_t j = index_of(each.parameter);
      // What a relative change of the parameter does has the metric's unit.
      const double change = expected[k].gradient[j] * get(design, each.parameter),
                   larger_change = found[k].gradient[j] * get(larger, each.parameter);
      CAPTURE(each.name);
      ++tally.slopes;
      CHECK(larger_change == factor * change);
    }
  }
}

}  // namespace

TEST_CASE("metrics of a motor built to another scale are the metrics scaled (C8.9, C8.10, C8.12)",
          "[core][metrics][scaling]") {
  std::vector<MotorDesign> designs;
  Uniform real(7), ring(11), box(11);
  for (int i = 0; i <= 52; ++i) {
    const MotorDesign design = holding_motor(real, i);
    if (i < 6 || i == 52)
      designs.push_back(design);  // the last one leaves its plateau before it must
  }
  for (int i = 0; i < 9; ++i) {
    const MotorDesign design = ringing_motor(ring, i);
    if (i == 5 || i >= 7) designs.push_back(design);  // with peaks at kinks among them
  }
  Uniform dips(5);
  for (int i = 0; i <= 295; ++i) {
    const MotorDesign design = ringing_motor(dips, i);
    if (i == 295) designs.push_back(design);  // with a dip behind its best efficiency
  }
  for (int i = 0; i < 40; ++i) {
    const MotorDesign design = box_motor(box);
    if (i % 4 == 3 || i % 11 == 4) designs.push_back(design);
  }
  Tally tally;
  for (const Scale& by : {Scale{0x1p-13, 1, 1}, Scale{0x1p10, 1, 1}, Scale{1, 0x1p-10, 1},
                          Scale{1, 0x1p10, 1}, Scale{1, 1, 0x1p-7}, Scale{1, 1, 0x1p4}}) {
    int checked = 0;
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const MotorDesign design = outright(designs[i]), larger = scaled(design, by);
      if (!complaints(larger).empty()) continue;  // harder than any material
      CAPTURE(i);
      ++checked;
      check_scale(design, larger, by, tally);
    }
    CAPTURE(by.stress, by.time, by.length);
    CHECK(checked >= 5);
  }
  CHECK(tally.values > 1000);
  CHECK(tally.slopes > 10000);
  CHECK(tally.kinks > 50);
  CHECK(tally.undefined > 50);
}
