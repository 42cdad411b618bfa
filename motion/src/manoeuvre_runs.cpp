// SPDX-License-Identifier: Apache-2.0
#include "manoeuvre_runs.hpp"

#include "engine.hpp"
#include "steady.hpp"
#include "without_value.hpp"
#include "zero_in_step.hpp"

#include <twum/base/scalar_search.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kReached = 0.9;  // of the steady speed: the end of a start
// Of speed and wave. A later overshoot is smaller than that.
constexpr double kSettled = 1e-3;
// Times the motion's own time: until then a start or a stop has ended.
constexpr double kPatience = 100;
// Relative change in that time of what has settled somewhere else.
constexpr double kStill = 1e-6;
// Of states and derivatives, which are then good to 1e-4. Values are computed with the tolerance of all motions.
constexpr double kSlopeTolerance = 1e-6;
constexpr int kSwitchBits = 24;  // of the time at which a move's drive ends: 6e-8

Place place_at(const Integrator& integrator, double time) {
  return {time, integrator.at(time), integrator.at(time, 1), integrator.slopes_at(time)};
}

// Watches a start step by step.
class StartWatch {
 public:
  /// @param own_time  of the motion [s]
  StartWatch(Start& start, double own_time, bool settles)
      : start_(&start), own_time_(own_time), settles_(settles) {}

  bool operator()(const Integrator& integrator, double begin) {
    const double target = kReached * start_->steady.y[kSpeed];
    if (!start_->reached && integrator.y()[kSpeed] >= target)
      start_->reached =
          place_at(integrator, falls_through_zero(begin, integrator.time(), [&](double time) {
                     return target - integrator.at(time)[kSpeed];
                   }));
    if (const auto time = time_of_peak(integrator, begin)) {
      Place peak = place_at(integrator, *time);
      if (!start_->fastest || peak.y[kSpeed] > start_->fastest->y[kSpeed])
        start_->fastest = std::move(peak);
    }
    if (!start_->reached) return stands_still(integrator);
    return !settles_ || is_settled(integrator.y());
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
  bool settles_;
};

const Place& reached(const Start& start) {
  if (!start.reached) throw WithoutValue{MetricStatus::does_not_start};
  return *start.reached;
}

}  // namespace

Steady ManoeuvreRuns::steady(double torque) const {
  require_running(design_, torque);
  Equations equations(model_, slopes_);
  equations.set_stretch(before_the_first(task_of(1, torque)));
  Steady found{steady_state(design_, equations), {}};
  if (slopes_) found.slopes = steady_slopes(equations, found.y, slopes_->columns().size());
  return found;
}

Start ManoeuvreRuns::started(double torque, Until until) const {
  Start start{steady(torque)};
  const MotionTask task = task_of(kPatience * own_time(), torque);
  RunWatch watch;
  watch.reached = StartWatch(start, own_time(), until == Until::settled);
  watch.slopes = slopes_;
  MotionRun motion(design_, task, std::move(watch));
  run(motion, task);
  return start;
}

// dt*/dq of Omega = 0.9 Omega_s  (M10.1)
Moving ManoeuvreRuns::start_time(const Start& start) const {
  const Place& at = reached(start);
  return moving(at.time, [&](std::size_t k) {
    return -(at.slopes[k + kSpeed] - kReached * start.steady.slopes[k + kSpeed]) / at.rates[kSpeed];
  });
}

// At the peak Omega' = 0, and its time drops out.
Moving ManoeuvreRuns::start_overshoot(const Start& start) const {
  reached(start);
  const double steady = start.steady.y[kSpeed];
  if (!start.fastest || start.fastest->y[kSpeed] <= steady)
    return moving(0, [](std::size_t) { return 0.0; });
  const double ratio = start.fastest->y[kSpeed] / steady;
  return moving(ratio - 1, [&](std::size_t k) {
    return (start.fastest->slopes[k + kSpeed] - ratio * start.steady.slopes[k + kSpeed]) / steady;
  });
}

bool ManoeuvreRuns::starts() const {
  try {
    return started(0, Until::reached).reached.has_value();
  } catch (const WithoutValue&) {
    return false;
  }
}

RunEnd ManoeuvreRuns::stop(double torque) const {
  require_running(design_, torque);
  MotionTask task = task_of(kPatience * own_time(), torque);
  task.initial.steady = true;
  task.switched_off = {{0, task.duration}};
  RunWatch watch;
  watch.until_held = true, watch.slopes = slopes_;
  return held_end(task, std::move(watch));
}

Moving ManoeuvreRuns::stop_time(const RunEnd& end) const {
  return moving(end.time, [&](std::size_t k) { return end.time_slopes[k / count()]; });
}

// The rotor stands there, so that the time drops out.
Moving ManoeuvreRuns::stop_angle(const RunEnd& end) const {
  return moving(end.y[kAngle], [&](std::size_t k) { return end.slopes[k + kAngle]; });
}

// On from rest for a time, then off until the rotor is held. The time moves as `switch_slopes`.
RunEnd ManoeuvreRuns::burst(double on, std::vector<double> switch_slopes) const {
  MotionTask task = task_of(on + kPatience * own_time(), 0);
  task.switched_off = {{on, task.duration}};
  RunWatch watch;
  watch.until_held = true, watch.slopes = slopes_;
  watch.switch_slopes = std::move(switch_slopes);
  return held_end(task, std::move(watch));
}

// The time t = N / f moves with the frequency.
Moving ManoeuvreRuns::burst_angle(double periods) const {
  const double frequency = drive_frequency(design_), on = periods / frequency;
  std::vector<double> moves;
  if (slopes_)
    for (const ModelSlope& q : slopes_->columns())
      moves.push_back(-on / frequency * q.omega / (2 * std::numbers::pi) * q.scale);
  return stop_angle(burst(on, std::move(moves)));
}

// Off at the time t after which the rotor comes to rest at the angle: dt/dq = -theta_q / theta_t, dE = E_q + E_t dt.
Moving ManoeuvreRuns::move_energy(double angle) const {
  const ManoeuvreRuns plain(design_, nullptr);
  const auto excess = [&](double on) { return plain.burst(on).y[kAngle] - angle; };
  const double latest = time_to(angle);
  const double on = closed_in("end of the drive of a move", excess,
                              {0, latest, -angle, excess(latest)}, kSwitchBits)
                        .nearest();
  const RunEnd end = burst(on);
  if (!slopes_) return {end.y[kEnergy], {}};
  const double later = 1e-4 * on;  // E_t / theta_t by a difference, good to the square of that
  const RunEnd a = plain.burst(on - later), b = plain.burst(on + later);
  const double per_angle = (b.y[kEnergy] - a.y[kEnergy]) / (b.y[kAngle] - a.y[kAngle]);
  return moving(end.y[kEnergy], [&](std::size_t k) {
    return end.slopes[k + kEnergy] - per_angle * end.slopes[k + kAngle];
  });
}

// Until the rotor, driven from rest, has turned by an angle.
double ManoeuvreRuns::time_to(double angle) const {
  const Steady running = steady(0);
  const MotionTask task = task_of(kPatience * own_time() + 2 * angle / running.y[kSpeed], 0);
  std::optional<double> found;
  RunWatch watch;
  watch.reached = [&](const Integrator& integrator, double begin) {
    if (integrator.y()[kAngle] < angle) return false;
    found = falls_through_zero(begin, integrator.time(),
                               [&](double time) { return angle - integrator.at(time)[kAngle]; });
    return true;
  };
  MotionRun motion(design_, task, std::move(watch));
  run(motion, task);
  if (!found) throw WithoutValue{MetricStatus::does_not_start};
  return *found;
}

// Of the wave, 2 m_s / d_s, of the rotor under the holding torque, J Omega / (mu_0 F_N r) with the crest of the wave that the drive
// builds up at resonance, and of coasting, J (V0 / (r omega A))^2 / d_s (theory of motion, section 4).
double ManoeuvreRuns::own_time() const {
  const MotionModel& m = model_;
  const double omega = 2 * std::numbers::pi * drive_frequency(design_);
  const bool decays = m.driven && m.damping > 0;
  const double largest = decays ? m.drive_force(*design_.stator.voltage) / (m.damping * omega)
                                : design_.stator.amplitude;
  const double wave = decays ? 2 * m.mass / m.damping : 1e-3;
  const double crest = m.crest_per_amplitude * omega * largest;
  const double rotor = m.holding_torque > 0 ? m.inertia * crest / m.holding_torque : 0;
  const double coasting =
      decays ? m.inertia * m.crest_per_amplitude * m.crest_per_amplitude / m.damping : 0;
  return wave + rotor + coasting;
}

MotionTask ManoeuvreRuns::task_of(double duration, double torque) const {
  MotionTask task = steady_drive(design_, duration);
  task.load_torque = torque;
  if (slopes_) task.tolerance = kSlopeTolerance;
  return task;
}

RunEnd ManoeuvreRuns::held_end(const MotionTask& task, RunWatch watch) const {
  MotionRun motion(design_, task, std::move(watch));
  run(motion, task);
  RunEnd end = motion.end();
  if (!end.held) throw WithoutValue{MetricStatus::does_not_stop};
  return end;
}

void ManoeuvreRuns::run(MotionRun& run, const MotionTask& task) const {
  const Motion motion = followed(run, task, stretches_of(task, model_.driven));
  if (motion.status != "ok") throw WithoutValue{MetricStatus::not_converged};
}

// @param slope  of what is at place k of the states' slopes
template <typename Slope>
Moving ManoeuvreRuns::moving(double value, Slope slope) const {
  Moving m{value, {}};
  if (!slopes_) return m;
  for (std::size_t k = 0; k < slopes_->columns().size(); ++k)
    m.slopes.push_back(slope(k * count()) / slopes_->columns()[k].scale);
  return m;
}

}  // namespace twum::inline v0_1::motion
