// SPDX-License-Identifier: Apache-2.0
#include <twum/core/performance/metrics.hpp>

#include "performance/curve_search.hpp"

#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace twum {
namespace {

using namespace performance;
using M = Metric;

constexpr double kVanishing = 1e-8;  // length of a zone that counts as about to vanish [rad]
constexpr double kBeside = 1e-9;  // of the crest speed: a zone about to appear is there so far away
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A point metric from the numbers of a point; S is double or carries derivatives. The one place for
// these formulas (T7.1, T7.5, T7.6, T7.7, T7.9).
template <typename S>
S point_metric(Metric metric, const PointNumbers<S>& n, const S& speed, const MotorModel<S>& m) {
  const S velocity = m.omega * m.amplitude;
  const S stator_loss = m.stator_damping * velocity * velocity;
  switch (metric) {
    case M::torque_at: return n.torque;
    case M::output_power_at: return n.torque * speed;
    case M::stator_power_at: return n.stator_power;
    case M::friction_power_at: return n.friction_power;
    case M::layer_loss_at: return n.layer_loss;
    case M::efficiency_at: return n.torque * speed / (n.stator_power + stator_loss);
    case M::contact_efficiency_at: return n.torque * speed / n.stator_power;
    case M::wear_intensity_at: return n.friction_power / (2 * std::numbers::pi * m.r * m.b);
    default: return n.stick_fraction;
  }
}

bool needs_input_power(Metric metric) {
  return metric == M::efficiency_at || metric == M::contact_efficiency_at;
}

class Evaluator {
 public:
  explicit Evaluator(const Motor& motor) : motor_(motor), m_(motor.model()), search_(m_) {}

  MetricValue evaluate(const MetricRequest& request) {
    try {
      const double found = value(request);
      return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                  : MetricValue{kNaN, MetricStatus::inaccurate};
    } catch (const SearchFailure& failure) {
      return {kNaN, failure.status};
    }
  }

 protected:
  double value(const MetricRequest& request) {
    switch (request.metric) {
      case M::stall_torque: return search_.stall_torque();
      case M::max_torque: return search_.max_torque().value;
      case M::holding_torque: return motor_.holding_torque();  // (T7.8)
      case M::no_load_speed: return search_.no_load().speed;
      case M::plateau_speed: return search_.plateau_end();
      case M::peak_power: return search_.peak_power().value;
      case M::speed_at_peak_power: return search_.peak_power().speed;
      case M::torque_at_peak_power: return point_value(M::torque_at, working_peak());
      case M::contact_efficiency_at_peak_power:
        return point_value(M::contact_efficiency_at, working_peak());
      case M::max_efficiency: return known_efficiency().value;
      case M::speed_at_max_efficiency: return known_efficiency().speed;
      case M::contact_half_length: return m_.contact.half_length;
      case M::contact_ratio: return m_.contact.ratio;
      case M::max_pressure: return m_.contact.max_pressure;
      case M::speed_at: return search_.speed_at(request.at).speed;
      default: return point_value(request.metric, speed_of(request));
    }
  }

  Peak known_efficiency() {
    const Peak peak = search_.max_efficiency();
    require_input(M::efficiency_at, peak.speed);
    return peak;
  }

  double working_peak() {
    if (!(search_.stall_torque() > 0)) throw SearchFailure{MetricStatus::undefined};
    return search_.peak_power().speed;
  }

  double speed_of(const MetricRequest& request) {
    if (request.argument == Argument::torque) return search_.speed_at(request.at).speed;
    if (!wave_meets_rotor(m_, request.at)) {
      throw SearchFailure{MetricStatus::out_of_range};
    }
    return request.at;
  }

  const SolvedPoint& point(double speed) {
    for (const auto& [at, kept] : points_) {
      if (at == speed) return kept;
    }
    const SolvedPoint solved = solve_point(m_, speed);
    if (solved.status != PointStatus::ok) throw SearchFailure{metric_status(solved.status)};
    return points_.emplace_back(speed, solved).second;
  }

  // An efficiency needs an input power that is more than rounding.
  void require_input(Metric efficiency, double speed) {
    const PointNumbers<double>& n = point(speed).numbers;
    const double velocity = m_.omega * m_.amplitude;
    const double loss =
        efficiency == M::efficiency_at ? m_.stator_damping * velocity * velocity : 0;
    const double input = n.stator_power + loss;
    if (!(input > 0)) throw SearchFailure{MetricStatus::undefined};
    if (!is_known(input, excess(n, speed))) throw SearchFailure{MetricStatus::inaccurate};
  }

  double point_value(Metric metric, double speed) {
    if (needs_input_power(metric)) require_input(metric, speed);
    return point_metric(metric, point(speed).numbers, speed, m_);
  }

  const Motor& motor_;
  const MotorModel<double>& m_;
  CurveSearch search_;
  std::deque<std::pair<double, SolvedPoint>> points_;  // references stay valid
};

Smoothness worse(Smoothness a, Smoothness b) { return a < b ? b : a; }

// A number with its derivatives in the parameters, the speed no longer free.
struct Derived {
  ModelDual dual;
  Smoothness smoothness{Smoothness::smooth};

  Derived at_kink() const { return {dual, worse(smoothness, Smoothness::one_sided)}; }
};

// Zones come or go a hair away from the speed.
bool zones_change_beside(const MotorModel<double>& m, const SolvedPoint& p, double speed) {
  const double hair = kBeside * m.crest_velocity / m.r;
  for (const double beside : {speed - hair, speed + hair}) {
    if (!wave_meets_rotor(m, beside)) continue;
    const SolvedPoint near = solve_point(m, beside, &p.state.entry);
    if (near.status == PointStatus::ok && near.state.lap.itinerary != p.state.lap.itinerary)
      return true;
  }
  return false;
}

// One-sided where a zone is about to vanish or to appear, unless the torque is C1 there (theory section 8):
// elastic layers with mu_0 = mu. Special points are limits (locked at rest) or stand where nothing rubs.
Smoothness smoothness_of(const MotorModel<double>& m, const SolvedPoint& p, double speed) {
  if (is_trivial(m)) return Smoothness::undefined;
  if (p.special) return Smoothness::one_sided;
  const bool may_kink = m.static_ > m.kinetic || m.inertia > 0;
  const bool kinks =
      may_kink && (p.state.lap.shortest < kVanishing || zones_change_beside(m, p, speed));
  return kinks ? Smoothness::one_sided : Smoothness::smooth;
}

class Differentiator : private Evaluator {
 public:
  Differentiator(const Motor& motor, bool fixed_static_friction)
      : Evaluator(motor),
        fixed_(fixed_static_friction),
        model_(differentiated_model<ModelDual>(motor.design(), fixed_static_friction)) {}

  MetricDerivative differentiate(const MetricRequest& request) {
    MetricDerivative result;
    result.value = evaluate(request);
    if (result.value.status != MetricStatus::ok) {
      result.smoothness = Smoothness::undefined;
      result.gradient.fill(kNaN);
      return result;
    }
    const Derived derived = derived_or_undefined(request);
    result.smoothness = derived.smoothness;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
      result.gradient[i] = derived.dual.d[i];
      if (!std::isfinite(result.gradient[i])) result.smoothness = Smoothness::undefined;
    }
    if (result.smoothness == Smoothness::undefined) result.gradient.fill(kNaN);
    return result;
  }

 private:
  // A limit may need points nearby that have no answer.
  Derived derived_or_undefined(const MetricRequest& request) {
    try {
      return derive(request);
    } catch (const SearchFailure&) {
      return {ModelDual(kNaN), Smoothness::undefined};
    }
  }

  Derived derive(const MetricRequest& request) {
    switch (request.metric) {
      case M::holding_torque: return {model_.static_ * model_.preload * model_.r};
      case M::contact_half_length: return {model_.contact.half_length, of_contact_size()};
      case M::contact_ratio:
        return {model_.contact.ratio, m_.contact.full ? Smoothness::flat : of_contact_size()};
      case M::max_pressure: return {model_.contact.max_pressure, of_contact_size()};
      case M::stall_torque: return at(M::torque_at, fixed_speed(0));
      case M::max_torque: return at_peak(M::torque_at, search_.max_torque());
      case M::no_load_speed: return crossing(search_.no_load(), 0);
      case M::plateau_speed: return plateau();
      case M::peak_power: return at_peak(M::output_power_at, search_.peak_power());
      case M::speed_at_peak_power: return speed_at_peak_power();
      case M::torque_at_peak_power: return along_peak(M::torque_at, search_.peak_power());
      case M::contact_efficiency_at_peak_power:
        return along_peak(M::contact_efficiency_at, search_.peak_power());
      case M::max_efficiency: return at_peak(M::efficiency_at, search_.max_efficiency());
      case M::speed_at_max_efficiency:
        return speed_of_peak(M::efficiency_at, search_.max_efficiency());
      case M::speed_at: return crossing(search_.speed_at(request.at), request.at);
      default:
        if (request.argument == Argument::torque) {
          return at(request.metric, crossing(search_.speed_at(request.at), request.at));
        }
        return at(request.metric, fixed_speed(request.at));
    }
  }

  Derived fixed_speed(double speed) const { return {ModelDual(speed)}; }

  // Where partial turns into full contact the contact angle has no derivative.
  Smoothness of_contact() const {
    const double gap =
        m_.contact.full ? m_.contact.edge_cosine + 1 : m_.contact.half_angle - std::numbers::pi;
    return std::fabs(gap) < 1e-7 ? Smoothness::one_sided : Smoothness::smooth;
  }

  // By (T3.2) theta_L grows with the cube root of the first preload, and pressure with the square of that.
  Smoothness of_contact_size() const {
    return m_.contact.half_angle == 0 ? Smoothness::undefined : of_contact();
  }

  Smoothness of_point(double speed) {
    for (const auto& [at, kept] : smoothness_) {
      if (at == speed) return kept;
    }
    const Smoothness found = worse(smoothness_of(m_, point(speed), speed), of_contact());
    return smoothness_.emplace_back(speed, found).second;
  }

  const PointNumbers<ModelDual>& numbers(double speed) {
    for (const auto& [at, kept] : duals_) {
      if (at == speed) return kept;
    }
    return duals_.emplace_back(speed, differentiate_point(m_, model_, point(speed), speed)).second;
  }

  ModelDual free_speed_metric(Metric metric, double speed) {
    return point_metric(metric, numbers(speed), speed_variable<ModelDual>(speed), model_);
  }

  // A point metric at a speed that moves with the parameters.
  Derived at(Metric metric, const Derived& speed) {
    const double omega = value_of(speed.dual);
    ModelDual f = free_speed_metric(metric, omega);
    for (int j = 0; j < kSpeedDirection; ++j) f.d[j] += f.d[kSpeedDirection] * speed.dual.d[j];
    Smoothness smoothness = worse(speed.smoothness, of_point(omega));
    const SolvedPoint& p = point(omega);
    const bool plateau = metric == M::torque_at && !p.special && p.state.lap.one_slip;
    const bool no_stick = metric == M::stick_fraction_at && p.numbers.stick_fraction == 0;
    if (smoothness == Smoothness::smooth && (plateau || no_stick)) smoothness = Smoothness::flat;
    return {f, smoothness};
  }

  // The value of a peak: the speed drops out where the slope is zero.
  Derived at_peak(Metric metric, const Peak& peak) {
    switch (peak.kind) {
      case PeakKind::smooth:
      case PeakKind::rest: return at(metric, fixed_speed(peak.speed));
      case PeakKind::plateau_end: return at_plateau_end(metric, peak.speed);
      case PeakKind::beyond_plateau: return beyond_plateau(metric);
      case PeakKind::kink: break;
    }
    return {ModelDual(peak.value), Smoothness::undefined};
  }

  static Derived with_speed(const Derived& moving, double speed) {
    return {with_value(moving.dual, speed), moving.smoothness};
  }

  // A point metric where the power has its peak.
  Derived along_peak(Metric metric, const Peak& peak) {
    if (peak.kind == PeakKind::beyond_plateau) return beyond_plateau(metric);
    return at(metric, speed_at_peak_power());
  }

  // Three metrics need it.
  const Derived& speed_at_peak_power() {
    if (!speed_at_peak_power_)
      speed_at_peak_power_ = speed_of_peak(M::output_power_at, search_.peak_power());
    return *speed_at_peak_power_;
  }

  // On the plateau T = mu F_N r.
  Derived at_plateau_end(Metric metric, double speed) {
    const ModelDual torque = model_.kinetic * model_.preload * model_.r;
    if (metric == M::torque_at) return {torque, Smoothness::flat};
    const Derived end = plateau();
    if (metric == M::output_power_at) return Derived{torque * end.dual, end.smoothness}.at_kink();
    return at(metric, with_speed(end, speed)).at_kink();
  }

  // The limit where the torque has jumped off its plateau. There slip ends where v_rel just touches zero, at a
  // place that moves like the square root of the distance to the jump: two distances tell the limit.
  Derived beyond_plateau(Metric metric) {
    constexpr double kDistance = 1e-10;  // its root is far from rounding, itself from what counts
    const Derived end = plateau();
    const double near = value_of(end.dual) * (1 + kDistance),
                 far = value_of(end.dual) * (1 + 4 * kDistance);
    const contact::Lap<double>&a = point(near).state.lap, &b = point(far).state.lap;
    if (a.one_slip || a.itinerary != b.itinerary)
      return {ModelDual(point_value(metric, near)), Smoothness::undefined};
    const Derived f = at(metric, {end.dual * (1 + kDistance), end.smoothness}),
                  g = at(metric, {end.dual * (1 + 4 * kDistance), end.smoothness});
    return Derived{2.0 * f.dual - g.dual, worse(f.smoothness, g.smoothness)}.at_kink();
  }

  Derived plateau() {
    const double end = search_.plateau_end();
    if (!(end > 0)) return {ModelDual(end), Smoothness::flat};
    // With mu_0 > mu the laps may leave the plateau for another state before they must.
    const Margin margin = plateau_margin(m_, end);
    if (std::fabs(margin.value / margin.slope) > 1e-9 * m_.crest_velocity / m_.r)
      return {ModelDual(end), Smoothness::undefined};
    return {plateau_end_derivative(m_, model_, end), of_contact()};
  }

  // dOmega = -dT / T_Omega at fixed load.
  Derived crossing(const Crossing& crossing, double torque) {
    const double end = search_.plateau_end();
    const bool on_plateau =
        end > 0 && crossing.speed == end && torque <= search_.stall_torque() * (1 + 1e-12);
    if (on_plateau) return plateau().at_kink();
    const ModelDual speed(crossing.speed);
    if (crossing.slopeless) return {speed, Smoothness::undefined};
    const bool at_rest = crossing.speed == 0;
    if (at_rest && torque == 0) return {speed, Smoothness::one_sided};
    const ModelDual t = numbers(crossing.speed).torque - torque;
    if (at_rest && !(t.d[kSpeedDirection] < 0)) return {speed, Smoothness::undefined};
    ModelDual moving = speed;
    for (int j = 0; j < kSpeedDirection; ++j) moving.d[j] = -t.d[j] / t.d[kSpeedDirection];
    const Derived found{moving, of_point(crossing.speed)};
    return at_rest ? found.at_kink() : found;  // a load beyond the largest torque is not carried
  }

  // Where the slope f_Omega is zero: dOmega = -df_Omega / f_OmegaOmega.
  Derived speed_of_peak(Metric metric, const Peak& peak) {
    if (peak.kind == PeakKind::rest) return {ModelDual(0.0), Smoothness::flat};
    if (peak.kind == PeakKind::kink) return {ModelDual(peak.speed), Smoothness::undefined};
    if (peak.kind == PeakKind::plateau_end || peak.kind == PeakKind::beyond_plateau)
      return with_speed(plateau(), peak.speed).at_kink();
    if (!model2_) model2_ = differentiated_model<ModelDual2>(motor_.design(), fixed_);
    const PointNumbers<ModelDual2> n =
        differentiate_point(m_, *model2_, point(peak.speed), peak.speed);
    const ModelDual2 f = point_metric(metric, n, speed_variable<ModelDual2>(peak.speed), *model2_);
    ModelDual speed(peak.speed);
    for (int j = 0; j < kSpeedDirection; ++j) speed.d[j] = -f.d[j].d[0] / f.d[kSpeedDirection].d[0];
    return {speed, of_point(peak.speed)};
  }

  bool fixed_;
  MotorModel<ModelDual> model_;
  std::optional<MotorModel<ModelDual2>> model2_;
  std::optional<Derived> speed_at_peak_power_;
  std::deque<std::pair<double, PointNumbers<ModelDual>>> duals_;
  std::vector<std::pair<double, Smoothness>> smoothness_;
};

}  // namespace

SpeedDerivative differentiate_in_speed(const Motor& motor, double speed) {
  SpeedDerivative d;
  d.point = motor.operating_point(speed);
  if (d.point.status != PointStatus::ok) {
    d.torque = d.output_power = d.stator_power = d.friction_power = d.layer_loss =
        d.stick_fraction = kNaN;
    d.smoothness = Smoothness::undefined;
    return d;
  }
  const MotorModel<double>& m = motor.model();
  const SolvedPoint solved = solve_point(m, speed);
  const PointNumbers<contact::SpeedDual> n = point_in_speed(m, solved, speed);
  d.torque = n.torque.d[0];
  d.output_power = d.point.torque + speed * d.torque;
  d.stator_power = n.stator_power.d[0];
  d.friction_power = n.friction_power.d[0];
  d.layer_loss = n.layer_loss.d[0];
  d.stick_fraction = n.stick_fraction.d[0];
  d.smoothness = smoothness_of(m, solved, speed);
  return d;
}

std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests) {
  Evaluator evaluator(motor);
  std::vector<MetricValue> values;
  values.reserve(requests.size());
  for (const MetricRequest& request : requests) values.push_back(evaluator.evaluate(request));
  return values;
}

MetricValue evaluate(const Motor& motor, const MetricRequest& request) {
  return Evaluator(motor).evaluate(request);
}

std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction) {
  Differentiator differentiator(motor, fixed_static_friction);
  std::vector<MetricDerivative> derivatives;
  derivatives.reserve(requests.size());
  for (const MetricRequest& request : requests)
    derivatives.push_back(differentiator.differentiate(request));
  return derivatives;
}

}  // namespace twum
