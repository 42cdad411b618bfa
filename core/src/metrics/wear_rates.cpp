// SPDX-License-Identifier: Apache-2.0
#include "metrics/wear_rates.hpp"

#include "curve/curve.hpp"
#include "metrics/found_value.hpp"
#include "metrics/heat_sensitivity.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kTurn = 2 * std::numbers::pi;

MetricDerivative known(const MetricDerivative& found) {
  if (found.value.status != MetricStatus::ok) throw SearchFailure{found.value.status};
  if (found.smoothness == Smoothness::undefined) throw SearchFailure{MetricStatus::undefined};
  return found;
}

void add(Gradient& to, double factor, const Gradient& more) {
  for (std::size_t q = 0; q < kParameterCount; ++q) to[q] += factor * more[q];
}

double drift_of(const std::optional<double>& coefficient) { return coefficient.value_or(0); }

// The wear intensity, and the speed unless it is given.
std::vector<MetricRequest> asked_at(const LoadPoint& load) {
  std::vector<MetricRequest> asked{at_load(M::wear_intensity_at, load)};
  if (load.argument == Argument::torque) asked.push_back(at_load(M::speed_at, load));
  return asked;
}

std::vector<LoadPhase> shares_of(std::vector<LoadPhase> phases) {
  const double period =
      std::accumulate(phases.begin(), phases.end(), 0.0,
                      [](double sum, const LoadPhase& phase) { return sum + phase.time; });
  for (LoadPhase& phase : phases) phase.time /= period;
  return phases;
}

}  // namespace

WearRates::WearRates(const MotorDesign& design, const std::optional<LoadPoint>& load)
    : design_(design),
      loads_(load ? std::vector{LoadPhase{load, 1, {}}} : shares_of(design.operation)) {
  if (loads_.empty()) throw SearchFailure{MetricStatus::undefined};
}

WornMotors& WearRates::motors(const std::optional<double>& voltage) {
  for (WornMotors& one : motors_)
    if (one.voltage() == voltage) return one;
  return motors_.emplace_back(design_, voltage);
}

bool WearRates::is_warm() const {
  return design_.thermal &&
         (drifts(design_) || drift_of(design_.thermal->drift.specific_wear) != 0);
}

bool WearRates::is_mission() const { return loads_.size() > 1 || !loads_.front().load; }

// k / mu at the temperature of the contact.
double WearRates::ratio(double contact) const {
  const double cold = specific_wear_of_both(design_) / design_.friction.kinetic;
  if (std::isnan(contact)) return cold;
  const ThermalDrift& drift = design_.thermal->drift;
  const double way = contact - reference_temperature(design_);
  return cold * (1 + drift_of(drift.specific_wear) * way) /
         (1 + drift_of(drift.kinetic_friction) * way);
}

// Derivatives of ln(k / mu), with the temperature of the contact that follows.
Gradient WearRates::by_ratio(const std::optional<MetricDerivative>& contact) const {
  Gradient g{};
  const double k = specific_wear_of_both(design_);
  g[index_of(P::specific_wear)] += 1 / k;
  g[index_of(P::stator_specific_wear)] += 1 / k;
  g[index_of(P::kinetic_friction)] -= 1 / design_.friction.kinetic;
  if (!contact) return g;
  const ThermalDrift& drift = design_.thermal->drift;
  const double a = drift_of(drift.specific_wear), b = drift_of(drift.kinetic_friction);
  const double way = contact->value.value - reference_temperature(design_);
  const double by_way = a / (1 + a * way) - b / (1 + b * way);
  add(g, by_way, contact->gradient);
  g[index_of(design_.thermal->reference ? P::reference_temperature : P::ambient_temperature)] -=
      by_way;
  g[index_of(P::drift_specific_wear)] += way / (1 + a * way);
  g[index_of(P::drift_kinetic_friction)] -= way / (1 + b * way);
  return g;
}

// With the temperature of the contact of a motor that has some.
std::vector<MetricRequest> WearRates::asked(const LoadPoint& load) const {
  std::vector<MetricRequest> asked = asked_at(load);
  if (!is_warm()) return asked;
  for (MetricRequest& one : asked) one.warm_at = load;
  asked.push_back(at_load(M::contact_temperature_at, load));
  return asked;
}

// (k / mu) I of a load (V1.1), at the steady temperatures under it where the motor has some (V2.1).
WearRate WearRates::of_load(const LoadPhase& phase, double depth) {
  const LoadPoint& load = *phase.load;
  const auto found = motors(phase.voltage).evaluate(depth, asked(load));
  WearRate rate;
  if (is_warm()) rate.contact_temperature = known(found.back());
  rate.depth = ratio(rate.contact_temperature) * known(found[0]);
  rate.turns = std::fabs(load.argument == Argument::torque ? known(found[1]) : load.at) / kTurn;
  return rate;
}

WearRate WearRates::of_load_with_slopes(const LoadPhase& phase, double depth, bool fixed) {
  const LoadPoint& load = *phase.load;
  const auto found = motors(phase.voltage).differentiate(depth, asked(load), fixed);
  const auto at = [&](bool there, const MetricDerivative& one) {
    return there ? std::optional(known(one)) : std::nullopt;
  };
  WearRate rate =
      rate_with_slopes(load, known(found[0]), at(load.argument == Argument::torque, found[1]),
                       at(is_warm(), found.back()));
  if (phase.voltage)
    rate.depth_slope[index_of(P::voltage)] = rate.turn_slope[index_of(P::voltage)] = 0;
  return rate;
}

// @param speed    nothing where it is given
// @param contact  its temperature; nothing without temperatures
WearRate WearRates::rate_with_slopes(const LoadPoint& load, const MetricDerivative& intensity,
                                     const std::optional<MetricDerivative>& speed,
                                     const std::optional<MetricDerivative>& contact) const {
  WearRate rate;
  if (contact) rate.contact_temperature = contact->value.value;
  rate.depth = ratio(rate.contact_temperature) * intensity.value.value;
  add(rate.depth_slope, ratio(rate.contact_temperature), intensity.gradient);
  add(rate.depth_slope, rate.depth, by_ratio(contact));
  rate.turns = std::fabs(speed ? speed->value.value : load.at) / kTurn;
  if (speed) add(rate.turn_slope, std::copysign(1 / kTurn, speed->value.value), speed->gradient);
  return rate;
}

template <typename RateOf>
WearRate WearRates::sum(RateOf rate_of) const {
  WearRate sum;
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    if (!loads_[i].load) continue;
    const WearRate one = rate_of(i);
    const double share = loads_[i].time;
    sum.depth += share * one.depth;
    sum.turns += share * one.turns;
    sum.contact_temperature = std::fmax(sum.contact_temperature, one.contact_temperature);
    add(sum.depth_slope, share, one.depth_slope);
    add(sum.turn_slope, share, one.turn_slope);
  }
  return sum;
}

namespace {

// An operation with temperatures: the masses at their means (H5.2), contact and lining at those of each load.
struct WarmOperation {
  explicit WarmOperation(MotorDesign of)
      : design(std::move(of)), course(design, design.operation), lap(course.periodic()) {
    const PartValues<double> mean = course.mean(lap);
    const double ambient = design.thermal->ambient;
    for (const CoursePhase& phase : course.phases()) {
      const HeatState state = phase.solver.at_masses(
          {mean[0] - ambient, mean[1] - ambient, mean[2] - ambient}, phase.solver.cold_nodes());
      if (state.status != MetricStatus::ok) throw SearchFailure{state.status};
      states.push_back(state);
    }
  }
  WarmOperation(const WarmOperation&) = delete;
  WarmOperation& operator=(const WarmOperation&) = delete;

  // The motor in a phase.
  MotorDesign design_of(std::size_t phase) const {
    MotorDesign now = design;
    const auto& voltage = design.operation[phase].voltage;
    if (voltage && now.stator.voltage) now.stator.voltage = voltage;
    return now;
  }
  Motor motor(std::size_t phase) const {
    const auto warm = at_temperatures(design_of(phase), states[phase].x);
    if (!warm) throw SearchFailure{MetricStatus::temperature_out_of_range};
    return Motor(*warm);
  }

  MotorDesign design;
  HeatCourse course;
  HeatCourse::Lap lap;
  std::vector<HeatState> states;
};

// dX/dq = X_q + X_x dx/dq
MetricDerivative along_nodes(const MetricDerivative& of_warm, const DriftRule& rule,
                             const NodeTemperatures& x, const std::array<Gradient, 3>& moves,
                             bool own_voltage) {
  MetricDerivative found = of_warm;
  const Vector3 by_nodes = rule.by_temperatures(of_warm.gradient);
  found.gradient = rule.at_fixed_temperatures(of_warm.gradient, x);
  if (own_voltage) found.gradient[index_of(P::voltage)] = 0;
  for (std::size_t i = 0; i < 3; ++i) add(found.gradient, by_nodes[i], moves[i]);
  return found;
}

}  // namespace

WearRate WearRates::of_warm_operation(double depth) const {
  const WarmOperation now(worn_design(design_, depth));
  return sum([&](std::size_t i) {
    const LoadPoint& load = *loads_[i].load;
    const auto found = twum::evaluate(now.motor(i), asked_at(load));
    const double contact = now.states[i].x[1];
    const double speed = load.argument == Argument::torque ? known(found[1]) : load.at;
    return WearRate{ratio(contact) * known(found[0]), std::fabs(speed) / kTurn, contact, {}, {}};
  });
}

WearRate WearRates::of_warm_operation_with_slopes(double depth, bool fixed) const {
  const WarmOperation now(worn_design(design_, depth));
  CourseSensitivity sensitivity(now.design, now.course, now.lap, fixed);
  const auto mean = sensitivity.of_mean();
  return sum([&](std::size_t i) {
    const LoadPoint& load = *loads_[i].load;
    const NodeTemperatures& x = now.states[i].x;
    const auto moves = sensitivity.nodes_at_mean(i, now.states[i], mean);
    const DriftRule rule(now.design_of(i), fixed);
    const auto found = twum::differentiate(now.motor(i), asked_at(load), fixed);
    const auto along = [&](const MetricDerivative& one) {
      return along_nodes(known(one), rule, x, moves, loads_[i].voltage.has_value());
    };
    const bool at_torque = load.argument == Argument::torque;
    const MetricDerivative contact{{x[1], MetricStatus::ok}, moves[1], Smoothness::smooth};
    return rate_with_slopes(load, along(found[0]),
                            at_torque ? std::optional(along(found[1])) : std::nullopt, contact);
  });
}

WearRate WearRates::at(double depth) {
  if (is_mission() && is_warm()) return of_warm_operation(depth);
  return sum([&](std::size_t i) { return of_load(loads_[i], depth); });
}

WearRate WearRates::with_slopes(double depth, bool fixed) {
  WearRate rate =
      is_mission() && is_warm()
          ? of_warm_operation_with_slopes(depth, fixed)
          : sum([&](std::size_t i) { return of_load_with_slopes(loads_[i], depth, fixed); });
  rate.depth_slope = by_new_motor(design_, depth, rate.depth_slope);
  rate.turn_slope = by_new_motor(design_, depth, rate.turn_slope);
  return rate;
}

bool WearRates::carries(double depth) {
  try {
    return at(depth).depth >= 0;
  } catch (const SearchFailure&) {
    return false;
  }
}

bool WearRates::confirm_or_stop_following(double depth) {
  bool all = true;
  for (WornMotors& one : motors_) all = one.confirm_or_stop_following(depth) && all;
  return all;
}

}  // namespace twum::inline v0_1::core
