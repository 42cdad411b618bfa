// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/deviations.hpp"
#include "support/expect_derivatives.hpp"
#include "support/metric_requests.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

/// Every metric of the table against every parameter of the table: a new row of either is tested
/// without anyone remembering.
namespace twum::test {

// Each metric at each kind of argument it takes, at points of ordinary use.
inline std::vector<MetricRequest> all_requests(const Motor& motor) {
  const double load = 0.4 * evaluate(motor, {Metric::stall_torque}).value;
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table()) {
    if (is_of_envelope(row.metric)) continue;
    const bool both = row.argument == Argument::speed_or_torque || row.argument == Argument::either;
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
    if (row.argument == Argument::speed || both) {
      requests.push_back({row.metric, Argument::speed, 0.8 * motor.crest_speed()});
    }
    if (row.argument == Argument::torque || both)
      requests.push_back({row.metric, Argument::torque, load});
  }
  return requests;
}

inline std::vector<double> values_at(const MotorDesign& design, Parameter parameter, double x,
                                     const std::vector<MetricRequest>& requests) {
  std::vector<double> values;
  for (const MetricValue& value : evaluate(Motor(with(design, parameter, x)), requests))
    values.push_back(value.value);
  return values;
}

// Parameters that can be moved to both sides: not whole numbers, not at the border of their range.
inline bool movable(const MotorDesign& design, const ParameterInfo& row) {
  if (row.integer || !in_use(design, row.parameter) || get(design, row.parameter) == 0)
    return false;
  return row.parameter != Parameter::static_friction ||
         design.friction.threshold > 1.05 * design.friction.kinetic;
}

// mu_0 moves with mu, which with() sees to; on its own it is a parameter like any other.
inline MotorDesign design_of(Uniform& random, int index) {
  MotorDesign design = realistic_design(random);
  design.stator.modal_damping = random(20, 80);
  const bool threshold = index % 3 == 2;
  design.friction.threshold = design.friction.kinetic * (threshold ? 1.2 : 1.0);
  if (index % 4 == 1) design = damped(design);
  if (index % 4 == 2) design = elastic(design);
  if (index % 4 ==
      3) {  // constants given outright are parameters in use instead of their alternatives
    design.layer.given_shear_modulus = 0.9 * shear_modulus(design);
    design.layer.given_shear_viscosity = shear_viscosity(design);
    design.layer.given_inertia = inertia(design);
  }
  return design;
}

// Few slices, so that the zones of each show in the differences; nothing about the track is left at zero.
inline MotorDesign annulus_of(Uniform& random, int index) {
  MotorDesign design = design_of(random, index);
  const Stator& stator = design.stator;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width;
  design.stator.radial_slices = 3 + index % 3;
  design.stator.radial_shape = {random(-1, 3), random(0.2, 0.8) * inner, {}};
  design.rotor.taper = random(-2, 2) * stator.amplitude / stator.contact_width;
  return design;
}

struct Tally {
  std::map<std::string, int> sharp;  // metric name -> comparisons at full sharpness
  int blunt{0};                      // differences too noisy or across a kink
  int again{0};                      // right by differences with other steps only
  int wrong{0};
  std::vector<std::string> examples;

  int total_sharp() const {
    int total = 0;
    for (const auto& [name, count] : sharp) total += count;
    return total;
  }
};

// Does an exact derivative agree with the differences? `unit` is |f / x|, what a relative change means.
inline bool agrees(double exact, const DifferenceQuotient& found, double unit) {
  return std::abs(exact - found.value) <=
         1e-7 * std::max(std::abs(found.value), unit) + 3 * found.error;
}

inline bool agrees_on_a_side(const MotorDesign& design, const ParameterInfo& row,
                             const MetricRequest& request, double exact, double unit) {
  const double x = get(design, row.parameter);
  const Functions one = [&](double at) { return values_at(design, row.parameter, at, {request}); };
  for (const int side : {-1, 1}) {
    if (agrees(exact, one_sided_differences(one, x, std::abs(x), side)[0], 10 * unit)) return true;
  }
  return false;
}

// What a metric is measured in where it is nearly zero. The ends of zones leave 1e-10 of the scale of powers
// (as in broken_law()), which is 1e-7 of a thousandth of it.
inline double least_size(const Motor& motor, Metric metric) {
  const double power = 1e-3 * power_scale(motor, 0);
  const Stator& stator = motor.design().stator;
  switch (metric) {
    case Metric::output_power_at:
    case Metric::stator_power_at:
    case Metric::friction_power_at:
    case Metric::layer_loss_at: return power;
    case Metric::wear_intensity_at:
      return power / (2 * std::numbers::pi * stator.contact_radius * stator.contact_width);
    default: return 0;
  }
}

inline void check_parameter(const MotorDesign& design, const ParameterInfo& row,
                            const std::vector<MetricRequest>& requests,
                            const std::vector<MetricDerivative>& exact, Tally& tally,
                            Deviation& deviation) {
  const double x = get(design, row.parameter);
  const Functions all = [&](double at) { return values_at(design, row.parameter, at, requests); };
  const auto differences = central_differences(all, x, std::abs(x));
  for (std::size_t k = 0; k < requests.size(); ++k) {
    if (exact[k].value.status != MetricStatus::ok || exact[k].smoothness == Smoothness::undefined)
      continue;
    const double unit =
        std::max(std::abs(exact[k].value.value), least_size(Motor(design), requests[k].metric)) /
        std::abs(x);
    const double gradient = exact[k].gradient[index_of(row.parameter)];
    const bool sharp =
        differences[k].error <= 1e-8 * std::max(unit, std::abs(differences[k].value));
    if (!sharp) {
      ++tally.blunt;
      continue;
    }
    const std::string name(info(requests[k].metric).name);
    ++tally.sharp[name];
    bool good = agrees(gradient, differences[k], unit);
    if (good)
      deviation.add(gradient, differences[k].value,
                    std::max({unit, std::abs(differences[k].value), 1e-300}));
    // Values at a load carry the error of its speed, and the scheme's idea of its own may by chance be too small:
    // seldom so with other steps again.
    if (!good) {
      good = agrees(gradient, central_differences(all, x, 0.37 * std::abs(x))[k], unit);
      tally.again += good;
    }
    if (!good && exact[k].smoothness == Smoothness::one_sided) {
      good = agrees_on_a_side(design, row, requests[k], gradient, unit);
    }
    if (good) continue;
    ++tally.wrong;
    if (tally.examples.size() < 12) {
      tally.examples.push_back(
          name + " by " + std::string(row.name) + " (" + to_string(exact[k].smoothness) +
          "): " + std::to_string(gradient * x) + " instead of " +
          std::to_string(differences[k].value * x) + " per unit of relative change");
    }
  }
}

// Exact derivatives of all requests by all parameters that can be moved.
inline void check_gradients(const MotorDesign& design, const std::vector<MetricRequest>& requests,
                            Tally& tally, Deviation& deviation) {
  const auto exact = differentiate(Motor(design), requests);
  for (const ParameterInfo& row : parameter_table()) {
    if (movable(design, row)) check_parameter(design, row, requests, exact, tally, deviation);
  }
}

template <typename DesignOf>
Tally check_designs(std::uint64_t seed, int count, DesignOf design_of) {
  Tally tally;
  Deviation deviation("metric derivatives against Richardson differences, relative", 1e-7);
  Uniform random(seed);
  for (int i = 0; i < count; ++i) {
    const MotorDesign design = design_of(random, i);
    check_gradients(design, all_requests(Motor(design)), tally, deviation);
  }
  return tally;
}

}  // namespace twum::test
