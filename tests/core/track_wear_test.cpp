// SPDX-License-Identifier: Apache-2.0
// Each radius of the track wears by itself: rates, their Jacobian, and motors with an uneven track.
#include <catch2/catch.hpp>

#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/track_wear.hpp>

#include "support/heat_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/test_motors.hpp"
#include "support/wearing_motors.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using namespace twum;
using namespace twum::test;

namespace {

// Depths of some tenths of the elastic depth, which no symmetry makes easy.
std::vector<double> some_depths(std::size_t nodes, double size = 0.1e-6) {
  std::vector<double> depths;
  for (std::size_t j = 0; j < nodes; ++j)
    depths.push_back(size * (1 + 0.3 * std::sin(1.7 * static_cast<double>(j) + 0.4)));
  return depths;
}

double value(const MotorDesign& design, Metric metric, const LoadPoint& load) {
  return evaluate(Motor(design), {metric, load.argument, load.at}).value;
}

}  // namespace

TEST_CASE("the mean of the rates over the area is that of the whole track (V1.1, V3.3)",
          "[core][wear][identity]") {
  const auto check = [](const MotorDesign& design, const LoadPoint& load) {
    TrackWear track(design, load);
    const auto depths = some_depths(track.nodes().size());
    const TrackRates found = track.at(depths);
    REQUIRE(found.status == MetricStatus::ok);
    const MotorDesign worn = worn_motor(design, depths);
    // Archard's law for the friction power of the worn motor, whose speed and wave are searched anew: to 1e-9 near no-load
    const double right = *design.wear->specific_wear / design.friction.kinetic *
                         value(worn, Metric::wear_intensity_at, load);
    CHECK(std::fabs(track.mean(found.rates) / right - 1) <= 1e-9);
    const TrackLoad& told = found.loads.at(0);
    CHECK(std::fabs(told.friction_power / value(worn, Metric::friction_power_at, load) - 1) <=
          1e-9);
    double carried = 0, highest = 0;
    for (std::size_t j = 0; j < depths.size(); ++j)
      carried += told.loads[j], highest = std::fmax(highest, told.pressures[j]);
    CHECK(std::fabs(carried / worn.preload - 1) <= 1e-10);  // the indentation's last step
    CHECK(std::fabs(
              highest /
                  evaluate(Motor(worn), {Metric::max_pressure_at, load.argument, load.at}).value -
              1) <= 1e-9);
  };
  check(wearing(elastic_layer(8)), torque_load(0.6));
  check(wearing(elastic_layer(kAutoSlices)), {Argument::speed, 9, 0});
  check(wearing(driven_with_slices(8), 1e5), torque_load(0.5));
  check(wearing(driven_with_slices(8), 1e5), {Argument::speed, 9, 0});
}

TEST_CASE("a motor whose track is even has the deviations of one that is (V3.1)",
          "[core][wear][limit]") {
  MotorDesign design = wearing(elastic_layer(8));
  const MotorDesign worn = worn_motor(design, std::vector<double>(8, 10e-6));
  const MotorDesign even = worn_motor(design, 10e-6);
  // without taper and shape the even track of eight slices has the same nodes
  for (const MetricRequest& request :
       {MetricRequest{Metric::stall_torque}, MetricRequest{Metric::no_load_speed},
        MetricRequest{Metric::holding_torque}, MetricRequest{Metric::max_pressure},
        MetricRequest{Metric::peak_power}}) {
    CAPTURE(info(request.metric).name);
    const double right = evaluate(Motor(even), request).value;
    CHECK(std::fabs(evaluate(Motor(worn), request).value / right - 1) <= 1e-9);
  }
}

TEST_CASE("the Jacobian of the rates is that of their differences (V3.3)",
          "[core][wear][derivative]") {
  const auto check = [](const MotorDesign& design, const std::optional<LoadPoint>& load) {
    TrackWear track(design, load);
    const std::size_t n = track.nodes().size();
    const auto depths = some_depths(n);
    const TrackRates found = track.at(depths);
    REQUIRE(found.status == MetricStatus::ok);
    double scale = 0, turn_scale = 0;
    for (const double J : found.jacobian) scale = std::fmax(scale, std::fabs(J));
    for (const double J : found.turn_slopes) turn_scale = std::fmax(turn_scale, std::fabs(J));
    // of depths of 1e-7 m: differences of rates that are known to 1e-12, and the square of 1e-4
    const double h = 1e-11;
    for (std::size_t k = 0; k < n; ++k) {
      auto above = depths, below = depths;
      above[k] += h, below[k] -= h;
      const TrackRates up = track.at(above), down = track.at(below);
      for (std::size_t j = 0; j < n; ++j) {
        CAPTURE(j, k);
        const double slope = (up.rates[j] - down.rates[j]) / (2 * h);
        CHECK(std::fabs(found.jacobian[k * n + j] - slope) <= 1e-6 * scale);
      }
      CHECK(std::fabs(found.turn_slopes[k] - (up.turns - down.turns) / (2 * h)) <=
            1e-5 * turn_scale);
    }
  };
  check(wearing(elastic_layer(6), 1e5), torque_load(0.6));
  check(wearing(elastic_layer(6), 1e5), LoadPoint{Argument::speed, 9, 0});
  check(wearing(driven_with_slices(6), 1e5), torque_load(0.5));
  check(wearing(driven_with_slices(6), 1e5), LoadPoint{Argument::speed, 9, 0});
  MotorDesign mission = wearing(elastic_layer(6), 1e5);
  mission.wear->stator_specific_wear = 0.3e-15;
  mission.operation = {{torque_load(0.7), 2, {}}, {{}, 5, {}}, {torque_load(0.5), 1, {}}};
  check(mission, {});
}

TEST_CASE("with one speed all through a track the worn-in state stays (V3.4)",
          "[core][wear][identity]") {
  const MotorDesign design = wearing(elastic_layer(8));
  const WornIn state = worn_in(design, torque_load(0.8));
  REQUIRE(state.status == MetricStatus::ok);
  std::vector<double> depths;
  for (const WornInSlice& slice : state.slices) depths.push_back(slice.worn);
  MotorDesign stator_wears = design;  // so that the layer keeps its thickness, as (V3.4) takes it
  stator_wears.wear->specific_wear = 0;
  stator_wears.wear->stator_specific_wear = 1e-15;
  const TrackRates found = TrackWear(stator_wears, torque_load(0.8)).at(depths);
  REQUIRE(found.status == MetricStatus::ok);
  for (std::size_t j = 0; j < depths.size(); ++j) {
    // the state is known to 1e-12, and the rate of a node moves some ten times as much
    CHECK(std::fabs(found.rates[j] * design.friction.kinetic / 1e-15 / state.intensity - 1) <=
          1e-9);
    CHECK(std::fabs(found.loads[0].loads[j] / state.slices[j].load - 1) <= 1e-9);
  }
  CHECK(std::fabs(found.loads[0].speed / state.speed - 1) <= 1e-10);
  CHECK(wear_stability(TrackWear(design, torque_load(0.8)).at(std::vector<double>(8))) ==
        WearStability::even);
  CHECK(wear_stability(TrackWear(design, torque_load(0.6)).at(std::vector<double>(8))) ==
        WearStability::uneven);
}

TEST_CASE("what a free profile leaves out is refused", "[core][wear]") {
  const MotorDesign design = wearing(elastic_layer(8));
  CHECK_THROWS_WITH(TrackWear(wearing(elastic_layer(1)), torque_load(0.5)),
                    Catch::Contains("radial_slices"));
  MotorDesign radial = design;
  radial.stator.radial_motion = true;
  CHECK_THROWS_WITH(TrackWear(radial, torque_load(0.5)), Catch::Contains("radial_motion"));
  CHECK_THROWS_WITH(TrackWear(design, LoadPoint{Argument::both, 9, 0.5}),
                    Catch::Contains("torque and speed"));
  CHECK_THROWS_WITH(TrackWear(design, {}), Catch::Contains("operation"));
  MotorDesign warm = wearing(with_table(warm_motor()));
  warm.stator.radial_slices = 8;
  CHECK_THROWS_WITH(TrackWear(warm, torque_load(0.5)),
                    Catch::Contains("drift_resonance_frequency"));
  CHECK_THROWS_WITH(worn_motor(design, std::vector<double>(8, 1e-3)), Catch::Contains("beyond"));
  CHECK(TrackWear(design, torque_load(5)).at(std::vector<double>(8)).status != MetricStatus::ok);
}
