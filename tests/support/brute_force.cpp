// SPDX-License-Identifier: Apache-2.0
#include "support/brute_force.hpp"

#include "support/constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::test {
namespace {

constexpr int kHalvings = 14;

enum class Mode : signed char { slip_minus = -1, stick = 0, slip_plus = 1, open = 2 };

// sign of the slip velocity: a driven layer (slip+) is slower than the stator
double slip_sign(Mode mode) { return mode == Mode::slip_plus ? -1.0 : 1.0; }
Mode mode_for_traction(double traction) {
  return traction > 0 ? Mode::slip_plus : Mode::slip_minus;
}

struct State {
  double strain{0};  // y = eps
  double rate{0};    // z = eps'; unused without inertia
  Mode mode{Mode::open};
};

struct Sums {
  double traction{0};
  double stator{0};
  double friction{0};
  double loss{0};
};

struct Step {
  State state;
  double traction{0};  // mean over the step
  double released{0};  // elastic energy per area of a snap at its beginning, times 2 / h
  bool snaps{false};
};

class Stepper {
 public:
  explicit Stepper(const ContactProblem& problem) : p_(problem) {}

  void reset_sums() { sums_ = {}; }
  const Sums& sums() const { return sums_; }

  State lap(State state, int steps) {
    state = stretch(state, -p_.half_angle, p_.half_angle, steps, true);
    if (p_.full) return state;
    state.mode = Mode::open;
    state = stretch(state, p_.half_angle, 2 * kPi - p_.half_angle, steps, false);
    return state;
  }

 private:
  bool has_inertia() const { return p_.inertia > 0; }
  bool has_damping() const { return p_.damping > 0; }

  State stretch(State state, double from, double to, int steps, bool contact) {
    const double length = (to - from) / steps;
    finest_ = std::ldexp(length, -kHalvings);
    if (!contact && !has_inertia() && !has_damping()) return {0, 0, Mode::open};
    if (contact && state.mode == Mode::open) state.mode = entry_mode(state, from, length);
    for (int i = 0; i < steps; ++i) {
      const double theta = from + (to - from) * i / steps;
      state = contact ? advance(state, theta, length, 0) : free_step(state, theta, length);
    }
    return state;
  }

  State advance(const State& state, double theta, double length, int halvings) {
    const Step step = contact_step(state, theta, length);
    const bool uneventful = step.state.mode == state.mode && !step.snaps;
    if (uneventful || halvings == kHalvings) {
      account(state, step, theta, length);
      return step.state;
    }
    const State middle = advance(state, theta, length / 2, halvings + 1);
    return advance(middle, theta + length / 2, length / 2, halvings + 1);
  }

  State free_step(const State& state, double theta, double length) {
    Step step{end_with_traction(state, 0, length)};
    step.state.mode = Mode::open;
    account(state, step, theta, length);
    return step.state;
  }

  // A layer enters with the velocity it brings; without inertia, with the one that relaxation gives
  // it; without damping either, it slips if slipping is consistent.
  Mode entry_mode(const State& state, double theta, double length) const {
    if (has_inertia()) return mode_of(p_.slip_velocity(theta, state.rate));
    if (has_damping()) {
      return mode_of(p_.slip_velocity(theta, -p_.stiffness * state.strain / p_.damping));
    }
    for (const Mode mode : {Mode::slip_plus, Mode::slip_minus}) {
      if (slips_on(state, elastic_slip(state, mode, theta, length), mode, theta, length))
        return mode;
    }
    return Mode::stick;
  }
  static Mode mode_of(double slip_velocity) {
    return slip_velocity < 0 ? Mode::slip_plus : Mode::slip_minus;
  }

  Step contact_step(const State& state, double theta, double length) const {
    const Step sticking = stick_step(state, theta, length);
    const bool holds = sticking_holds(sticking, theta, length);
    if (state.mode == Mode::stick && holds) return sticking;
    Mode mode = state.mode == Mode::stick ? mode_for_traction(sticking.traction) : state.mode;
    const Step slipping = slip_step(state, mode, theta, length);
    if (slips_on(state, slipping.state, mode, theta, length)) return slipping;
    if (state.mode == Mode::stick) return restick_after_snap(state, slipping, mode, theta, length);
    if (holds) return sticking;
    return slip_step(state, mode_for_traction(sticking.traction), theta, length);
  }

  // A snap leaves the layer on the kinetic cone; if slipping on is inconsistent it sticks from there.
  Step restick_after_snap(const State& state, const Step& slipping, Mode mode, double theta,
                          double length) const {
    if (has_inertia() || has_damping()) return slipping;
    State fallen = state;
    fallen.strain = on_cone(mode, theta);
    Step step = stick_step(fallen, theta, length);
    step.released = released(state, fallen);
    step.snaps = true;
    return step;
  }

  // Judged over the last 2^-14 of the step, so that a threshold passed in its second half is seen.
  bool sticking_holds(const Step& sticking, double theta, double length) const {
    const double end = theta + length;
    if (!has_inertia() && !has_damping()) {
      return std::abs(p_.stiffness * sticking.state.strain) <= p_.threshold * p_.pressure(end);
    }
    if (length < 1.5 * finest_) return within(sticking.traction, theta + length / 2);
    const double rate = p_.sticking_rate(end - finest_);
    const double mean_rate = (rate + p_.sticking_rate(end)) / 2;
    const State before_end{sticking.state.strain - finest_ * mean_rate, rate, Mode::stick};
    return within(stick_step(before_end, end - finest_, finest_).traction, end - finest_ / 2);
  }
  bool within(double traction, double theta) const {
    return std::abs(traction) <= p_.threshold * p_.pressure(theta);
  }

  bool slips_on(const State& from, const State& to, Mode mode, double theta, double length) const {
    return slip_sign(mode) *
               p_.slip_velocity(theta + length, end_rate(from, to, mode, theta, length)) >=
           0;
  }

  // eps' at the end of a slip step
  double end_rate(const State& from, const State& to, Mode mode, double theta,
                  double length) const {
    const double end = theta + length;
    if (has_inertia()) return to.rate;
    if (has_damping()) return p_.stiffness / p_.damping * (on_cone(mode, end) - to.strain);
    if (from.mode == Mode::open) return (to.strain - from.strain) / length;
    return (on_cone(mode, end) - on_cone(mode, end - finest_)) / finest_;
  }

  Step stick_step(const State& state, double theta, double length) const {
    Step step{state};
    step.state.mode = Mode::stick;
    step.state.rate = p_.sticking_rate(theta + length);
    const double start = has_inertia() ? state.rate : p_.sticking_rate(theta);
    const double mean_rate = (start + step.state.rate) / 2;
    step.state.strain = state.strain + length * mean_rate;
    step.traction = p_.inertia * (step.state.rate - state.rate) / length + p_.damping * mean_rate +
                    p_.stiffness * (state.strain + step.state.strain) / 2;
    return step;
  }

  Step slip_step(const State& state, Mode mode, double theta, double length) const {
    if (!has_inertia() && !has_damping()) {
      const State start{state.mode == mode ? state.strain : on_cone(mode, theta), 0, mode};
      Step step{elastic_slip(start, mode, theta, length)};
      step.traction = p_.stiffness * (start.strain + step.state.strain) / 2;
      if (state.mode == Mode::stick) step.released = released(state, start);
      return step;
    }
    const double traction = -slip_sign(mode) * p_.kinetic * p_.pressure(theta + length / 2);
    Step step{end_with_traction(state, traction, length), traction};
    step.state.mode = mode;
    return step;
  }

  double on_cone(Mode mode, double theta) const {
    return -slip_sign(mode) * p_.kinetic * p_.pressure(theta) / p_.stiffness;
  }
  State elastic_slip(const State&, Mode mode, double theta, double length) const {
    return {on_cone(mode, theta + length), 0, mode};
  }
  double released(const State& before, const State& after) const {
    return p_.stiffness * (before.strain * before.strain - after.strain * after.strain);
  }

  State end_with_traction(const State& state, double traction, double length) const {
    State end = state;
    if (has_inertia()) {
      const double inert = p_.inertia / length;
      const double rest = (inert - p_.damping / 2 - p_.stiffness * length / 4) * state.rate;
      end.rate = (traction + rest - p_.stiffness * state.strain) /
                 (inert + p_.damping / 2 + p_.stiffness * length / 4);
      end.strain = state.strain + length * (state.rate + end.rate) / 2;
    } else if (has_damping()) {
      const double viscous = p_.damping / length;
      end.strain =
          (traction + (viscous - p_.stiffness / 2) * state.strain) / (viscous + p_.stiffness / 2);
    }
    return end;
  }

  void account(const State& from, const Step& step, double theta, double length) {
    const double middle = theta + length / 2;
    const double mean_rate = (step.state.strain - from.strain) / length;
    sums_.traction += step.traction * length;
    sums_.stator += step.traction * length * p_.crest_velocity * std::cos(middle);
    if (has_damping()) sums_.loss += p_.damping * mean_rate * mean_rate * length;
    if (step.state.mode == Mode::stick || step.state.mode == Mode::open) {
      sums_.friction += step.released / 2 * p_.strain_velocity;
      return;
    }
    const double elastic_start =
        from.mode == step.state.mode ? from.strain : on_cone(step.state.mode, theta);
    const double rate =
        has_inertia() || has_damping() ? mean_rate : (step.state.strain - elastic_start) / length;
    sums_.friction += -step.traction * p_.slip_velocity(middle, rate) * length +
                      step.released / 2 * p_.strain_velocity;
  }

  ContactProblem p_;
  Sums sums_;
  double finest_{0};  // length of a step halved as often as allowed
};

// Grid sequencing: the state found on one grid starts the next.
class PeriodicMarch {
 public:
  explicit PeriodicMarch(const ContactProblem& problem) : p_(problem), stepper_(problem) {
    strain_scale_ = p_.threshold * p_.pressure(0) / p_.stiffness +
                    std::max(p_.crest_velocity, std::abs(p_.rotor_velocity)) / p_.strain_velocity;
  }

  OracleResult run(int steps, int max_laps) {
    OracleResult result;
    for (int lap = 1; lap <= max_laps && !result.converged; ++lap) {
      const State before = state_;
      stepper_.reset_sums();
      state_ = stepper_.lap(state_, steps);
      result.converged = repeats(before) && lap > 1;
      result.laps = lap;
    }
    fill(result);
    return result;
  }

 private:
  bool repeats(const State& before) const {
    const double tolerance = 1e-14 * strain_scale_;
    const double frequency =
        p_.inertia > 0 ? std::max(1.0, std::sqrt(p_.stiffness / p_.inertia)) : 1.0;
    return before.mode == state_.mode && std::abs(state_.strain - before.strain) <= tolerance &&
           (p_.inertia == 0 || std::abs(state_.rate - before.rate) <= tolerance * frequency);
  }

  void fill(OracleResult& result) const {
    const double per_area = p_.track_area / (2 * kPi);
    const Sums& sums = stepper_.sums();
    result.torque = p_.radius * per_area * sums.traction;
    result.stator_power = per_area * sums.stator;
    result.friction_power = per_area * sums.friction;
    result.layer_loss = per_area * p_.strain_velocity * sums.loss;
  }

  ContactProblem p_;
  Stepper stepper_;
  State state_;
  double strain_scale_{0};
};

struct Extrapolated {
  double value;
  double error;
};

Extrapolated extrapolate(double coarse, double medium, double fine, double rounding) {
  const double first = std::abs(medium - coarse);
  const double second = std::abs(fine - medium);
  const bool second_order = std::abs(first - 4 * second) <= second + rounding;
  return {(4 * fine - medium) / 3, (second_order ? 2 : 4) * second + rounding};
}

}  // namespace

OracleResult fixed_grid(const MotorDesign& design, double speed, int steps, int max_laps) {
  PeriodicMarch march(contact_problem(design, speed));
  return march.run(steps, max_laps);
}

OracleResult brute_force(const MotorDesign& design, double speed,
                         const BruteForceOptions& options) {
  const ContactProblem problem = contact_problem(design, speed);
  PeriodicMarch march(problem);
  std::array<OracleResult, 3> grids;
  int steps = options.steps;
  for (OracleResult& grid : grids) {
    grid = march.run(steps, options.max_laps);
    steps *= 2;
  }
  const auto extrapolated = [&](double OracleResult::*field, double scale) {
    return extrapolate(grids[0].*field, grids[1].*field, grids[2].*field, 1e-12 * scale);
  };
  OracleResult result = grids[2];
  const Extrapolated torque = extrapolated(&OracleResult::torque, problem.torque_scale);
  result.torque = torque.value;
  result.torque_error = torque.error;
  for (const auto field :
       {&OracleResult::stator_power, &OracleResult::friction_power, &OracleResult::layer_loss}) {
    const Extrapolated power = extrapolated(field, problem.power_scale);
    result.*field = power.value;
    result.power_error = std::max(result.power_error, power.error);
  }
  for (const OracleResult& grid : grids) result.converged = result.converged && grid.converged;
  return result;
}

}  // namespace twum::test
