// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/linear_plant.hpp>

#include "hopping.hpp"
#include "slow_flow.hpp"
#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/core/contact_slopes.hpp>
#include <twum/motion/motion.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::motion {
namespace {

constexpr double kRms = std::numbers::sqrt2 / 2;

// States and inputs in their order.
enum : Eigen::Index { kA, kPhi, kOmega, kTheta };
enum : Eigen::Index { kV, kF, kT };

// The steady state.
struct At {
  double amplitude, phase_lag, speed, voltage, frequency, load_torque;
  double omega() const { return 2 * std::numbers::pi * frequency; }
};

Stretch constant_inputs(const MotorDesign& design, double load_torque) {
  const auto ramp = [](double value) { return Ramp{0, value, 0}; };
  return {0,
          1,
          ramp(*design.stator.voltage),
          ramp(0),
          ramp(drive_frequency(design)),
          ramp(load_torque),
          ramp(std::numbers::pi / 2),
          false,
          1};
}

At steady_point(const MotorDesign& design, const MotionModel& model, const Stretch& stretch) {
  Equations equations(model);
  equations.set_stretch(stretch);
  const States y = steady_state(design, equations);
  return {std::hypot(y[kReal], y[kImaginary]),
          -std::atan2(y[kImaginary], y[kReal]),
          y[kSpeed],
          stretch.voltage.value,
          stretch.frequency.value,
          stretch.load_torque.value};
}

// Wave and rotor: x' = A x + B u.
struct Dynamics {
  Eigen::MatrixXd a, b;
};

ForceSlopes slopes_of(const ContactSlopes::Number& n) {
  return {n.value, n.per_amplitude, n.per_speed};
}

Dynamics dynamics(const MotionModel& m, const At& at, const ContactSlopes& contact) {
  const double w = at.omega(), A = at.amplitude, J = m.inertia;
  const auto &T = contact.torque, &re = contact.reactive_force, &im = contact.active_force;
  const SlowFlow flow = slow_flow(m, A, w, slopes_of(re), slopes_of(im), slopes_of(T));
  const double D = flow.divisor, turn = 2 * std::numbers::pi;
  const double R_f = -2 * w * m.mass * A * turn + re.per_frequency;
  const double I_f = m.damping * A * turn + im.per_frequency;

  Dynamics s{Eigen::MatrixXd::Zero(4, 4), Eigen::MatrixXd::Zero(4, 3)};
  s.a.topLeftCorner<3, 3>() = flow.jacobian;
  s.a(kTheta, kOmega) = 1;
  // (M7.2)
  const double force = m.drive_force(1);
  s.b(kA, kV) = force * std::sin(at.phase_lag) / D;
  s.b(kPhi, kV) = force * std::cos(at.phase_lag) / (D * A);
  s.b(kA, kF) = -I_f / D;
  s.b(kPhi, kF) = -R_f / (D * A);
  s.b(kOmega, kF) = T.per_frequency / J;
  s.b(kOmega, kT) = -1 / J;
  return s;
}

// The phasor of an output, with its derivatives in A, phi, V and f.
struct Phasor {
  Complex value, in_amplitude, in_phase, in_voltage, in_frequency;
};

// I = i omega [C_0 (1 - i tan delta) u + Theta zeta] (D4.1)
Phasor current(const MotionModel& m, const At& at) {
  const Complex admittance = kI * at.omega() * m.capacitance * Complex{1, -m.loss_tangent};
  const Complex per_zeta = kI * at.omega() * m.force_factor;
  const Complex zeta = std::polar(at.amplitude, -at.phase_lag);
  const Complex value = admittance * std::numbers::sqrt2 * at.voltage + per_zeta * zeta;
  return {value, per_zeta * zeta / at.amplitude, -kI * per_zeta * zeta,
          admittance * std::numbers::sqrt2, value / at.frequency};
}

// U_e = -i omega Theta_e zeta e^(-i theta_e) / (i omega (C_e + C_load) + 1 / R_load) (D7.1)
Phasor sensor_voltage(const Sensor& sensor, const At& at) {
  const double capacitance = sensor.capacitance + sensor.load_capacitance;
  const double conductance = sensor.load_resistance ? 1 / *sensor.load_resistance : 0;
  const Complex load = kI * at.omega() * capacitance + conductance;
  const Complex value = -kI * at.omega() * sensor.force_factor *
                        std::polar(at.amplitude, -at.phase_lag - sensor.position) / load;
  return {value, value / at.amplitude, -kI * value, 0,
          value / at.frequency * (1.0 - kI * at.omega() * capacitance / load)};
}

using Row = Eigen::RowVectorXd;

// Outputs beside their rows of C and D.
class Outputs {
 public:
  explicit Outputs(const std::vector<Signal>& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      Row own = Row::Zero(4);
      own[static_cast<Eigen::Index>(i)] = 1;
      add(states[i], own, Row::Zero(3));
    }
  }

  void add_size(const std::string& name, const std::string& unit, const Phasor& p) {
    const double size = std::abs(p.value);
    add_real({name, unit, kRms * size}, p,
             [&](Complex by) { return kRms * (std::conj(p.value) * by).real() / size; });
  }
  void add_lag(const std::string& name, const Phasor& p) {
    add_real({name, "rad", -std::arg(p.value)}, p,
             [&](Complex by) { return -(by / p.value).imag(); });
  }

  std::vector<Signal> signals;
  std::vector<Row> c, d;

 private:
  template <typename Part>
  void add_real(Signal signal, const Phasor& p, Part part) {
    Row in_states = Row::Zero(4), in_inputs = Row::Zero(3);
    in_states[kA] = part(p.in_amplitude), in_states[kPhi] = part(p.in_phase);
    in_inputs[kV] = part(p.in_voltage), in_inputs[kF] = part(p.in_frequency);
    add(std::move(signal), in_states, in_inputs);
  }
  void add(Signal signal, const Row& in_states, const Row& in_inputs) {
    signals.push_back(std::move(signal));
    c.push_back(in_states), d.push_back(in_inputs);
  }
};

LinearPlant::Matrix rows_of(const Eigen::MatrixXd& m) {
  LinearPlant::Matrix rows;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    rows.emplace_back();
    for (Eigen::Index j = 0; j < m.cols(); ++j) rows.back().push_back(m(i, j));
  }
  return rows;
}

Eigen::MatrixXd stacked(const std::vector<Row>& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = rows[i];
  return m;
}

// Of amplitude, phase and speed in units of their size: in SI their numbers differ by so much that rounding would reach the poles.
std::vector<Complex> poles_of(const Dynamics& s, const At& at) {
  const Eigen::Vector3d unit{at.amplitude, 1, at.speed};
  const Eigen::Matrix3d scaled =
      unit.cwiseInverse().asDiagonal() * s.a.topLeftCorner<3, 3>() * unit.asDiagonal();
  const Eigen::Vector3cd values = Eigen::EigenSolver<Eigen::Matrix3d>(scaled, false).eigenvalues();
  std::vector<Complex> poles(values.begin(), values.end());
  std::ranges::sort(poles, [](const Complex& p, const Complex& q) {
    return p.real() != q.real() ? p.real() > q.real() : p.imag() > q.imag();
  });
  return poles;
}

// Without the angle, which is no steady output.
LinearPlant::Matrix steady_gains(const Dynamics& s, const Outputs& outputs) {
  const Eigen::MatrixXd response = -s.a.topLeftCorner(3, 3).fullPivLu().solve(s.b.topRows(3));
  LinearPlant::Matrix gains;
  for (std::size_t i = 0; i < outputs.signals.size(); ++i) {
    if (static_cast<Eigen::Index>(i) == kTheta) continue;
    const Row gain = outputs.c[i].head(3) * response + outputs.d[i];
    gains.emplace_back(gain.begin(), gain.end());
  }
  return gains;
}

void require_voltage(const MotorDesign& design) {
  if (!design.stator.voltage)
    throw InputError("a plant needs a motor under a voltage; give stator.voltage and modal data");
}

}  // namespace

LinearPlant linearize(const MotorDesign& design, double load_torque) {
  require_voltage(design);
  const MotionModel model(design);
  const Stretch stretch = constant_inputs(design, load_torque);
  const At at = steady_point(design, model, stretch);
  const ContactSlopes contact = contact_slopes(model.motor, {at.speed, at.amplitude, at.frequency});
  if (contact.status != PointStatus::ok)
    throw InputError(std::string("there is no plant at this torque: ") + to_string(contact.status));
  const Dynamics s = dynamics(model, at, contact);

  LinearPlant plant;
  plant.states = {{"amplitude", "m", at.amplitude},
                  {"phase_lag", "rad", at.phase_lag},
                  {"speed", "rad/s", at.speed},
                  {"angle", "rad", 0}};
  plant.inputs = {{"voltage", "V", at.voltage},
                  {"frequency", "Hz", at.frequency},
                  {"load_torque", "N.m", at.load_torque}};
  Outputs outputs(plant.states);
  outputs.add_size("phase_current", "A", current(model, at));
  if (const auto& sensor = model.motor.design().stator.sensor) {
    const Phasor signal = sensor_voltage(*sensor, at);
    outputs.add_size("sensor_voltage", "V", signal);
    outputs.add_lag("sensor_phase", signal);
  }
  plant.outputs = outputs.signals;
  plant.a = rows_of(s.a), plant.b = rows_of(s.b);
  plant.c = rows_of(stacked(outputs.c)), plant.d = rows_of(stacked(outputs.d));
  plant.poles = poles_of(s, at);
  plant.gains = steady_gains(s, outputs);
  return plant;
}

double bounce_rate(const MotorDesign& design, double load_torque) {
  require_voltage(design);
  if (!design.rotor.mass)
    throw InputError(
        "rotor_mass is missing; a rate of hops needs it: give rotor.mass, such as 0.1 kg");
  const MotionModel model(design);
  const Stretch stretch = constant_inputs(design, load_torque);
  const At at = steady_point(design, model, stretch);
  MotorDesign there = model.motor.design();
  there.stator.amplitude = at.amplitude;
  const double rate = hopping_rate(model, there, at.speed);
  if (std::isnan(rate))
    throw InputError("there is no plant at this torque: the contact has no answer");
  return rate;
}

}  // namespace twum::motion
