// SPDX-License-Identifier: Apache-2.0
// Lives with a free profile of wear: an integration that shares only contacts of one slice, the worn-in state, limits and scalings.
#include <catch2/catch.hpp>

#include <twum/base/gauss_rule.hpp>
#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/worn_in.hpp>
#include <twum/motion/free_life.hpp>
#include <twum/motion/manoeuvres.hpp>

#include "support/metric_requests.hpp"
#include "support/wearing_motors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

namespace {

constexpr double kHour = 3600;

FreeLifeOptions at_hours(std::vector<double> hours) {
  FreeLifeOptions options;
  for (const double one : hours) options.output_times.push_back(one * kHour);
  options.longest = options.output_times.back();
  options.beyond_localization = true;
  return options;
}

double rpm(const WornTrackPoint& point) { return point.loads.at(0).speed * 30 / std::numbers::pi; }

// The stator wears, so that the layer keeps its thickness.
MotorDesign with_wearing_stator(MotorDesign design) {
  std::swap(*design.wear->specific_wear, design.wear->stator_specific_wear);
  return design;
}

// Rates at a speed from closed forms of the normal contact (T3.1, T3.3, W2.1) and from motors of one slice.
class SlicesByThemselves {
 public:
  SlicesByThemselves(MotorDesign design, int nodes, double speed)
      : design_(std::move(design)), nodes_(gauss_rule(nodes).nodes), speed_(speed) {}

  std::vector<double> rates(const std::vector<double>& depths) const {
    double low = -1e-6, high = 20e-6;  // between them the rotor carries the preload
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (force(depths, middle) < preload(depths) ? low : high) = middle;
    }
    std::vector<double> found;
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      const double load = load_of(j, depths[j], low);
      found.push_back(load > 0 ? rate(j, depths[j], load) : 0);
    }
    return found;
  }

 private:
  double radius(std::size_t j) const {
    return design_.stator.contact_radius + (nodes_[j].place - 0.5) * design_.stator.contact_width;
  }
  double width(std::size_t j) const { return nodes_[j].weight * design_.stator.contact_width; }
  double thickness(double depth) const { return design_.layer.thickness - depth; }  // chi = 1
  double preload(const std::vector<double>& depths) const {
    double sum = 0, area = 0;
    for (std::size_t j = 0; j < nodes_.size(); ++j)
      sum += radius(j) * width(j) * depths[j], area += radius(j) * width(j);
    return design_.preload - design_.wear->preload_spring * sum / area;
  }
  double load_of(std::size_t j, double worn, double rotor) const {
    const double A = design_.stator.amplitude, depth = rotor - worn;
    if (depth <= 0) return 0;
    const double unit = 2 * radius(j) * width(j) * design_.layer.youngs_modulus / thickness(worn);
    if (depth >= 2 * A) return unit * std::numbers::pi * (depth - A);
    const double angle = std::acos(1 - depth / A);
    return unit * A * (std::sin(angle) - angle * std::cos(angle));
  }
  double force(const std::vector<double>& depths, double rotor) const {
    double sum = 0;
    for (std::size_t j = 0; j < nodes_.size(); ++j) sum += load_of(j, depths[j], rotor);
    return sum;
  }
  double rate(std::size_t j, double worn, double load) const {
    MotorDesign slice = design_;
    slice.stator.radial_slices = 1;
    slice.stator.contact_radius = radius(j), slice.stator.contact_width = width(j);
    slice.layer.thickness = thickness(worn);
    slice.preload = load;
    const double intensity =
        evaluate(Motor(slice), {Metric::wear_intensity_at, Argument::speed, speed_}).value;
    return *design_.wear->specific_wear / design_.friction.kinetic * intensity;
  }

  MotorDesign design_;
  std::vector<GaussRule::Node> nodes_;
  double speed_;
};

// The classical method of Runge and Kutta.
std::vector<double> integrated(const SlicesByThemselves& slices, std::size_t nodes, double time,
                               int steps) {
  std::vector<double> y(nodes);
  const double h = time / steps;
  const auto moved = [&](double by, const std::vector<double>& along) {
    std::vector<double> there = y;
    for (std::size_t j = 0; j < nodes; ++j) there[j] += by * along[j];
    return there;
  };
  for (int i = 0; i < steps; ++i) {
    const auto a = slices.rates(y), b = slices.rates(moved(h / 2, a)),
               c = slices.rates(moved(h / 2, b)), d = slices.rates(moved(h, c));
    for (std::size_t j = 0; j < nodes; ++j) y[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
  }
  return y;
}

}  // namespace

TEST_CASE("depths over time are those of slices by themselves (V3.1, V3.2, V3.3)",
          "[motion][wear][differential]") {
  const double speed = GENERATE(10.5, 3.0);  // where one radius wins, and where all drag
  MotorDesign design = wearing(elastic_layer(4), 2e5);
  design.layer.density = 0;
  const double hours = 12;
  const FreeLife found =
      free_life(design, LoadPoint{Argument::speed, speed, 0}, at_hours({0, hours}));
  REQUIRE(found.points.size() == 2);
  const auto right = integrated({design, 4, speed}, 4, hours * kHour, 200);
  for (std::size_t j = 0; j < right.size(); ++j) {
    CAPTURE(speed, j);
    // 200 steps of a fast time of an hour leave some 1e-8
    CHECK(std::fabs(found.points[1].depths[j] / right[j] - 1) <= 1e-6);
  }
}

TEST_CASE("a track that is worn in is that of (V3.4), however it came there",
          "[motion][wear][limit]") {
  const MotorDesign design = with_wearing_stator(wearing(elastic_layer(8)));
  const LoadPoint load =
      GENERATE(torque_load(0.8), LoadPoint{Argument::speed, std::numbers::pi, 0});
  const WornIn state = worn_in(design, load);
  const FreeLife found = free_life(design, load, at_hours({100}));
  REQUIRE(state.status == MetricStatus::ok);
  CHECK(found.stability == WearStability::even);
  const WornTrackPoint& end = found.points.at(0);
  const double least = *std::ranges::min_element(end.depths);
  for (std::size_t j = 0; j < end.depths.size(); ++j) {
    // after 100 h differences have decayed to some 1e-11 of the amplitude
    CHECK(std::fabs(end.depths[j] - least - state.slices[j].worn) <=
          1e-8 * design.stator.amplitude);
    CHECK(std::fabs(end.rates[j] * design.friction.kinetic / 1e-15 / state.intensity - 1) <= 1e-7);
  }
  CHECK(std::fabs(end.loads[0].speed / state.speed - 1) <= 1e-8);
}

TEST_CASE("speeds and losses of the table of the theory (V3.7)", "[motion][wear][differential]") {
  // of a second program, as printed: half a unit of the last digit
  const auto run_in = free_life(with_wearing_stator(wearing(elastic_layer(16))), torque_load(0.8),
                                at_hours({0, 100}));
  CHECK(std::fabs(rpm(run_in.points[0]) - 105.07) <= 0.005);
  CHECK(std::fabs(rpm(run_in.points[1]) - 99.00) <= 0.005);
  CHECK(std::fabs(run_in.points[0].loads[0].friction_power - 3.288) <= 0.0005);
  CHECK(std::fabs(run_in.points[1].loads[0].friction_power - 3.456) <= 0.0005);
  const auto eight = free_life(wearing(elastic_layer(8)), torque_load(0.4), at_hours({0, 100}));
  CHECK(eight.stability == WearStability::uneven);
  CHECK(std::fabs(rpm(eight.points[0]) - 127.8) <= 0.05);
  CHECK(std::fabs(rpm(eight.points[1]) - 94.0) <= 0.05);
  CHECK(std::fabs(eight.points[1].loads[0].friction_power - 1.78) <= 0.005);
  const auto& carried = eight.points[1].loads[0].loads;
  CHECK(std::fabs(carried.back() / eight.points[1].preload - 0.62) <= 0.005);
  const auto sixteen = free_life(wearing(elastic_layer(16)), torque_load(0.4), at_hours({100}));
  CHECK(std::fabs(rpm(sixteen.points[0]) - 98.4) <= 0.05);
  CHECK(std::fabs(sixteen.points[0].loads[0].friction_power - 2.01) <= 0.005);
}

TEST_CASE("wear that localizes ends without a life", "[motion][wear]") {
  const FreeLife found = free_life(wearing(elastic_layer(8)), torque_load(0.4));
  CHECK(found.status == MetricStatus::wear_localizes);
  CHECK(found.stability == WearStability::uneven);
  CHECK(found.end == EndOfLife::none);
  CHECK(std::fabs(found.largest_share - 3) <= 1e-6);  // a root of the margin
  CHECK(found.last.seconds > 0);
}

TEST_CASE("k times c gives the time over c (C15.2)", "[motion][wear][scaling]") {
  const LoadPoint load = torque_load(0.8);
  const FreeLife once = free_life(wearing(elastic_layer(8), 1e5), load),
                 faster = free_life(wearing(elastic_layer(8), 1e5, 4e-6), load);
  REQUIRE(once.status == MetricStatus::ok);
  CHECK(once.end == EndOfLife::depth_limit);
  // the first step is one in seconds, and then steps are not the same: what the tolerance leaves
  CHECK(std::fabs(4 * faster.last.seconds / once.last.seconds - 1) <= 1e-8);
  CHECK(std::fabs(4 * faster.last.revolutions / once.last.revolutions - 1) <= 1e-8);
}

TEST_CASE("a narrow track wears evenly, as one slice does (V3.7)", "[motion][wear][limit]") {
  const auto narrow = [](int slices) {
    MotorDesign design = wearing(elastic_layer(slices), 1e4);
    design.stator.contact_width *= 1e-3;
    design.preload *= 1e-3;
    design.wear->preload_spring *= 1e-3;
    return design;
  };
  const LoadPoint load{Argument::speed, 9, 0};
  const FreeLife free = free_life(narrow(8), load);
  const Life even = life(narrow(8), load), one = life(narrow(1), load);
  REQUIRE(free.status == MetricStatus::ok);
  CHECK(free.stability == WearStability::even);
  // the speeds of rotor and wave differ by 1e-4 over the width, and the mean by its square
  CHECK(std::fabs(free.last.seconds / even.seconds - 1) <= 1e-4);
  CHECK(std::fabs(free.last.seconds / one.seconds - 1) <= 1e-4);
}

TEST_CASE("after run-in a life is that at the rate of the worn-in state", "[motion][wear][limit]") {
  MotorDesign design = with_wearing_stator(wearing(elastic_layer(8)));
  design.wear->depth_limit = 1e-3;
  const LoadPoint load = torque_load(0.8);
  const WornIn state = worn_in(design, load);
  const FreeLife found = free_life(design, load);
  REQUIRE(found.status == MetricStatus::ok);
  const double rate = 1e-15 / design.friction.kinetic * state.intensity;
  CHECK(std::fabs(*std::ranges::max_element(found.last.depths) / 1e-3 - 1) <= 1e-10);  // the root
  CHECK(std::fabs(found.last.rates[0] / rate - 1) <= 1e-9);
  // run-in removes less than two elastic depths, of 1 um together, in its own time
  CHECK(std::fabs(found.last.seconds * rate / 1e-3 - 1) <= 1e-3);
}

TEST_CASE("a contact that sticks all through does not wear", "[motion][wear][limit]") {
  MotorDesign design = wearing(elastic_layer(8));
  design.layer.given_shear_modulus = 1e7;
  design.friction = {1, 1};
  design.preload = 8 * full_contact_load(design);
  REQUIRE(Motor(design).locks_at_rest());
  const FreeLife found = free_life(design, LoadPoint{Argument::speed, 0, 0});
  CHECK(found.status == MetricStatus::does_not_wear);
  CHECK(found.end == EndOfLife::none);
}

TEST_CASE("what ends a life is found within a step", "[motion][wear]") {
  MotorDesign design = wearing(elastic_layer(8), 1e5);
  const LoadPoint load = torque_load(0.8);
  SECTION("a limit") {
    const double new_torque = evaluate(Motor(design), {Metric::stall_torque}).value;
    design.wear->until = {{{Metric::stall_torque}, 0.99 * new_torque, HUGE_VAL, ""}};
    const FreeLife found = free_life(design, load);
    REQUIRE(found.end == EndOfLife::limit);
    const Motor worn(worn_motor(design, found.last.depths));
    // the root is closed in to 40 bits of the time
    CHECK(std::fabs(evaluate(worn, {Metric::stall_torque}).value / (0.99 * new_torque) - 1) <=
          1e-8);
  }
  SECTION("a limit that the new motor breaks") {
    design.wear->until = {{{Metric::stall_torque}, 5, HUGE_VAL, ""}};
    const FreeLife found = free_life(design, load);
    CHECK(found.end == EndOfLife::limit);
    CHECK(found.last.seconds == 0);
  }
  SECTION("the load") {
    design.wear->preload_spring = 2e6;
    const FreeLife found = free_life(design, load);
    REQUIRE(found.end == EndOfLife::load_lost);
    const auto stall = [&](double depth) {
      std::vector<double> depths = found.last.depths;
      for (double& one : depths) one += depth;
      return evaluate(Motor(worn_motor(design, depths)), {Metric::stall_torque}).value;
    };
    CHECK(stall(0) >= 0.8);
    CHECK(stall(0.001e-6) < 0.8);
  }
  SECTION("the wave") {
    const MotorDesign driven = wearing(driven_with_slices(8), 1e5);
    const FreeLife found = free_life(driven, torque_load(1));
    REQUIRE(found.end == EndOfLife::load_lost);
    const auto carries = [&](double depth) {
      std::vector<double> depths = found.last.depths;
      for (double& one : depths) one += depth;
      return evaluate(Motor(worn_motor(driven, depths)), metric_at_torque(Metric::speed_at, 1))
                 .status == MetricStatus::ok;
    };
    // a ten-millionth of the time is some picometres
    CHECK(carries(-1e-9));
    CHECK(!carries(1e-9));
  }
  SECTION("the spring") {
    design.wear->preload_spring = 1e7;
    const FreeLife found = free_life(design, LoadPoint{Argument::speed, 3, 0});
    CHECK(found.end == EndOfLife::preload_gone);
    CHECK(found.last.depth <= 16e-6);
  }
}

TEST_CASE("a mission wears at the mean of its loads", "[motion][wear][identity]") {
  MotorDesign design = wearing(elastic_layer(8), 1e5);
  design.operation = {{torque_load(0.8), 60, {}}};
  const FreeLife one = free_life(design, torque_load(0.8)), alone = free_life(design, {});
  CHECK(one.last.seconds == alone.last.seconds);
  // with as much rest the same in twice the time
  design.operation.push_back({{}, 60, {}});
  const FreeLife rests = free_life(design, {});
  CHECK(std::fabs(rests.last.seconds / one.last.seconds - 2) <= 1e-7);
  design.operation = {{torque_load(0.8), 30, {}}, {torque_load(0.75), 30, {}}};
  const FreeLife two = free_life(design, {});
  CHECK(two.last.loads.size() == 2);
  CHECK(two.last.seconds > one.last.seconds);
  CHECK(two.last.seconds < free_life(design, torque_load(0.75)).last.seconds);
}

TEST_CASE("metrics of lives take the profile of the design", "[motion][wear]") {
  MotorDesign design = wearing(elastic_layer(8), 1e5);
  design.wear->profile = WearProfile::free;
  design.operation = {{torque_load(0.8), 60, {}}, {{}, 60, {}}};
  const FreeLife right = free_life(design, torque_load(0.8)), mission = free_life(design, {});
  MetricRequest worn{Metric::stall_torque};
  worn.worn_at = torque_load(0.8);
  const MetricRequest asked[] = {metric_at_torque(Metric::life_at, 0.8),
                                 metric_at_torque(Metric::life_revolutions_at, 0.8),
                                 {Metric::life},
                                 worn,
                                 metric_at_torque(Metric::life_at, 0.4)};
  const auto found = evaluate(Motor(design), asked);
  CHECK(found[0].value == right.last.seconds);
  CHECK(found[1].value == right.last.revolutions);
  CHECK(found[2].value == mission.last.seconds);
  CHECK(found[3].value ==
        evaluate(Motor(worn_motor(design, right.last.depths)), {Metric::stall_torque}).value);
  CHECK(found[4].status == MetricStatus::wear_localizes);
  CHECK(differentiate(Motor(design), asked[0]).smoothness == Smoothness::undefined);
  design.wear->profile = WearProfile::even;
  CHECK(evaluate(Motor(design), asked[0]).value == life(design, torque_load(0.8)).seconds);
}

TEST_CASE("a motor under a voltage runs in, too", "[motion][wear]") {
  const MotorDesign design = wearing(driven_with_slices(8), 1e5);
  const FreeLife found = free_life(design, torque_load(0.95), at_hours({0, 1, 5}));
  REQUIRE(found.points.size() == 3);
  for (const WornTrackPoint& point : found.points) {
    // the motor with these depths, searched anew
    const Motor worn(worn_motor(design, point.depths));
    const double speed = evaluate(worn, metric_at_torque(Metric::speed_at, 0.95)).value;
    CHECK(std::fabs(point.loads[0].speed / speed - 1) <= 1e-9);
  }
  CHECK(found.points[2].loads[0].speed < found.points[0].loads[0].speed);
}
