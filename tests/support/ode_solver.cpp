// SPDX-License-Identifier: Apache-2.0
#include "support/ode_solver.hpp"

#include "support/constants.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace twum::test {
namespace {

constexpr std::size_t kSize = 6;  // eps, eps', and the integrals of traction and three powers
using Vector = std::array<double, kSize>;

enum class Mode : signed char { slip_minus = -1, stick = 0, slip_plus = 1, open = 2 };

const gsl_odeiv2_step_type* step_type(OdeMethod method) {
  return method == OdeMethod::fehlberg_4_5 ? gsl_odeiv2_step_rkf45 : gsl_odeiv2_step_rk8pd;
}

class OdeMarch {
 public:
  OdeMarch(const ContactProblem& problem, const OdeOptions& options)
      : p_(problem),
        options_(options),
        step_(gsl_odeiv2_step_alloc(step_type(options.method), kSize)) {
    system_ = {&OdeMarch::derivative, nullptr, kSize, this};
    set_scales();
    control_.reset(
        gsl_odeiv2_control_scaled_new(options.tolerance, 0, 1, 0, scales_.data(), kSize));
  }

  OracleResult run() {
    OracleResult result;
    for (int lap = 1; lap <= options_.max_laps && !result.converged; ++lap) {
      const Vector before = y_;
      const Mode mode_before = mode_;
      std::fill(y_.begin() + 2, y_.end(), 0.0);
      march_lap();
      result.laps = lap;
      result.converged = lap > 1 && mode_before == mode_ && repeats(before);
    }
    const double per_area = p_.track_area / (2 * kPi);
    result.torque = p_.radius * per_area * y_[2];
    result.stator_power = per_area * y_[3];
    result.friction_power = per_area * y_[4];
    result.layer_loss = per_area * y_[5];
    return result;
  }

 private:
  struct Free {
    void operator()(gsl_odeiv2_step* step) const { gsl_odeiv2_step_free(step); }
    void operator()(gsl_odeiv2_control* control) const { gsl_odeiv2_control_free(control); }
  };

  void set_scales() {
    const double velocity = std::max(p_.crest_velocity, std::abs(p_.rotor_velocity));
    const double frequency =
        p_.inertia > 0 ? std::max(1.0, std::sqrt(p_.stiffness / p_.inertia)) : 1.0;
    strain_ = std::min(
        p_.threshold * p_.pressure(0) / p_.stiffness + velocity / p_.strain_velocity / frequency,
        velocity / p_.strain_velocity * std::max(1.0, p_.half_angle));
    const double mean = 2 * kPi * p_.torque_scale / (p_.radius * p_.track_area);
    scales_ = {strain_,         strain_ * frequency, mean,
               mean * velocity, mean * velocity,     mean * velocity};
    max_step_ = std::min(options_.max_step, 0.5 / frequency);
  }

  static int derivative(double theta, const double y[], double dydt[], void* self) {
    const auto& march = *static_cast<OdeMarch*>(self);
    const ContactProblem& p = march.p_;
    const double tau = march.traction(theta, y);
    const double rate = march.rate(theta, y);
    dydt[0] = rate;
    dydt[1] = march.acceleration(theta, y, tau);
    dydt[2] = tau;
    dydt[3] = tau * p.crest_velocity * std::cos(theta);
    dydt[4] = march.slips() ? -tau * p.slip_velocity(theta, rate) : 0.0;
    dydt[5] = p.damping * p.strain_velocity * rate * rate;
    return GSL_SUCCESS;
  }

  bool slips() const { return mode_ == Mode::slip_minus || mode_ == Mode::slip_plus; }

  double sticking_traction(double theta, const double y[]) const {
    const double slope = -p_.crest_velocity * std::sin(theta) / p_.strain_velocity;
    return p_.inertia * slope + p_.damping * p_.sticking_rate(theta) + p_.stiffness * y[0];
  }
  double traction(double theta, const double y[]) const {
    if (mode_ == Mode::open) return 0;
    if (mode_ == Mode::stick) return sticking_traction(theta, y);
    return static_cast<double>(mode_) * p_.kinetic * p_.pressure(theta);
  }
  double rate(double theta, const double y[]) const {
    if (mode_ == Mode::stick) return p_.sticking_rate(theta);
    if (p_.inertia > 0) return y[1];
    return (traction(theta, y) - p_.stiffness * y[0]) / p_.damping;
  }
  double acceleration(double theta, const double y[], double tau) const {
    if (mode_ == Mode::stick) return -p_.crest_velocity * std::sin(theta) / p_.strain_velocity;
    if (p_.inertia == 0) return 0;
    return (tau - p_.damping * y[1] - p_.stiffness * y[0]) / p_.inertia;
  }

  // Positive while the mode lasts.
  double margin(double theta, const Vector& y) const {
    if (mode_ == Mode::open) return 1;
    if (mode_ == Mode::stick) {
      return p_.threshold * p_.pressure(theta) - std::abs(sticking_traction(theta, y.data()));
    }
    return -static_cast<double>(mode_) * p_.slip_velocity(theta, rate(theta, y.data()));
  }

  void march_lap() {
    if (mode_ == Mode::open) enter();
    advance_to(-p_.half_angle, p_.half_angle);
    if (p_.full) return;
    mode_ = Mode::open;
    advance_to(p_.half_angle, 2 * kPi - p_.half_angle);
  }

  void enter() {
    const double theta = -p_.half_angle;
    const double entering = p_.slip_velocity(theta, rate(theta, y_.data()));
    mode_ = entering < 0 ? Mode::slip_plus : Mode::slip_minus;
  }

  void advance_to(double theta, double end) {
    double length = std::min(max_step_, (end - theta) / 16);
    fresh_ = true;
    while (theta < end) {
      // a step that would end within rounding of the border is stretched onto it
      bool last = theta + length * (1 + 1e-9) >= end;
      const double tried = last ? end - theta : length;
      Vector next = y_;
      if (!try_step(theta, tried, next, length)) continue;
      if (margin(last ? end : theta + tried, next) < 0 && !fresh_event(theta, tried, next)) {
        theta += locate(theta, tried);
        change_mode(theta);
        continue;
      }
      y_ = next;
      theta = last ? end : theta + tried;
      fresh_ = false;
    }
  }

  // One controlled step; false if it has to be repeated with the shorter `length`.
  bool try_step(double theta, double tried, Vector& next, double& length) {
    Vector error{};
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_step_apply(step_.get(), theta, tried, next.data(), error.data(), nullptr, nullptr,
                          &system_);
    Vector slope{};
    length = tried;
    const int verdict = gsl_odeiv2_control_hadjust(control_.get(), step_.get(), next.data(),
                                                   error.data(), slope.data(), &length);
    length = std::min(length, max_step_);
    return verdict != GSL_ODEIV_HADJ_DEC || tried < 1e-12;
  }

  // Right after an event the margin starts from zero, and rounding may make it start below.
  bool fresh_event(double theta, double tried, const Vector& next) const {
    return fresh_ && tried < 1e-9 && margin(theta + tried, next) > -1e-9 * margin_scale();
  }
  double margin_scale() const {
    return mode_ == Mode::stick ? p_.threshold * p_.pressure(0)
                                : std::max(p_.crest_velocity, std::abs(p_.rotor_velocity));
  }

  // Bisection refined by the secant (Illinois): the part of a step after which the margin vanishes.
  double locate(double theta, double tried) {
    double low = 0;
    double high = tried;
    double at_low = std::max(margin(theta, y_), 0.0);
    Vector state = y_;
    double at_high = margin_after(theta, high, state);
    for (int i = 0; i < 80 && high - low > 4e-16 * std::max(1.0, std::abs(theta)); ++i) {
      const double middle = i % 3 == 2 || at_low <= 0
                                ? (low + high) / 2
                                : low + (high - low) * at_low / (at_low - at_high);
      const double value = margin_after(theta, middle, state);
      if (value >= 0) {
        low = middle;
        at_low = value;
      } else {
        high = middle;
        at_high = value;
      }
    }
    margin_after(theta, high, state);
    y_ = state;
    return high;
  }
  double margin_after(double theta, double length, Vector& state) {
    state = y_;
    if (length > 0) {
      Vector error{};
      gsl_odeiv2_step_reset(step_.get());
      gsl_odeiv2_step_apply(step_.get(), theta, length, state.data(), error.data(), nullptr,
                            nullptr, &system_);
    }
    return margin(theta + length, state);
  }

  void change_mode(double theta) {
    fresh_ = true;
    const double sticking = sticking_traction(theta, y_.data());
    const Mode towards = sticking > 0 ? Mode::slip_plus : Mode::slip_minus;
    if (mode_ != Mode::stick && std::abs(sticking) <= p_.threshold * p_.pressure(theta)) {
      mode_ = Mode::stick;
      y_[1] = p_.sticking_rate(theta);
    } else {
      mode_ = towards;
    }
  }

  bool repeats(const Vector& before) const {
    return std::abs(y_[0] - before[0]) <= options_.repeat * scales_[0] &&
           (p_.inertia == 0 || std::abs(y_[1] - before[1]) <= options_.repeat * scales_[1]);
  }

  ContactProblem p_;
  OdeOptions options_;
  std::unique_ptr<gsl_odeiv2_step, Free> step_;
  std::unique_ptr<gsl_odeiv2_control, Free> control_;
  gsl_odeiv2_system system_{};
  Vector scales_{};
  Vector y_{};
  Mode mode_{Mode::open};
  double strain_{0};
  double max_step_{0};
  bool fresh_{true};
};

}  // namespace

OracleResult ode_solver_run(const MotorDesign& design, double speed, const OdeOptions& options) {
  return OdeMarch(contact_problem(design, speed), options).run();
}

OracleResult ode_solver(const MotorDesign& design, double speed, const OdeOptions& options) {
  const ContactProblem problem = contact_problem(design, speed);
  OdeOptions coarse = options;
  coarse.tolerance *= 30;
  OracleResult result = ode_solver_run(design, speed, options);
  const OracleResult check = ode_solver_run(design, speed, coarse);
  result.converged = result.converged && check.converged;
  result.torque_error = std::abs(result.torque - check.torque) + 1e-12 * problem.torque_scale;
  for (const auto field :
       {&OracleResult::stator_power, &OracleResult::friction_power, &OracleResult::layer_loss}) {
    result.power_error = std::max(result.power_error, std::abs(result.*field - check.*field));
  }
  result.power_error += 1e-12 * problem.power_scale;
  return result;
}

}  // namespace twum::test
