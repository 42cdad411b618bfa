// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/linear_plant.hpp>

#include "normal_force.hpp"
#include "plant_outputs.hpp"
#include "poles.hpp"
#include "slow_flow.hpp"
#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/core/contact_gradients.hpp>
#include <twum/core/contact_slopes.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

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

PlantPoint steady_point(const MotorDesign& design, const MotionModel& model,
                        const Stretch& stretch) {
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
    const NormalForceSlopes by_force = by_normal_force(g, at);
    n.per_amplitude += by_force.per_amplitude;
    return by_force.per_height;
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

  ComplexRow(Eigen::Index states)
      : a(Eigen::RowVectorXcd::Zero(states)), b(Eigen::RowVectorXcd::Zero(kPlantInputs)) {}
  void put_into(Dynamics& s, Eigen::Index row) const {
    s.a.row(row) = a.real(), s.a.row(row + 1) = a.imag();
    s.b.row(row) = b.real(), s.b.row(row + 1) = b.imag();
  }
};

// The terminals behind a series branch (M3.1), beside wave and rotor at terminals whose voltage stays.
void add_series(Dynamics& s, const MotionModel& m, const PlantPoint& at, const StatePlaces& places,
                double divisor) {
  const double w = at.omega(), turn = 2 * std::numbers::pi, L = m.series_inductance;
  const Eigen::Index volts = as_index(places.voltage), amperes = as_index(places.current);
  const bool coil = places.current != StatePlaces::kNone;
  const Complex ahead = std::polar(1.0, at.phase_lag);  // zeta e^(i phi) = A
  const Complex per_voltage = ahead * m.force_factor / (kI * divisor);
  for (const Eigen::Index part : {0, 1}) {
    const Complex slope = part == 0 ? per_voltage : kI * per_voltage;
    s.a(kA, volts + part) = slope.real();
    s.a(kPhi, volts + part) = -slope.imag() / at.amplitude;
  }
  s.b(kA, kV) = s.b(kPhi, kV) = 0;  // the voltage acts by way of the terminals

  const Complex Y = m.capacitive_admittance(w), u = at.terminals.voltage, I = at.terminals.current;

  // zeta' = e^(-i phi) (A' - i A phi'), at rest in the frame of the drive
  ComplexRow row(s.a.rows());
  const Complex back = std::conj(ahead);
  row.a = -m.force_factor * back * (s.a.row(kA) - kI * at.amplitude * s.a.row(kPhi));
  row.b = -m.force_factor * back * (s.b.row(kA) - kI * at.amplitude * s.b.row(kPhi));
  row.a[kA] -= m.force_factor * kI * w * back;
  row.a[kPhi] -= m.force_factor * w * at.amplitude * back;
  row.b[kF] -= turn * (Y / w * u + m.force_factor * kI * at.zeta());
  const Complex by_voltage = Y + (coil ? 0.0 : 1 / m.series_resistance);
  row.a[volts] -= by_voltage, row.a[volts + 1] -= kI * by_voltage;
  if (coil) row.a[amperes] += 1, row.a[amperes + 1] += kI;
  if (!coil) row.b[kV] += std::numbers::sqrt2 / m.series_resistance;
  row.a /= m.capacitance, row.b /= m.capacitance;
  row.put_into(s, volts);
  if (!coil) return;
  ComplexRow current(s.a.rows());
  const Complex per_current = -Complex{m.series_resistance, w * L} / L;
  current.a[amperes] = per_current, current.a[amperes + 1] = kI * per_current;
  current.a[volts] = -1 / L, current.a[volts + 1] = -kI / L;
  current.b[kV] = std::numbers::sqrt2 / L, current.b[kF] = -turn * kI * I;
  current.put_into(s, amperes);
}

Dynamics dynamics(const MotionModel& m, const PlantPoint& at, const NearContact& near,
                  const StatePlaces& places) {
  const double w = at.omega(), A = at.amplitude, J = m.inertia;
  const auto &T = near.slopes.torque, &re = near.slopes.reactive_force,
             &im = near.slopes.active_force;
  const SlowFlow flow = slow_flow(m, A, w, slopes_of(re), slopes_of(im), slopes_of(T));
  const double D = flow.divisor, turn = 2 * std::numbers::pi;
  const double R_f = -2 * w * m.mass * A * turn + re.per_frequency;
  const double I_f = m.damping * A * turn + im.per_frequency;

  const Eigen::Index n = as_index(places.count);
  Dynamics s{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, kPlantInputs)};
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
  if (places.height != StatePlaces::kNone) {  // (M4.5)
    const Eigen::Index height = as_index(places.height), rise = height + 1;
    s.a(kA, height) = -near.active_per_height / D;
    s.a(kPhi, height) = -near.reactive_per_height / (D * A);
    s.a(kOmega, height) = near.torque_per_height / J;
    s.a(height, rise) = 1;
    s.a(rise, kA) = near.normal_per_amplitude / m.rotor_mass;
    s.a(rise, height) = near.normal_per_height / m.rotor_mass;
    s.a(rise, rise) = -m.axial_damping / m.rotor_mass;
  }
  if (places.voltage != StatePlaces::kNone) add_series(s, m, at, places, D);
  return s;
}

LinearPlant::Matrix rows_of(const Eigen::MatrixXd& m) {
  LinearPlant::Matrix rows;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    rows.emplace_back();
    for (Eigen::Index j = 0; j < m.cols(); ++j) rows.back().push_back(m(i, j));
  }
  return rows;
}

Eigen::MatrixXd stacked(const std::vector<PlantOutputs::Row>& rows) {
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

Eigen::VectorXd sizes_of_states(const MotionModel& m, const PlantPoint& at,
                                const StatePlaces& places, const NearContact& near) {
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(as_index(places.count));
  sizes[kA] = at.amplitude, sizes[kOmega] = at.speed;
  const auto put = [&](std::size_t pair, double first, double second) {
    if (pair != StatePlaces::kNone)
      sizes[as_index(pair)] = first, sizes[as_index(pair) + 1] = second;
  };
  const double u = std::abs(at.terminals.voltage), I = std::abs(at.terminals.current);
  put(places.voltage, u, u), put(places.current, I, I);
  if (places.height != StatePlaces::kNone)
    put(places.height, at.amplitude,
        at.amplitude * std::sqrt(-near.normal_per_height / m.rotor_mass));
  return sizes;
}

// The slowest first. A circuit that rings as fast as the stator vibrates is none of the averaged motor's motions (M3.1): it comes last.
std::vector<Complex> sorted_poles(std::vector<Complex> poles, double omega) {
  std::ranges::sort(poles, [&](Complex p, Complex q) {
    const bool p_is_slow = std::abs(p) < omega, q_is_slow = std::abs(q) < omega;
    if (p_is_slow != q_is_slow) return p_is_slow;
    return p.real() != q.real() ? p.real() > q.real() : p.imag() > q.imag();
  });
  return poles;
}

// Of the outputs but the angle, which is no steady one: -C A^-1 B + D.
LinearPlant::Matrix steady_gains(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                 const Eigen::VectorXd& sizes, const PlantOutputs& outputs,
                                 const std::vector<Eigen::Index>& states) {
  const Eigen::MatrixXd scaled = sizes.cwiseInverse().asDiagonal() * b;
  const Eigen::MatrixXd response =
      -(sizes.asDiagonal() * in_sizes(a, sizes).partialPivLu().solve(scaled));
  LinearPlant::Matrix gains;
  for (std::size_t i = 0; i < outputs.signals.size(); ++i) {
    if (static_cast<Eigen::Index>(i) == kTheta) continue;
    const PlantOutputs::Row row = outputs.c[i](states);
    const PlantOutputs::Row gain = row * response + outputs.d[i];
    gains.emplace_back(gain.begin(), gain.end());
  }
  return gains;
}

void require_voltage(const MotorDesign& design) {
  if (!design.stator.voltage)
    throw InputError("a plant needs a motor under a voltage; give stator.voltage and modal data");
}

NearContact contact_near(const MotionModel& model, const PlantPoint& at, AxialMotion axial) {
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

std::vector<Signal> states_of(const PlantPoint& at, const MotionModel& model,
                              const StatePlaces& places) {
  std::vector<Signal> states{{"amplitude", "m", at.amplitude},
                             {"phase_lag", "rad", at.phase_lag},
                             {"speed", "rad/s", at.speed},
                             {"angle", "rad", 0}};
  const auto add = [&](const char* name, const char* unit, Complex value) {
    states.push_back({std::string(name) + "_real", unit, value.real()});
    states.push_back({std::string(name) + "_imaginary", unit, value.imag()});
  };
  if (places.voltage != StatePlaces::kNone) add("terminal_voltage", "V", at.terminals.voltage);
  if (places.current != StatePlaces::kNone) add("phase_current", "A", at.terminals.current);
  if (places.height != StatePlaces::kNone) {
    states.push_back({"height", "m", model.balanced_height(at.amplitude)});
    states.push_back({"rise", "m/s", 0});
  }
  return states;
}

void require_mass(const MotorDesign& design, const char* what) {
  if (!design.rotor.mass)
    throw InputError("rotor_mass is missing; " + std::string(what) +
                     " needs it: give rotor.mass, such as 0.1 kg");
  if (!(*design.rotor.mass > 0))
    throw InputError("rotor_mass must be more than 0 kg for " + std::string(what));
}

}  // namespace

LinearPlant linearize(const MotorDesign& design, double load_torque, AxialMotion axial) {
  require_voltage(design);
  if (axial == AxialMotion::dynamic) require_mass(design, "a plant with an axial motion");
  const MotionModel model(design);
  const Stretch stretch = constant_inputs(design, load_torque);
  const PlantPoint at = steady_point(design, model, stretch);
  const NearContact near = contact_near(model, at, axial);
  const StatePlaces places(model, axial, kPlantStates);
  const Dynamics s = dynamics(model, at, near, places);

  LinearPlant plant;
  plant.states = states_of(at, model, places);
  plant.inputs = {{"voltage", "V", at.voltage},
                  {"frequency", "Hz", at.frequency},
                  {"load_torque", "N.m", at.load_torque}};
  PlantOutputs outputs(plant.states);
  outputs.add_current(model, at, places);
  if (const auto& sensor = model.motor.design().stator.sensor) outputs.add_sensor(*sensor, at);
  plant.outputs = outputs.signals;
  plant.a = rows_of(s.a), plant.b = rows_of(s.b);
  plant.c = rows_of(stacked(outputs.c)), plant.d = rows_of(stacked(outputs.d));

  const std::vector<Eigen::Index> in = without_angle(s.a.rows());
  const Eigen::MatrixXd a = s.a(in, in), b = s.b(in, Eigen::all);
  const Eigen::VectorXd sizes = sizes_of_states(model, at, places, near)(in);
  plant.poles = sorted_poles(poles_of(a, sizes), at.omega());
  plant.gains = steady_gains(a, b, sizes, outputs, in);
  return plant;
}

// The axial pair is the one next to the poles of the rotor on the layer alone, z'' = N_z z / m_r.
double bounce_rate(const MotorDesign& design, double load_torque) {
  require_voltage(design);
  require_mass(design, "a rate of hops");
  const LinearPlant plant = linearize(design, load_torque, AxialMotion::dynamic);
  const std::size_t rise = plant.states.size() - 1, height = rise - 1;
  return nearest_pole(plant.poles, kI * std::sqrt(-plant.a[rise][height])).real();
}

}  // namespace twum::inline v0_1::motion
