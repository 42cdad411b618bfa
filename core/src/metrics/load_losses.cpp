// SPDX-License-Identifier: Apache-2.0
#include "metrics/load_losses.hpp"

#include "metrics/differentiator.hpp"
#include "metrics/followed_wave.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

bool is_known(const Gradient& gradient) {
  return std::all_of(gradient.begin(), gradient.end(), [](double d) { return std::isfinite(d); });
}

bool has_slopes(const MetricDerivative& found) {
  return found.value.status == MetricStatus::ok && is_known(found.gradient);
}

}  // namespace

DriftRule::DriftRule(const MotorDesign& design, bool fixed_static_friction)
    : drifting_(drifting_parameters(design)),
      reference_(reference_temperature(design)),
      fixed_(fixed_static_friction),
      follows_ambient_(design.thermal && !design.thermal->reference) {}

// q_k(T) = q_k (1 + a_k (T - T_ref)): by q_k its factor, by a_k the way of the temperature, by T_ref the other sign.
Gradient DriftRule::at_fixed_temperatures(const Gradient& of_warm,
                                          const NodeTemperatures& x) const {
  Gradient g = of_warm;
  const Vector3 by_nodes = by_temperatures(of_warm);
  const double by_reference = -(by_nodes[0] + by_nodes[1] + by_nodes[2]);
  g[index_of(follows_ambient_ ? P::ambient_temperature : P::reference_temperature)] += by_reference;
  for (const Drifting& one : drifting_) {
    const std::size_t place = index_of(one.parameter);
    const double way = x[static_cast<std::size_t>(one.node)] - reference_;
    const bool counted = one.parameter == P::static_friction && !fixed_;  // in kinetic_friction
    if (!counted) g[index_of(one.coefficient)] += of_warm[place] * one.value * way;
    g[place] = of_warm[place] * (1 + one.slope * way);
  }
  return g;
}

Vector3 DriftRule::by_temperatures(const Gradient& of_warm) const {
  Vector3 by{};
  for (const Drifting& one : drifting_) {
    if (one.parameter == P::static_friction && !fixed_) continue;  // moves with kinetic_friction
    by[static_cast<std::size_t>(one.node)] +=
        of_warm[index_of(one.parameter)] * one.value * one.slope;
  }
  return by;
}

LoadLosses::LoadLosses(const MotorDesign& design, const LoadPoint& load,
                       std::shared_ptr<WarmMotors> motors)
    : design_(design),
      load_(load),
      motors_(motors ? std::move(motors) : std::make_shared<WarmMotors>(Motor(design))),
      rule_(design, false),
      drifts_(drifts(design)),
      follows_(drifts_ && follows_wave(design, load)) {}

std::vector<MetricRequest> LoadLosses::requests() const {
  std::vector<MetricRequest> list{at_load(Metric::friction_power_at, load_),
                                  at_load(Metric::layer_loss_at, load_),
                                  at_load(Metric::stator_loss_at, load_)};
  if (has_modal_data(design_)) list.push_back(at_load(Metric::dielectric_loss_at, load_));
  return list;
}

WarmLosses LoadLosses::values(const Motor& warm) const {
  WarmLosses losses;
  const auto found = evaluate(warm, requests());
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k].status != MetricStatus::ok) losses.status = found[k].status;
    losses.p[k] = found[k].value;
  }
  return losses;
}

// Of derivatives that are all known.
WarmLosses LoadLosses::with_slopes(std::span<const MetricDerivative> found) const {
  WarmLosses losses;
  for (std::size_t k = 0; k < found.size(); ++k) {
    losses.p[k] = found[k].value.value;
    losses.slope[k] = rule_.by_temperatures(found[k].gradient);
  }
  return losses;
}

WarmLosses LoadLosses::at(const NodeTemperatures& x) const {
  const auto warm = motors_->at(x);
  if (!warm) return {MetricStatus::temperature_out_of_range, {}, {}, {}};
  if (!drifts_) return values(*warm);
  std::vector<MetricRequest> asked = requests();
  const std::size_t sources = asked.size();
  const bool at_torque = load_.argument == Argument::torque;
  if (follows_) asked.push_back(at_load(Metric::amplitude_at, load_));
  if (follows_ && at_torque) asked.push_back(at_load(Metric::speed_at, load_));
  const auto found = differentiate(*warm, asked);
  for (const MetricDerivative& one : found)
    if (one.value.status != MetricStatus::ok) return {one.value.status, {}, {}, {}};
  const std::span of_losses(found.data(), sources);
  WarmLosses losses = with_slopes(of_losses);
  if (!std::ranges::all_of(of_losses, has_slopes)) losses.slope = differences(x);
  const double speed = at_torque ? found.back().value.value : load_.at;
  if (follows_ && speed > 0) losses.wave = {found[sources].value.value, speed};
  return losses;
}

std::optional<LoadLosses::Followed> LoadLosses::followed(const NodeTemperatures& x,
                                                         const LoadWave& known, bool fixed) const {
  const auto warm = at_temperatures(design_, x);
  if (!warm) return {};
  auto curve = FollowedCurve::from(*warm, load_, known);
  if (!curve) return {};
  Followed found{{}, {curve->motor().mean.amplitude, curve->speed()}};
  const Motor motor(*warm);
  Differentiator numbers(motor, std::move(curve), fixed);
  const bool at_torque = load_.argument == Argument::torque;
  const auto torque = at_torque ? std::optional(load_.at) : std::nullopt;
  for (const MetricRequest& one : requests())
    found.losses.push_back(numbers.differentiate_at(one.metric, found.wave.speed, torque));
  return std::ranges::all_of(found.losses, has_slopes) ? std::optional(found) : std::nullopt;
}

std::optional<WarmLosses> LoadLosses::near(const NodeTemperatures& x, const LoadWave& known) const {
  const auto found = followed(x, known, false);
  if (!found) return {};
  WarmLosses losses = with_slopes(found->losses);
  losses.wave = found->wave;
  return losses;
}

HeatProblem heat_problem(const MotorDesign& design, const HeatNetwork& network,
                         const LoadPoint& load, std::shared_ptr<WarmMotors> motors) {
  const LoadLosses losses(design, load, std::move(motors));
  return {
      network, design.thermal->ambient,
      [losses](const NodeTemperatures& x) { return losses.at(x); },
      [losses](const NodeTemperatures& x, const LoadWave& known) { return losses.near(x, known); }};
}

// Where a point has no derivative: central ones over 0.02 K.
std::array<Vector3, kSources> LoadLosses::differences(const NodeTemperatures& x) const {
  constexpr double kStep = 0.01;
  std::array<Vector3, kSources> slope{};
  for (std::size_t j = 0; j < 3; ++j) {
    NodeTemperatures low = x, high = x;
    low[j] -= kStep, high[j] += kStep;
    const auto below = at_temperatures(design_, low), above = at_temperatures(design_, high);
    if (!below || !above) continue;
    const WarmLosses a = values(Motor(*below)), b = values(Motor(*above));
    for (std::size_t k = 0; k < kSources; ++k) slope[k][j] = (b.p[k] - a.p[k]) / (2 * kStep);
  }
  return slope;
}

std::optional<std::array<Gradient, kSources>> LoadLosses::gradients(
    const NodeTemperatures& x, bool fixed_static_friction,
    const std::optional<LoadWave>& known) const {
  std::vector<MetricDerivative> found;
  if (const auto near = known ? followed(x, *known, fixed_static_friction) : std::nullopt) {
    found = near->losses;
  } else {
    const auto warm = motors_->at(x);
    if (!warm) return {};
    found = differentiate(*warm, requests(), fixed_static_friction);
  }
  std::array<Gradient, kSources> gradients{};
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (!is_known(found[k].gradient)) return {};
    gradients[k] = found[k].gradient;
  }
  return gradients;
}

HeatNetwork network_of(const MotorDesign& design) {
  if (!design.thermal || !design.thermal->one_node) return heat_network(design);
  MotorDesign reference = design;
  reference.thermal->drift = {};
  const double T = reference_temperature(design);
  const WarmLosses losses =
      LoadLosses(reference, {Argument::torque, design.thermal->one_node->torque}).at({T, T, T});
  if (losses.status != MetricStatus::ok) throw SearchFailure{losses.status};
  return heat_network(design, {losses.p[0], losses.p[1], losses.p[2], losses.p[3]});
}

}  // namespace twum::inline v0_1::core
