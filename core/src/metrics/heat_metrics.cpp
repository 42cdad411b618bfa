// SPDX-License-Identifier: Apache-2.0
#include "metrics/heat_metrics.hpp"

#include "metrics/found_value.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

}  // namespace

std::optional<std::size_t> part_of(M metric) {
  switch (metric) {
    case M::stator_temperature_at:
    case M::stator_peak_temperature: return 0;
    case M::rotor_temperature_at:
    case M::rotor_peak_temperature: return 1;
    case M::housing_temperature_at:
    case M::housing_peak_temperature: return 2;
    case M::contact_temperature_at:
    case M::contact_peak_temperature: return 3;
    default: return {};
  }
}

const HeatNetwork& HeatMetrics::network() {
  if (!network_) network_ = network_of(design_);
  return *network_;
}

const std::shared_ptr<WarmMotors>& HeatMetrics::motors() {
  if (!motors_) motors_ = std::make_shared<WarmMotors>(motor_);
  return motors_;
}

HeatProblem HeatMetrics::problem(const LoadPoint& load) {
  return heat_problem(design_, network(), load, motors());
}

const HeatMetrics::Known& HeatMetrics::known(const LoadPoint& load) {
  for (const Known& one : known_)
    if (one.load == load) return one;
  const HeatSolver solver(problem(load));
  Known found{load, solver.from_cold(), {}};
  found.parts = solver.parts(found.steady.state);
  return known_.emplace_back(found);
}

const HeatMetrics::Known& HeatMetrics::steady(const LoadPoint& load) {
  const Known& found = known(load);
  if (!found.steady.ok()) throw SearchFailure{found.steady.state.status};
  return found;
}

std::size_t HeatMetrics::hottest(const Known& known) const {
  const PartValues<double> limit = temperature_limits(design_);
  std::size_t least = 0;
  for (std::size_t i = 1; i < kParts; ++i)
    if (limit[i] - known.parts[i] < limit[least] - known.parts[least]) least = i;
  return least;
}

double HeatMetrics::margin(const Known& known) const {
  const std::size_t part = hottest(known);
  return temperature_limits(design_)[part] - known.parts[part];
}

NodeTemperatures HeatMetrics::nodes(const LoadPoint& load) {
  return load.argument == Argument::none ? mean_nodes() : steady(load).steady.state.x;
}

double HeatMetrics::value(const MetricRequest& request) {
  if (request.warm_at) {
    MetricRequest plain = request;
    plain.warm_at.reset();
    const auto warm = motors()->at(nodes(*request.warm_at));
    if (!warm) throw SearchFailure{MetricStatus::temperature_out_of_range};
    const MetricValue found = twum::evaluate(*warm, plain);
    if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
    return found.value;
  }
  switch (request.metric) {
    case M::thermal_time_constant: return time_constants(network()).back();
    case M::continuous_torque:
    case M::continuous_torque_at: return continuous(request).torque;
    case M::start_temperature: return start_temperature();
    case M::on_time_at: return on_time(load_of(request)).moment.time;
    case M::duty_limit_at: return duty_limit(load_of(request)).share;
    case M::stator_peak_temperature:
    case M::rotor_peak_temperature:
    case M::housing_peak_temperature:
    case M::contact_peak_temperature: return peak(*part_of(request.metric));
    case M::thermal_gain_at: return steady(load_of(request)).steady.gain;
    case M::temperature_margin_at: {
      const double least = margin(steady(load_of(request)));
      if (std::isinf(least)) throw SearchFailure{MetricStatus::undefined};
      return least;
    }
    default:
      if (is_timed(request)) return after(request);
      return steady(load_of(request)).parts[*part_of(request.metric)];
  }
}

MetricValue HeatMetrics::evaluate(const MetricRequest& request) {
  if (!design_.thermal) return {kNoValue, MetricStatus::undefined};
  if (request.after && !(*request.after >= 0)) return {kNoValue, MetricStatus::out_of_range};
  const LoadPoint load = request.warm_at ? *request.warm_at : load_of(request);
  if (load.argument == Argument::both && !(load.at > 0)) return {kNoValue, MetricStatus::undefined};
  return found_value([&] { return value(request); });
}

}  // namespace twum::inline v0_1::core
