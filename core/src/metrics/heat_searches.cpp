// SPDX-License-Identifier: Apache-2.0
// The torque that a motor carries for ever, and the temperature at which it starts.
#include "metrics/heat_metrics.hpp"

#include "curve/curve.hpp"
#include "metrics/heat_numbers.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

// Of the torque at which a motor just finds no steady temperature any more. A passage beyond takes 1 / sqrt of it in time.
constexpr double kEndOfTorque = 1e-9;
// The gain is 1 at a fold and differs there by the root of kEndOfTorque; where the warm motor has no point any more it is less.
constexpr double kGainAtFold = 0.99;

double answer(const MetricValue& found) {
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return found.value;
}

}  // namespace

LoadPoint HeatMetrics::load_with(const MetricRequest& request, double torque) const {
  if (request.metric == M::continuous_torque) return {Argument::torque, torque, 0};
  return {Argument::both, request.at, torque};
}

// What the cold motor carries: it has to begin with the load.
double HeatMetrics::most_torque(const MetricRequest& request) {
  const Motor cold(design_);
  const MetricRequest most =
      request.metric == M::continuous_torque
          ? MetricRequest{M::max_torque}
          : MetricRequest{M::held_torque_limit_at, Argument::speed, request.at};
  return answer(twum::evaluate(cold, most));
}

// The state that Newton's method finds from that of a load close by.
HeatMetrics::Known HeatMetrics::followed(const LoadPoint& load, const NodeTemperatures& from) {
  const HeatSolver solver(problem(load));
  Known found{load, solver.near(from), {}};
  found.parts = solver.parts(found.steady.state);
  return found;
}

// Samples from no load up to what the cold motor carries; between the last good one and the first bad one the state is followed.
HeatMetrics::Continuous HeatMetrics::continuous(const MetricRequest& request) {
  constexpr int kSamples = 16;
  Known good = steady(load_with(request, 0));
  if (margin(good) < 0) throw SearchFailure{MetricStatus::too_hot_at_no_load};
  const double top = most_torque(request);
  double from = 0, to = top;
  for (int i = 1; i <= kSamples; ++i) {
    to = top * i / kSamples;
    const Known& at = known(load_with(request, to));
    if (!keeps_limits(at)) break;
    if (i == kSamples) return {at, top, Limiting::load};
    good = at, from = to;
  }
  double too_hot = kNoValue;  // its margin, where there is a state
  while (std::isnan(too_hot) && to - from > kEndOfTorque * top) {
    const double middle = 0.5 * (from + to);
    const Known at = followed(load_with(request, middle), good.steady.state.x);
    if (keeps_limits(at)) {
      good = at, from = middle;
    } else {
      to = middle;
      if (at.steady.ok()) too_hot = margin(at);
    }
  }
  if (std::isnan(too_hot))
    return {good, from, good.steady.gain > kGainAtFold ? Limiting::fold : Limiting::lost};
  const auto margin_at = [&](double torque) {
    const Known at = followed(load_with(request, torque), good.steady.state.x);
    return at.steady.ok() ? margin(at) : kNoValue;
  };
  const double torque =
      closed_in("the continuous torque", margin_at, {from, to, margin(good), too_hot}, 44)
          .nearest();
  return {followed(load_with(request, torque), good.steady.state.x), torque, Limiting::temperature};
}

bool HeatMetrics::keeps_limits(const Known& at) const {
  return at.steady.ok() && !(margin(at) < 0);
}

MetricDerivative HeatMetrics::of_continuous(const MetricRequest& request, const MetricValue& value,
                                            bool fixed) {
  const Continuous found = continuous(request);
  switch (found.limiting) {
    case Limiting::temperature: return of_limit(request, found, value, fixed);
    case Limiting::fold: return of_fold(request, found, value, fixed);
    case Limiting::load: break;
    case Limiting::lost: return no_derivative(value);
  }
  if (request.metric != M::continuous_torque) return no_derivative(value);
  MetricDerivative result =
      twum::differentiate(Motor(design_), MetricRequest{M::max_torque}, fixed);
  result.value = value;
  return result;
}

// The margin stays zero (H6.2).
MetricDerivative HeatMetrics::of_limit(const MetricRequest& request, const Continuous& found,
                                       const MetricValue& value, bool fixed) {
  MetricDerivative result = of_margin(found.state, {0, MetricStatus::ok}, fixed);
  if (result.smoothness == Smoothness::undefined) return no_derivative(value);
  const double slope = by_load(
      design_,
      [&](double torque) {
        const Known at = followed(load_with(request, torque), found.state.steady.state.x);
        return at.steady.ok() ? margin(at) : kNoValue;
      },
      found.torque);
  for (double& d : result.gradient) d /= -slope;
  if (!std::isfinite(slope)) return no_derivative(value);
  result.value = value;
  return result;
}

// I - Phi_x is singular, w its left null vector: along the folds w . (Phi_q dq + Phi_T dT) = 0 (H6.3).
MetricDerivative HeatMetrics::of_fold(const MetricRequest& request, const Continuous& found,
                                      const MetricValue& value, bool fixed) {
  const HeatState& state = found.state.steady.state;
  const auto rows = at_fixed_nodes(found.state, fixed);
  if (!rows) return no_derivative(value);
  const HeatSolver solver(problem(found.state.load));
  const Matrix3 a = plus(kIdentity3, -1, solver.loop(state.slope));
  Vector3 w{};
  for (std::size_t i = 0; i < 3; ++i) {  // rows of the adjugate are multiples of w
    const Vector3 row{cofactors({{{}, a[1], a[2]}})[i], cofactors({{{}, a[2], a[0]}})[i],
                      cofactors({{{}, a[0], a[1]}})[i]};
    if (largest(row) > largest(w)) w = row;
  }
  const double by_torque = by_load(
      design_,
      [&](double torque) {
        const WarmLosses losses = LoadLosses(design_, load_with(request, torque)).at(state.x);
        return losses.status == MetricStatus::ok ? dot(w, solver.image(losses.p)) : kNoValue;
      },
      found.torque);
  if (!std::isfinite(by_torque)) return no_derivative(value);
  MetricDerivative result{value, {}, Smoothness::smooth};
  for (std::size_t q = 0; q < kParameterCount; ++q)
    for (std::size_t i = 0; i < 3; ++i)
      result.gradient[q] -= w[i] * rows->parts[kNodeParts[i]][q] / by_torque;
  return result;
}

// U - start_voltage of the motor at one temperature.
double HeatMetrics::voltage_to_spare(double temperature) const {
  const auto warm = at_temperatures(design_, {temperature, temperature, temperature});
  if (!warm) throw SearchFailure{MetricStatus::temperature_out_of_range};
  return *design_.stator.voltage - answer(twum::evaluate(Motor(*warm), {M::start_voltage}));
}

// From ambient downwards while the motor starts, else upwards until it does, in steps of 5 K.
double HeatMetrics::start_temperature() {
  constexpr double kStep = 5, kColdest = 1, kHottest = 1000;
  if (!design_.stator.voltage) throw SearchFailure{MetricStatus::undefined};
  if (!drifts(design_)) throw SearchFailure{MetricStatus::temperature_out_of_range};
  double here = design_.thermal->ambient, spare = voltage_to_spare(here);
  const double step = spare >= 0 ? -kStep : kStep;
  for (;;) {
    const double next = here + step;
    if (next < kColdest || next > kHottest)
      throw SearchFailure{MetricStatus::temperature_out_of_range};
    const double there = voltage_to_spare(next);
    if ((spare >= 0) != (there >= 0)) {
      const auto f = [&](double T) { return voltage_to_spare(T); };
      const Bracket ends =
          step > 0 ? Bracket{here, next, spare, there} : Bracket{next, here, there, spare};
      return closed_in("the start temperature", f, ends, 44).nearest();
    }
    here = next, spare = there;
  }
}

// U - U_start(q, T) = 0.
MetricDerivative HeatMetrics::of_start(const MetricValue& value, bool fixed) {
  const NodeTemperatures x{value.value, value.value, value.value};
  MetricDerivative result =
      twum::differentiate(Motor(*at_temperatures(design_, x)), {M::start_voltage}, fixed);
  const DriftRule rule(design_, fixed);
  const Vector3 by_nodes = rule.by_temperatures(result.gradient);
  const double by_temperature = by_nodes[0] + by_nodes[1] + by_nodes[2];
  Gradient g = rule.at_fixed_temperatures(result.gradient, x);
  g[index_of(P::voltage)] -= 1;
  for (double& d : g) d /= -by_temperature;
  result.gradient = g;
  result.value = value;
  return result;
}

}  // namespace twum::inline v0_1::core
