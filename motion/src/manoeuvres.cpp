// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/manoeuvres.hpp>

#include "motion_run.hpp"
#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/core/motor.hpp>
#include <twum/motion/linear_plant.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace twum::motion {
namespace {

using M = Metric;
using P = Parameter;

// Why a metric has no value.
struct NoValue {
  MetricStatus status;
};

// A number with its derivatives in the columns of ModelSlopes; without them only the number.
struct Moving {
  double value{0};
  std::vector<double> slopes{};
};

constexpr double kReached = 0.9;  // of the steady speed: the end of a start
constexpr double kSettled =
    1e-3;  // of speed and wave: no later overshoot is larger than the one that was
constexpr double kPatience =
    100;  // times the time scales of wave and rotor: until then a start or a stop has ended
constexpr double kStill = 1e-6;  // relative change in that time of what has settled somewhere else
constexpr double kSlopeTolerance =
    1e-6;  // of states and derivatives: good to 1e-4 of these; values have one of their own
constexpr int kSwitchBits = 24;          // of the time at which a move's drive ends: 6e-8
constexpr double kVoltageWithin = 1e-5;  // relative, of the dynamic start voltage

// A state on the way, at a time within a step.
struct Place {
  double time;
  std::vector<double> y, rates, slopes;
};

Place place_at(const Integrator& integrator, double time) {
  return {time, integrator.at(time), integrator.at(time, 1), integrator.slopes_at(time)};
}

// Where a function of time that is negative at `from` and not at `to` has its zero.
double zero_between(double from, double to, const std::function<double(double)>& f) {
  for (int i = 0; i < 60 && to - from > 1e-15 * to; ++i) {
    const double middle = 0.5 * (from + to);
    (f(middle) < 0 ? from : to) = middle;
  }
  return to;
}

// The steady state under a load.
struct Steady {
  States y;
  std::vector<double> slopes;
  Complex zeta() const { return {y[kReal], y[kImaginary]}; }
};

// What a start tells.
struct Start {
  Steady steady;
  std::optional<Place> reached;  // 90 % of the steady speed
  std::optional<Place> fastest;  // the highest peak of the speed
};

// Watches a start step by step.
class StartWatch {
 public:
  /// @param own_time  of wave and rotor [s]
  StartWatch(Start& start, double own_time, bool settled)
      : start_(&start), own_time_(own_time), settled_(settled) {}

  bool operator()(const Integrator& integrator, double begin) {
    const double end = integrator.time(), target = kReached * start_->steady.y[kSpeed];
    const auto speed = [&](double time) { return integrator.at(time)[kSpeed]; };
    const auto slowing = [&](double time) { return -integrator.at(time, 1)[kSpeed]; };
    if (!start_->reached && integrator.y()[kSpeed] >= target)
      start_->reached = place_at(
          integrator, zero_between(begin, end, [&](double time) { return speed(time) - target; }));
    if (slowing(begin) < 0 && slowing(end) >= 0) {
      Place peak = place_at(integrator, zero_between(begin, end, slowing));
      if (!start_->fastest || peak.y[kSpeed] > start_->fastest->y[kSpeed])
        start_->fastest = std::move(peak);
    }
    if (!start_->reached) return stands_still(integrator);
    return !settled_ || is_settled(integrator.y());
  }

 private:
  // On the dead wave, on which the motor stays.
  bool stands_still(const Integrator& integrator) const {
    const std::vector<double> rates = integrator.at(integrator.time(), 1);
    const std::span<const double> y = integrator.y();
    const double wave = std::hypot(y[kReal], y[kImaginary]);
    return integrator.time() > own_time_ &&
           std::hypot(rates[kReal], rates[kImaginary]) * own_time_ <= kStill * wave &&
           std::fabs(rates[kSpeed]) * own_time_ <= kStill * start_->steady.y[kSpeed];
  }

  bool is_settled(std::span<const double> y) const {
    const Steady& s = start_->steady;
    const Complex zeta{y[kReal], y[kImaginary]};
    return std::fabs(y[kSpeed] - s.y[kSpeed]) <= kSettled * s.y[kSpeed] &&
           std::abs(zeta - s.zeta()) <= kSettled * std::abs(s.zeta());
  }

  Start* start_;
  double own_time_;
  bool settled_;
};

// Runs the manoeuvres of one design.
class Manoeuvres {
 public:
  /// @param slopes  null for values alone
  Manoeuvres(const MotorDesign& design, const ModelSlopes* slopes)
      : design_(design), model_(design), slopes_(slopes) {}

  Steady steady(double torque) const {
    const ShaftLoad load = design_.load.value_or(ShaftLoad{});
    const MetricValue speed = twum::evaluate(
        Motor(design_), {M::speed_at, Argument::torque, std::max(torque + load.friction, 0.0)});
    if (speed.status != MetricStatus::ok) throw NoValue{speed.status};
    Equations equations(model_, slopes_);
    const Stretch stretch = under_drive(torque);
    equations.set_stretch(stretch);
    Steady s{steady_state(design_, equations), {}};
    if (slopes_) s.slopes = steady_slopes(equations, s.y, slopes_->columns().size());
    return s;
  }

  /// @param settled  whether it goes on until the speed has settled, which the overshoot needs
  Start start(double torque, bool settled = true) const {
    Start start{steady(torque), {}, {}};
    MotionTask task = under_drive_for(patience());
    task.load_torque = torque;
    RunWatch watch;
    watch.reached = StartWatch(start, patience() / kPatience, settled);
    watch.slopes = slopes_;
    MotionRun run(design_, task, watch);
    require_ok(followed(run, task, stretches_of(task, model_.driven)));
    return start;
  }

  Moving start_time(const Start& start) const {
    const Place& at = reached(start);
    return moving(at.time, [&](std::size_t k) {
      // dt*/dq of Omega = 0.9 Omega_s
      return -(at.slopes[k + kSpeed] - kReached * start.steady.slopes[k + kSpeed]) /
             at.rates[kSpeed];
    });
  }

  // At the peak Omega' = 0, and its time drops out.
  Moving start_overshoot(const Start& start) const {
    reached(start);
    const double steady = start.steady.y[kSpeed];
    if (!start.fastest || start.fastest->y[kSpeed] <= steady)
      return moving(0, [](std::size_t) { return 0.0; });
    const double ratio = start.fastest->y[kSpeed] / steady;
    return moving(ratio - 1, [&](std::size_t k) {
      return (start.fastest->slopes[k + kSpeed] - ratio * start.steady.slopes[k + kSpeed]) / steady;
    });
  }

  RunEnd stop(double torque) const {
    steady(torque);  // which tells why there is none
    MotionTask task = under_drive_for(patience());
    task.load_torque = torque;
    task.initial.steady = true;
    task.switched_off = {{0, task.duration}};
    RunWatch watch;
    watch.until_held = true, watch.slopes = slopes_;
    return held_end(task, std::move(watch));
  }

  Moving stop_time(const RunEnd& end) const {
    return moving(end.time, [&](std::size_t k) { return end.time_slopes[k / kStateCount]; });
  }
  // The rotor stands there, so that the time drops out.
  Moving angle(const RunEnd& end) const {
    return moving(end.y[kAngle], [&](std::size_t k) { return end.slopes[k + kAngle]; });
  }

  // On from rest for a time, then off until the rotor is held. Its time moves as `switch_slopes`.
  RunEnd burst(double on, std::vector<double> switch_slopes) const {
    MotionTask task = under_drive_for(on + patience());
    task.switched_off = {{on, task.duration}};
    RunWatch watch;
    watch.until_held = true, watch.slopes = slopes_;
    watch.switch_slopes = std::move(switch_slopes);
    return held_end(task, std::move(watch));
  }

  // The time t = N / f moves with the frequency.
  Moving burst_angle(double periods) const {
    const double frequency = drive_frequency(design_), on = periods / frequency;
    std::vector<double> moves;
    if (slopes_)
      for (const ModelSlope& q : slopes_->columns())
        moves.push_back(-on / frequency * q.omega / (2 * std::numbers::pi) * q.scale);
    return angle(burst(on, std::move(moves)));
  }

  // Off at the time t after which the rotor comes to rest at the angle: dt/dq = -theta_q / theta_t, dE = E_q + E_t dt.
  Moving move_energy(double angle) const {
    const Manoeuvres plain(design_, nullptr);
    const auto excess = [&](double on) { return plain.burst(on, {}).y[kAngle] - angle; };
    const double latest = time_to(angle);
    const double on = closed_in("end of the drive of a move", excess,
                                {0, latest, -angle, excess(latest)}, kSwitchBits)
                          .nearest();
    const RunEnd end = burst(on, {});
    if (!slopes_) return {end.y[kEnergy], {}};
    const double later = 1e-4 * on;  // a switch that moves, by differences
    const RunEnd a = plain.burst(on - later, {}), b = plain.burst(on + later, {});
    const double per_angle = (b.y[kEnergy] - a.y[kEnergy]) / (b.y[kAngle] - a.y[kAngle]);
    return moving(end.y[kEnergy], [&](std::size_t k) {
      return end.slopes[k + kEnergy] - per_angle * end.slopes[k + kAngle];
    });
  }

  bool starts() const {
    try {
      return start(0, false).reached.has_value();
    } catch (const NoValue&) {
      return false;
    }
  }

 private:
  // Twice the wave's own time 2 m / d, the rotor's under the holding torque, and that of coasting (docs/theory/motion.md).
  double patience() const {
    const double inertia = model_.inertia, torque = model_.holding_torque;
    const double omega = 2 * std::numbers::pi * drive_frequency(design_);
    const bool driven = model_.driven && model_.damping > 0;
    const double wave = driven ? 2 * model_.mass / model_.damping : 1e-3;
    const double largest =
        driven ? model_.drive_force(*design_.stator.voltage) / (model_.damping * omega)
               : design_.stator.amplitude;
    const double crest = model_.crest_per_amplitude * omega * largest;
    const double coasting =
        driven ? inertia * model_.crest_per_amplitude * model_.crest_per_amplitude / model_.damping
               : 0;
    return kPatience * (wave + (torque > 0 ? inertia * crest / torque : 0) + coasting);
  }

  MotionTask under_drive_for(double duration) const {
    MotionTask task = steady_drive(design_, duration);
    if (slopes_) task.tolerance = kSlopeTolerance;
    return task;
  }

  // Of a steady state.
  Stretch under_drive(double torque) const {
    MotionTask task = steady_drive(design_, 1);
    task.load_torque = torque;
    return before_the_first(task);
  }

  static void require_ok(const Motion& motion) {
    if (motion.status != "ok") throw NoValue{MetricStatus::not_converged};
  }

  static const Place& reached(const Start& start) {
    if (!start.reached) throw NoValue{MetricStatus::does_not_start};
    return *start.reached;
  }

  RunEnd held_end(const MotionTask& task, RunWatch watch) const {
    MotionRun run(design_, task, std::move(watch));
    require_ok(followed(run, task, stretches_of(task, model_.driven)));
    RunEnd end = run.end();
    if (!end.held) throw NoValue{MetricStatus::does_not_stop};
    return end;
  }

  // Until the rotor, driven from rest, has turned by an angle.
  double time_to(double angle) const {
    const Steady running = steady(0);
    MotionTask task = under_drive_for(patience() + 2 * angle / running.y[kSpeed]);
    std::optional<double> found;
    RunWatch watch;
    watch.reached = [&](const Integrator& integrator, double begin) {
      if (integrator.y()[kAngle] < angle) return false;
      found = zero_between(begin, integrator.time(),
                           [&](double time) { return integrator.at(time)[kAngle] - angle; });
      return true;
    };
    MotionRun run(design_, task, watch);
    require_ok(followed(run, task, stretches_of(task, model_.driven)));
    if (!found) throw NoValue{MetricStatus::does_not_start};
    return *found;
  }

  template <typename Slope>
  Moving moving(double value, Slope slope) const {
    Moving m{value, {}};
    if (!slopes_) return m;
    for (std::size_t k = 0; k < slopes_->columns().size(); ++k)
      m.slopes.push_back(slope(k * kStateCount) / slopes_->columns()[k].scale);
    return m;
  }

  const MotorDesign& design_;
  MotionModel model_;
  const ModelSlopes* slopes_;
};

// Of rates and gains near the steady state.
double plant_number(const MotorDesign& design, const MetricRequest& request) {
  const MetricValue speed = twum::evaluate(
      Motor(design), {M::speed_at, Argument::torque,
                      std::max(request.at + design.load.value_or(ShaftLoad{}).friction, 0.0)});
  if (speed.status != MetricStatus::ok) throw NoValue{speed.status};
  if (request.metric == M::bounce_rate_at) return bounce_rate(design, request.at);
  const LinearPlant plant = linearize(design, request.at);
  constexpr std::size_t kSpeedGain = 2, kVoltageInput = 0, kFrequencyInput = 1;
  switch (request.metric) {
    case M::settling_rate_at: return -plant.poles.front().real();
    case M::speed_per_frequency_at: return plant.gains[kSpeedGain][kFrequencyInput];
    default: return plant.gains[kSpeedGain][kVoltageInput];
  }
}

bool is_of_plant(Metric metric) {
  return metric == M::settling_rate_at || metric == M::bounce_rate_at ||
         metric == M::speed_per_frequency_at || metric == M::speed_per_voltage_at;
}

// Between the static threshold, above which every step starts the motor, and the voltage below which it does not run.
double dynamic_start_voltage(const MotorDesign& design) {
  const Motor motor(design);
  const auto known = [](const MetricValue& found) {
    if (found.status != MetricStatus::ok) throw NoValue{found.status};
    return found.value;
  };
  const auto starts = [&](double voltage) {
    const MotorDesign stronger = with(design, P::voltage, voltage);
    return Manoeuvres(stronger, nullptr).starts();
  };
  double high = known(twum::evaluate(motor, {M::start_voltage}));
  if (high == 0) return 0;
  high *= 1 + 1e-3;
  if (!starts(high)) throw NoValue{MetricStatus::does_not_start};
  double low = known(twum::evaluate(motor, {M::hold_voltage}));
  while (high - low > kVoltageWithin * high) {
    const double middle = 0.5 * (low + high);
    (starts(middle) ? high : low) = middle;
  }
  return high;
}

class Answers final : public MotionMetrics {
 public:
  explicit Answers(const MotorDesign& design) : design_(design) {}

  MetricValue evaluate(const MetricRequest& request) override {
    return answered([&] { return number(request); });
  }

  MetricDerivative differentiate(const MetricRequest& request, bool fixed) override {
    MetricDerivative found{evaluate(request), {}, Smoothness::undefined};
    found.gradient.fill(kNoValue);
    if (found.value.status != MetricStatus::ok || request.metric == M::dynamic_start_voltage)
      return found;
    MetricDerivative moved = found;
    const MetricValue status = answered([&] {
      moved.gradient =
          is_of_plant(request.metric) ? by_differences(request) : by_integration(request, fixed);
      return found.value.value;
    });
    const bool known =
        status.status == MetricStatus::ok &&
        (is_of_plant(request.metric) ||
         std::ranges::all_of(moved.gradient, [](double d) { return std::isfinite(d); }));
    if (!known) return found;
    moved.smoothness = Smoothness::smooth;
    return moved;
  }

 private:
  // Of what several metrics ask at one torque.
  template <typename Find>
  const auto& once(auto& kept, double torque, Find find) {
    const auto place = kept.find(torque);
    return place != kept.end() ? place->second : kept.emplace(torque, find()).first->second;
  }

  template <typename Ask>
  MetricValue answered(Ask ask) const {
    try {
      const double found = ask();
      return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                  : MetricValue{kNoValue, MetricStatus::inaccurate};
    } catch (const NoValue& none) {
      return {kNoValue, none.status};
    } catch (const EvaluationError&) {
      return {kNoValue, MetricStatus::unresolved};
    } catch (const InputError&) {  // no rotor, no voltage, radial motion
      return {kNoValue, MetricStatus::undefined};
    }
  }

  double number(const MetricRequest& request) {
    const bool backward = request.argument == Argument::angle && !(request.at > 0);
    const bool too_short = request.argument == Argument::periods && !(request.at >= 1);
    if (backward || too_short) throw NoValue{MetricStatus::undefined};
    if (is_of_plant(request.metric)) return plant_number(design_, request);
    if (request.metric == M::dynamic_start_voltage) return dynamic_start_voltage(design_);
    const Manoeuvres run(design_, nullptr);
    return moved(run, request, starts_, stops_).value;
  }

  Moving moved(const Manoeuvres& run, const MetricRequest& request, std::map<double, Start>& starts,
               std::map<double, RunEnd>& stops) {
    const double at = request.at;
    const auto start = [&]() -> const Start& {
      return once(starts, at, [&] { return run.start(at); });
    };
    const auto stop = [&]() -> const RunEnd& {
      return once(stops, at, [&] { return run.stop(at); });
    };
    switch (request.metric) {
      case M::start_time_at: return run.start_time(start());
      case M::start_overshoot_at: return run.start_overshoot(start());
      case M::stop_time_at: return run.stop_time(stop());
      case M::stop_angle_at: return run.angle(stop());
      case M::move_energy: return run.move_energy(at);
      default: return run.burst_angle(at);
    }
  }

  std::array<double, kParameterCount> by_integration(const MetricRequest& request, bool fixed) {
    if (!slopes_ || fixed != fixed_) {
      slopes_.emplace(design_, fixed);
      fixed_ = fixed;
      moving_starts_.clear(), moving_stops_.clear();
    }
    const Manoeuvres run(design_, &*slopes_);
    const Moving found = moved(run, request, moving_starts_, moving_stops_);
    std::array<double, kParameterCount> gradient{};
    for (std::size_t k = 0; k < found.slopes.size(); ++k)
      gradient[index_of(slopes_->columns()[k].parameter)] = found.slopes[k];
    return gradient;
  }

  // Inertia and damping of a layer that has none: the number has no slope there, a layer of very little inertia rings.
  static bool is_of_layer(P parameter) {
    return parameter >= P::thickness && parameter <= P::inertia;
  }

  // Slope at zero, by a step that moves the number a little.
  template <typename F>
  static double from_zero(double here, F f) {
    double slope = 0;
    for (double step = 1e-10; step < 1; step *= 10) {
      const double change = f(step) - here;
      slope = change / step;
      if (std::fabs(change) > 1e-6 * std::fabs(here)) break;
    }
    return slope;
  }

  // Central, to a relative 1e-9 or so; of a parameter that is zero one-sided, with a step that moves the number a little.
  std::array<double, kParameterCount> by_differences(const MetricRequest& request) {
    std::array<double, kParameterCount> gradient{};
    const double here = plant_number(design_, request);
    const auto at = [&](P parameter, double value) {
      return plant_number(with(design_, parameter, value), request);
    };
    for (const ParameterInfo& row : parameter_table()) {
      if (row.integer || !in_use(design_, row.parameter)) continue;
      const double q = get(design_, row.parameter);
      double& slope = gradient[index_of(row.parameter)];
      if (q != 0) {
        const double step = 1e-5 * std::fabs(q);
        const double above = at(row.parameter, q + step);
        const bool ends_here = row.parameter == P::static_friction &&
                               q - step < design_.friction.kinetic;  // none from below
        slope =
            ends_here ? (above - here) / step : (above - at(row.parameter, q - step)) / (2 * step);
        continue;
      }
      slope = is_of_layer(row.parameter)
                  ? kNoValue
                  : from_zero(here, [&](double step) { return at(row.parameter, step); });
    }
    return gradient;
  }

  const MotorDesign& design_;
  std::optional<ModelSlopes> slopes_;
  bool fixed_{false};
  std::map<double, Start> starts_, moving_starts_;
  std::map<double, RunEnd> stops_, moving_stops_;
};

}  // namespace

std::unique_ptr<MotionMetrics> motion_metrics(const MotorDesign& design) {
  return std::make_unique<Answers>(design);
}

}  // namespace twum::motion
