// SPDX-License-Identifier: Apache-2.0
#include "metrics/wear_rates.hpp"

#include "curve/curve.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace twum::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kTurn = 2 * std::numbers::pi;

double known(const MetricValue& found) {
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return found.value;
}

MetricDerivative known(const MetricDerivative& found) {
  if (found.value.status != MetricStatus::ok) throw SearchFailure{found.value.status};
  if (found.smoothness == Smoothness::undefined) throw SearchFailure{MetricStatus::undefined};
  return found;
}

void add(Gradient& to, double factor, const Gradient& more) {
  for (std::size_t q = 0; q < kParameterCount; ++q) to[q] += factor * more[q];
}

double drift_of(const std::optional<double>& coefficient) { return coefficient.value_or(0); }

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

// The wear intensity, the speed unless it is given, and the contact's temperature of a motor that has some.
WearRates::Asked WearRates::asked(const LoadPoint& load) const {
  Asked asked{at_load(M::wear_intensity_at, load)};
  if (load.argument == Argument::torque) asked.push_back(at_load(M::speed_at, load));
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
  const MetricDerivative intensity = known(found[0]);
  std::optional<MetricDerivative> contact;
  WearRate rate;
  if (is_warm()) contact = known(found.back()), rate.contact_temperature = contact->value.value;
  rate.depth = ratio(rate.contact_temperature) * intensity.value.value;
  add(rate.depth_slope, ratio(rate.contact_temperature), intensity.gradient);
  add(rate.depth_slope, rate.depth, by_ratio(contact));
  rate.turns = std::fabs(load.at) / kTurn;
  if (load.argument == Argument::torque) {
    const MetricDerivative speed = known(found[1]);
    rate.turns = std::fabs(speed.value.value) / kTurn;
    add(rate.turn_slope, 1 / kTurn, speed.gradient);
  }
  if (phase.voltage)
    rate.depth_slope[index_of(P::voltage)] = rate.turn_slope[index_of(P::voltage)] = 0;
  return rate;
}

// Of an operation with temperatures: the masses at their means (H5.2), contact and lining at those of each load.
std::vector<NodeTemperatures> WearRates::mission_temperatures(const MotorDesign& worn) const {
  const HeatCourse course(worn, worn.operation);
  const PartValues<double> mean = course.mean(course.periodic());
  const double ambient = worn.thermal->ambient;
  std::vector<NodeTemperatures> nodes;
  for (const CoursePhase& phase : course.phases()) {
    const HeatState state = phase.solver.at_masses(
        {mean[0] - ambient, mean[1] - ambient, mean[2] - ambient}, phase.solver.cold_nodes());
    if (state.status != MetricStatus::ok) throw SearchFailure{state.status};
    nodes.push_back(state.x);
  }
  return nodes;
}

WearRate WearRates::of_mission(double depth) const {
  const MotorDesign worn = worn_design(design_, depth);
  const std::vector<NodeTemperatures> nodes = mission_temperatures(worn);
  WearRate sum;
  sum.contact_temperature = -kNoLimit;
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    if (!loads_[i].load) continue;
    const LoadPoint& load = *loads_[i].load;
    MotorDesign now = worn;
    if (loads_[i].voltage && now.stator.voltage) now.stator.voltage = loads_[i].voltage;
    const auto warm = at_temperatures(now, nodes[i]);
    if (!warm) throw SearchFailure{MetricStatus::temperature_out_of_range};
    const auto ask = [&](Metric metric) {
      return known(twum::evaluate(Motor(*warm), at_load(metric, load)));
    };
    const double speed = load.argument == Argument::torque ? ask(M::speed_at) : load.at;
    sum.depth += loads_[i].time * ratio(nodes[i][1]) * ask(M::wear_intensity_at);
    sum.turns += loads_[i].time * std::fabs(speed) / kTurn;
    sum.contact_temperature = std::fmax(sum.contact_temperature, nodes[i][1]);
  }
  return sum;
}

template <typename RateOf>
WearRate WearRates::sum(RateOf rate_of) const {
  WearRate sum;
  for (const LoadPhase& phase : loads_) {
    if (!phase.load) continue;
    const WearRate one = rate_of(phase);
    sum.depth += phase.time * one.depth;
    sum.turns += phase.time * one.turns;
    sum.contact_temperature = std::fmax(sum.contact_temperature, one.contact_temperature);
    add(sum.depth_slope, phase.time, one.depth_slope);
    add(sum.turn_slope, phase.time, one.turn_slope);
  }
  return sum;
}

WearRate WearRates::at(double depth) {
  if (is_mission() && is_warm()) return of_mission(depth);
  return sum([&](const LoadPhase& phase) { return of_load(phase, depth); });
}

WearRate WearRates::with_slopes(double depth, bool fixed) {
  if (is_mission() && is_warm()) throw SearchFailure{MetricStatus::undefined};
  WearRate rate =
      sum([&](const LoadPhase& phase) { return of_load_with_slopes(phase, depth, fixed); });
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

bool WearRates::confirms(double depth) {
  bool all = true;
  for (WornMotors& one : motors_) all = one.confirms(depth) && all;
  return all;
}

}  // namespace twum::core
