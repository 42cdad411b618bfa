// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/linear_plant.hpp>

#include "equations.hpp"
#include "hopping.hpp"
#include "slow_flow.hpp"
#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/core/contact_gradients.hpp>
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
  Equations::Electrical terminals;
  double omega() const { return 2 * std::numbers::pi * frequency; }
  Complex zeta() const { return std::polar(amplitude, -phase_lag); }
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
          stretch.load_torque.value,
          equations.electrical(0, y)};
}

// Where the states beyond the angle stand.
struct PlantPlaces {
  static constexpr Eigen::Index kNone = 0;
  Eigen::Index voltage{kNone}, current{kNone}, height{kNone}, count{4};

  PlantPlaces(const MotionModel& model, AxialMotion axial) {
    if (model.has_series()) voltage = add();
    if (model.has_series() && model.series_inductance != 0) current = add();
    if (axial == AxialMotion::dynamic) height = add();
  }
  Eigen::Index add() {
    count += 2;
    return count - 2;
  }
};

// The contact near the steady state, at a rotor whose height stays, and in its height.
struct NearContact {
  ContactSlopes slopes;
  double torque_per_height{0}, reactive_per_height{0}, active_per_height{0};
  double normal_per_amplitude{0}, normal_per_height{0};
};

// At a preload that stays the rotor keeps its balance; with a height of its own the normal force is N(A, z) (M4.5).
void free_the_height(NearContact& near, const ContactGradients& at) {
  near.normal_per_amplitude = at.normal_per_amplitude;
  near.normal_per_height = at.normal_per_height;
  const auto with_height = [&](ContactSlopes::Number& n, const ContactGradients::Number& g) {
    const double per_force = g.gradient[index_of(Parameter::preload)];
    n.per_amplitude += per_force * at.normal_per_amplitude;
    return per_force * at.normal_per_height;
  };
  near.torque_per_height = with_height(near.slopes.torque, at.torque);
  near.reactive_per_height = with_height(near.slopes.reactive_force, at.reactive_force);
  near.active_per_height = with_height(near.slopes.active_force, at.active_force);
}

// Wave, rotor, terminals and height: x' = A x + B u.
struct Dynamics {
  Eigen::MatrixXd a, b;
};

ForceSlopes slopes_of(const ContactSlopes::Number& n) {
  return {n.value, n.per_amplitude, n.per_speed};
}

// Complex rows of x' = A x + B u.
struct ComplexRow {
  Eigen::RowVectorXcd a, b;

  ComplexRow(Eigen::Index states) : a(Eigen::RowVectorXcd::Zero(states)), b(3) { b.setZero(); }
  void put_into(Dynamics& s, Eigen::Index row) const {
    s.a.row(row) = a.real(), s.a.row(row + 1) = a.imag();
    s.b.row(row) = b.real(), s.b.row(row + 1) = b.imag();
  }
};

// The terminals behind a series branch (M3.1), beside wave and rotor at terminals whose voltage stays.
void add_series(Dynamics& s, const MotionModel& m, const At& at, const PlantPlaces& places,
                double divisor) {
  const double w = at.omega(), turn = 2 * std::numbers::pi, L = m.series_inductance;
  const Complex ahead = std::polar(1.0, at.phase_lag);  // zeta e^(i phi) = A
  const Complex per_voltage = ahead * m.force_factor / (kI * divisor);
  for (const Eigen::Index part : {0, 1}) {
    const Complex slope = part == 0 ? per_voltage : kI * per_voltage;
    s.a(kA, places.voltage + part) = slope.real();
    s.a(kPhi, places.voltage + part) = -slope.imag() / at.amplitude;
  }
  s.b(kA, kV) = s.b(kPhi, kV) = 0;  // the voltage acts by way of the terminals

  const Complex Y = m.capacitive_admittance(w), u = at.terminals.voltage, I = at.terminals.current;
  const bool coil = places.current != PlantPlaces::kNone;
  // zeta' = e^(-i phi) (A' - i A phi'), at rest in the frame of the drive
  ComplexRow row(places.count);
  const Complex back = std::conj(ahead);
  row.a = -m.force_factor * back * (s.a.row(kA) - kI * at.amplitude * s.a.row(kPhi));
  row.b = -m.force_factor * back * (s.b.row(kA) - kI * at.amplitude * s.b.row(kPhi));
  row.a[kA] -= m.force_factor * kI * w * back;
  row.a[kPhi] -= m.force_factor * w * at.amplitude * back;
  row.b[kF] -= turn * (Y / w * u + m.force_factor * kI * at.zeta());
  const Complex by_voltage = Y + (coil ? 0.0 : 1 / m.series_resistance);
  row.a[places.voltage] -= by_voltage, row.a[places.voltage + 1] -= kI * by_voltage;
  if (coil) row.a[places.current] += 1, row.a[places.current + 1] += kI;
  if (!coil) row.b[kV] += std::numbers::sqrt2 / m.series_resistance;
  row.a /= m.capacitance, row.b /= m.capacitance;
  row.put_into(s, places.voltage);
  if (!coil) return;
  ComplexRow current(places.count);
  const Complex per_current = -Complex{m.series_resistance, w * L} / L;
  current.a[places.current] = per_current, current.a[places.current + 1] = kI * per_current;
  current.a[places.voltage] = -1 / L, current.a[places.voltage + 1] = -kI / L;
  current.b[kV] = std::numbers::sqrt2 / L, current.b[kF] = -turn * kI * I;
  current.put_into(s, places.current);
}

Dynamics dynamics(const MotionModel& m, const At& at, const NearContact& near,
                  const PlantPlaces& places) {
  const double w = at.omega(), A = at.amplitude, J = m.inertia;
  const auto &T = near.slopes.torque, &re = near.slopes.reactive_force,
             &im = near.slopes.active_force;
  const SlowFlow flow = slow_flow(m, A, w, slopes_of(re), slopes_of(im), slopes_of(T));
  const double D = flow.divisor, turn = 2 * std::numbers::pi;
  const double R_f = -2 * w * m.mass * A * turn + re.per_frequency;
  const double I_f = m.damping * A * turn + im.per_frequency;

  const Eigen::Index n = places.count;
  Dynamics s{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, 3)};
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
  if (places.height != PlantPlaces::kNone) {  // (M4.5)
    const Eigen::Index height = places.height, rise = height + 1;
    s.a(kA, height) = -near.active_per_height / D;
    s.a(kPhi, height) = -near.reactive_per_height / (D * A);
    s.a(kOmega, height) = near.torque_per_height / J;
    s.a(height, rise) = 1;
    s.a(rise, kA) = near.normal_per_amplitude / m.rotor_mass;
    s.a(rise, height) = near.normal_per_height / m.rotor_mass;
    s.a(rise, rise) = -m.axial_damping / m.rotor_mass;
  }
  if (places.voltage != PlantPlaces::kNone) add_series(s, m, at, places, D);
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
  explicit Outputs(const std::vector<Signal>& states)
      : count_(static_cast<Eigen::Index>(states.size())) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      Row own = Row::Zero(count_);
      own[static_cast<Eigen::Index>(i)] = 1;
      add(states[i], own, Row::Zero(3));
    }
  }

  void add_size(const std::string& name, const std::string& unit, const Phasor& p) {
    const double size = std::abs(p.value);
    add_real({name, unit, kRms * size}, p,
             [&](Complex by) { return kRms * (std::conj(p.value) * by).real() / size; });
  }
  // Of the size of a phasor whose parts are states.
  void add_size_of_states(const std::string& name, const std::string& unit, Complex value,
                          Eigen::Index place) {
    const double size = std::abs(value);
    Row in_states = Row::Zero(count_);
    in_states[place] = kRms * value.real() / size;
    in_states[place + 1] = kRms * value.imag() / size;
    add({name, unit, kRms * size}, in_states, Row::Zero(3));
  }
  // Of I = (sqrt(2) V - u) / R_s.
  void add_current_of_resistance(const MotionModel& m, const At& at, Eigen::Index voltage) {
    const Complex I = at.terminals.current;
    const double size = std::abs(I), per = kRms / (size * m.series_resistance);
    Row in_states = Row::Zero(count_), in_inputs = Row::Zero(3);
    in_states[voltage] = -per * I.real(), in_states[voltage + 1] = -per * I.imag();
    in_inputs[kV] = std::numbers::sqrt2 * per * I.real();
    add({"phase_current", "A", kRms * size}, in_states, in_inputs);
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
    Row in_states = Row::Zero(count_), in_inputs = Row::Zero(3);
    in_states[kA] = part(p.in_amplitude), in_states[kPhi] = part(p.in_phase);
    in_inputs[kV] = part(p.in_voltage), in_inputs[kF] = part(p.in_frequency);
    add(std::move(signal), in_states, in_inputs);
  }
  void add(Signal signal, const Row& in_states, const Row& in_inputs) {
    signals.push_back(std::move(signal));
    c.push_back(in_states), d.push_back(in_inputs);
  }

  Eigen::Index count_;
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

// All states but the angle, which integrates the speed.
std::vector<Eigen::Index> without_angle(Eigen::Index count) {
  std::vector<Eigen::Index> states;
  for (Eigen::Index i = 0; i < count; ++i)
    if (i != kTheta) states.push_back(i);
  return states;
}

// In SI the numbers of the states differ by so much that rounding would reach the poles.
Eigen::VectorXd sizes_of_states(const MotionModel& m, const At& at, const PlantPlaces& places,
                                const NearContact& near) {
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(places.count);
  unit[kA] = at.amplitude, unit[kOmega] = at.speed;
  const auto put = [&](Eigen::Index pair, double first, double second) {
    if (pair != PlantPlaces::kNone) unit[pair] = first, unit[pair + 1] = second;
  };
  const double u = std::abs(at.terminals.voltage), I = std::abs(at.terminals.current);
  put(places.voltage, u, u), put(places.current, I, I);
  if (places.height != PlantPlaces::kNone)
    put(places.height, at.amplitude,
        at.amplitude * std::sqrt(-near.normal_per_height / m.rotor_mass));
  return unit;
}

std::vector<Complex> poles_of(const Dynamics& s, const Eigen::VectorXd& sizes) {
  const auto in = without_angle(s.a.rows());
  const Eigen::VectorXd unit = sizes(in);
  const Eigen::MatrixXd scaled = unit.cwiseInverse().asDiagonal() * s.a(in, in) * unit.asDiagonal();
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(scaled, false).eigenvalues();
  std::vector<Complex> poles(values.begin(), values.end());
  std::ranges::sort(poles, [](const Complex& p, const Complex& q) {
    return p.real() != q.real() ? p.real() > q.real() : p.imag() > q.imag();
  });
  return poles;
}

// Without the angle, which is no steady output.
LinearPlant::Matrix steady_gains(const Dynamics& s, const Eigen::VectorXd& sizes,
                                 const Outputs& outputs) {
  const auto in = without_angle(s.a.rows());
  const Eigen::VectorXd unit = sizes(in);
  const Eigen::MatrixXd a = unit.cwiseInverse().asDiagonal() * s.a(in, in) * unit.asDiagonal();
  const Eigen::MatrixXd b = unit.cwiseInverse().asDiagonal() * s.b(in, Eigen::all);
  const Eigen::MatrixXd response = -(unit.asDiagonal() * a.partialPivLu().solve(b));
  LinearPlant::Matrix gains;
  for (std::size_t i = 0; i < outputs.signals.size(); ++i) {
    if (static_cast<Eigen::Index>(i) == kTheta) continue;
    const Row row = outputs.c[i](in);
    const Row gain = row * response + outputs.d[i];
    gains.emplace_back(gain.begin(), gain.end());
  }
  return gains;
}

void require_voltage(const MotorDesign& design) {
  if (!design.stator.voltage)
    throw InputError("a plant needs a motor under a voltage; give stator.voltage and modal data");
}

}  // namespace

namespace {

NearContact contact_near(const MotionModel& model, const At& at, AxialMotion axial) {
  NearContact near{contact_slopes(model.motor, {at.speed, at.amplitude, at.frequency})};
  PointStatus status = near.slopes.status;
  if (status == PointStatus::ok && axial == AxialMotion::dynamic) {
    const ContactGradients gradients =
        ContactDifferentiator(model.motor.design()).at(at.amplitude, at.speed);
    status = gradients.status;
    free_the_height(near, gradients);
  }
  if (status != PointStatus::ok)
    throw InputError(std::string("there is no plant at this torque: ") + to_string(status));
  return near;
}

std::vector<Signal> states_of(const At& at, const MotionModel& model, const PlantPlaces& places) {
  std::vector<Signal> states{{"amplitude", "m", at.amplitude},
                             {"phase_lag", "rad", at.phase_lag},
                             {"speed", "rad/s", at.speed},
                             {"angle", "rad", 0}};
  const auto add = [&](const char* name, const char* unit, Complex value) {
    states.push_back({std::string(name) + "_real", unit, value.real()});
    states.push_back({std::string(name) + "_imaginary", unit, value.imag()});
  };
  if (places.voltage != PlantPlaces::kNone) add("terminal_voltage", "V", at.terminals.voltage);
  if (places.current != PlantPlaces::kNone) add("phase_current", "A", at.terminals.current);
  if (places.height != PlantPlaces::kNone) {
    states.push_back({"height", "m", model.balanced_height(at.amplitude)});
    states.push_back({"rise", "m/s", 0});
  }
  return states;
}

void require_mass(const MotorDesign& design, const char* what) {
  if (design.rotor.mass.value_or(0) > 0) return;
  throw InputError("rotor_mass is missing; " + std::string(what) +
                   " needs it: give rotor.mass, such as 0.1 kg");
}

}  // namespace

LinearPlant linearize(const MotorDesign& design, double load_torque, AxialMotion axial) {
  require_voltage(design);
  if (axial == AxialMotion::dynamic) require_mass(design, "a plant with an axial motion");
  const MotionModel model(design);
  const Stretch stretch = constant_inputs(design, load_torque);
  const At at = steady_point(design, model, stretch);
  const NearContact near = contact_near(model, at, axial);
  const PlantPlaces places(model, axial);
  const Dynamics s = dynamics(model, at, near, places);

  LinearPlant plant;
  plant.states = states_of(at, model, places);
  plant.inputs = {{"voltage", "V", at.voltage},
                  {"frequency", "Hz", at.frequency},
                  {"load_torque", "N.m", at.load_torque}};
  Outputs outputs(plant.states);
  if (places.current != PlantPlaces::kNone)
    outputs.add_size_of_states("phase_current", "A", at.terminals.current, places.current);
  else if (places.voltage != PlantPlaces::kNone)
    outputs.add_current_of_resistance(model, at, places.voltage);
  else
    outputs.add_size("phase_current", "A", current(model, at));
  if (const auto& sensor = model.motor.design().stator.sensor) {
    const Phasor signal = sensor_voltage(*sensor, at);
    outputs.add_size("sensor_voltage", "V", signal);
    outputs.add_lag("sensor_phase", signal);
  }
  plant.outputs = outputs.signals;
  plant.a = rows_of(s.a), plant.b = rows_of(s.b);
  plant.c = rows_of(stacked(outputs.c)), plant.d = rows_of(stacked(outputs.d));
  const Eigen::VectorXd sizes = sizes_of_states(model, at, places, near);
  plant.poles = poles_of(s, sizes);
  // A circuit that rings as fast as the stator vibrates is none of the averaged motor's motions (M3.1).
  const double omega = 2 * std::numbers::pi * at.frequency;
  std::ranges::stable_partition(plant.poles, [&](Complex pole) { return std::abs(pole) < omega; });
  plant.gains = steady_gains(s, sizes, outputs);
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
  if (model.has_series()) {
    const double per_height = contact_near(model, at, AxialMotion::dynamic).normal_per_height;
    const std::vector<Complex> poles = linearize(design, load_torque, AxialMotion::dynamic).poles;
    return nearest_pole(poles, kI * std::sqrt(-per_height / *design.rotor.mass)).real();
  }
  const double rate = hopping_rate(model, there, at.speed);
  if (std::isnan(rate))
    throw InputError("there is no plant at this torque: the contact has no answer");
  return rate;
}

}  // namespace twum::motion
