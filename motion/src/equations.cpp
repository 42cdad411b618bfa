// SPDX-License-Identifier: Apache-2.0
#include "equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

// Speed at which the contact of a rotor is taken that is about to stop [rad/s]: the rates then stay smooth up to the event, and
// at rest they are the limit from the rotor's side. It moves a torque by 1e-11 of itself.
constexpr double kSmallestSpeed = 1e-12;

// Relative step of the differences for the Jacobian. Torque and force are exact to some 1e-13.
constexpr double kStep = 1e-6;

Complex zeta_of(std::span<const double> y) { return {y[kReal], y[kImaginary]}; }
Complex pair_at(std::span<const double> y, std::size_t place) { return {y[place], y[place + 1]}; }
void put_pair(std::span<double> y, std::size_t place, Complex value) {
  y[place] = value.real(), y[place + 1] = value.imag();
}

// dA / dzeta
Complex direction(Complex zeta) { return zeta == Complex{0, 0} ? zeta : zeta / std::abs(zeta); }

}  // namespace

double Equations::omega(double time) const {
  return 2 * std::numbers::pi * stretch_.frequency.at(time);
}

double Equations::amplitude(double time, std::span<const double> y) const {
  return model_->driven ? std::abs(zeta_of(y)) : stretch_.amplitude.at(time);
}

double Equations::load(double time, double angle) const {
  return stretch_.load_torque.at(time) + model_->spring(angle);
}

double Equations::contact_speed(double speed) const {
  return mode_.held ? 0 : mode_.side * std::max(mode_.side * speed, kSmallestSpeed);
}

double Equations::height(std::span<const double> y) const {
  return places_.height == StatePlaces::kNone ? 0 : y[places_.height];
}

ContactForces Equations::forces_at(double time, double amplitude, double speed, double height) {
  const double d = stretch_.direction;
  const double preload = places_.height == StatePlaces::kNone
                             ? Contact::kOfDesign
                             : model_->normal_force(amplitude, height);
  ContactForces f = contact_.at(amplitude, d * speed, stretch_.frequency.at(time), preload);
  f.torque *= d;
  return f;
}

ContactForces Equations::forces(double time, std::span<const double> y) {
  return forces_at(time, amplitude(time, y), contact_speed(y[kSpeed]), height(y));
}

HoldingLimits Equations::holding_limits(double time, std::span<const double> y) {
  const double a = amplitude(time, y), z = height(y), along_wave = stretch_.direction;
  const ContactForces one = forces_at(time, a, along_wave * kSmallestSpeed, z);
  const double against_wave = -along_wave;
  ContactForces other = one;
  if (model_->mirrors_at_rest)
    other.torque = along_wave * std::abs(one.torque);
  else
    other = forces_at(time, a, against_wave * kSmallestSpeed, z);
  const bool known = one.known && other.known;
  return along_wave > 0 ? HoldingLimits{one.torque, other.torque, known}
                        : HoldingLimits{other.torque, one.torque, known};
}

Complex Equations::capacitive_admittance(double time) const {
  return model_->capacitive_admittance(omega(time));
}

Complex Equations::source(double time) const {
  return {std::numbers::sqrt2 * stretch_.voltage.at(time), 0};
}

Equations::Electrical Equations::electrical(double time, std::span<const double> y) const {
  const double w = omega(time);
  const Complex zeta = zeta_of(y), V = source(time);
  if (has_circuit()) {
    const Complex u = pair_at(y, places_.voltage);
    const Complex I = places_.current == StatePlaces::kNone ? (V - u) / model_->series_resistance
                                                            : pair_at(y, places_.current);
    return {u, I, V};
  }
  const Complex u = stretch_.off ? model_->off_voltage(w) * zeta : V;
  return {u, capacitive_admittance(time) * u + kI * w * model_->force_factor * zeta, u};  // (D4.1)
}

Equations::Electrical Equations::settled_circuit(double time, std::span<const double> y) const {
  const double w = omega(time);
  const Complex Z{model_->series_resistance, w * model_->series_inductance}, V = source(time);
  const Complex motional = kI * w * model_->force_factor * zeta_of(y);
  const Complex Y = capacitive_admittance(time);
  const Complex u = (V - Z * motional) / (1.0 + Z * Y);  // (M3.2)
  return {u, Y * u + motional, V};
}

void Equations::set_circuit(std::span<double> y, Complex voltage, Complex current) const {
  if (places_.voltage != StatePlaces::kNone) put_pair(y, places_.voltage, voltage);
  if (places_.current != StatePlaces::kNone) put_pair(y, places_.current, current);
}

// L_s I' = V - u - (R_s + i omega L_s) I,  C_0 u' = I - i omega C_0 (1 - i tan delta) u - Theta (zeta' + i omega zeta)  (M3.1)
Equations::CircuitRate Equations::circuit_rate(double time, std::span<const double> y,
                                               Complex wave) const {
  const double w = omega(time), L = model_->series_inductance;
  const auto [u, I, V] = electrical(time, y);
  const Complex motional = model_->force_factor * (wave + kI * w * zeta_of(y));
  const Complex du = (I - capacitive_admittance(time) * u - motional) / model_->capacitance;
  if (L == 0) return {du, 0};
  return {du, (V - u - Complex{model_->series_resistance, w * L} * I) / L};
}

// Derivative of the electrical power along a step of zeta, at terminals without states of their own.
double Equations::power_slope(double time, const Electrical& at, Complex dzeta) const {
  const double w = omega(time);
  const Complex du = stretch_.off ? model_->off_voltage(w) * dzeta : Complex{0, 0};
  const Complex di = capacitive_admittance(time) * du + kI * w * model_->force_factor * dzeta;
  return (du * std::conj(at.current) + at.voltage * std::conj(di)).real();
}

// zeta' = drive + growth zeta, of
// i m_s (omega + omega_b) zeta' = Theta u - (k_s - omega^2 m_s + i omega d_s + F / A) zeta   (M2.1)
struct Equations::WaveRate {
  Complex drive, growth;
  Complex divisor;   ///< i m_s (omega + omega_b)
  double free_rate;  ///< omega_b
  double rates;      ///< omega + omega_b

  Complex of(Complex zeta) const { return drive + growth * zeta; }
};

Equations::WaveRate Equations::wave_rate(double time, std::span<const double> y,
                                         Complex contact_stiffness) const {
  const double w = omega(time), m = model_->mass;
  const double free = std::sqrt((model_->stiffness_of_wave + contact_stiffness.real()) / m);
  Complex stiffness =
      model_->stiffness_of_wave - w * w * m + kI * w * model_->damping + contact_stiffness;
  Complex drive = 0;
  if (stretch_.off)
    stiffness -= model_->force_factor * model_->off_voltage(w);  // (M3.2)
  else if (has_circuit())
    drive = model_->force_factor * pair_at(y, places_.voltage);
  else
    drive = model_->drive_force(stretch_.voltage.at(time));
  const Complex divisor = kI * m * (w + free);
  return {drive / divisor, -stiffness / divisor, divisor, free, w + free};
}

bool Equations::rates(double time, std::span<const double> y, std::span<double> dy) {
  const ContactForces f = forces(time, y);
  if (!f.known) return false;
  std::ranges::fill(dy, 0.0);
  if (model_->driven) {
    const WaveRate wave = wave_rate(time, y, f.stiffness);
    const Complex zeta = zeta_of(y);
    const Complex rate = stretch_.off ? wave.growth.real() * zeta : wave.of(zeta);
    dy[kReal] = rate.real(), dy[kImaginary] = rate.imag();
    dy[kTurn] = stretch_.off ? wave.growth.imag() : 0;
    dy[kEnergy] = electrical(time, y).power();
    if (has_circuit()) {
      const auto [voltage, current] = circuit_rate(time, y, rate);
      set_circuit(dy, voltage, current);
    }
  }
  if (places_.height != StatePlaces::kNone) {  // (M4.5)
    const double normal = model_->normal_force(amplitude(time, y), height(y));
    const double rise = y[places_.rise];
    dy[places_.height] = rise;
    dy[places_.rise] = (normal - model_->motor.design().preload - model_->axial_damping * rise) /
                       model_->rotor_mass;
  }
  if (mode_.held) return true;
  dy[kSpeed] = (f.torque - load(time, y[kAngle]) - model_->load_damping * y[kSpeed] -
                mode_.side * model_->load_friction) /
               model_->inertia;  // (M2.2)
  dy[kAngle] = y[kSpeed];
  return true;
}

// Derivatives of the contact at an instant, by differences. The torque changes over speeds of the order of the crest's.
std::optional<Equations::ContactDerivatives> Equations::contact_derivatives(
    double time, std::span<const double> y) {
  constexpr double kLeast = 1e-15;  // without a preload nothing has a size, and nothing changes
  const double a = amplitude(time, y), speed = contact_speed(y[kSpeed]);
  const double size = std::max({a, 1e-3 * model_->full_contact_amplitude, kLeast});
  const double crest = model_->crest_per_amplitude * omega(time) * size;
  const double da = kStep * size, dw = mode_.side * kStep * std::max(std::abs(speed), 0.1 * crest);
  const double z = height(y), dz = kStep * std::max(size, std::abs(z));
  const ContactForces here = forces_at(time, a, speed, z);
  const ContactForces larger = model_->driven ? forces_at(time, a + da, speed, z) : here;
  const ContactForces faster = mode_.held ? here : forces_at(time, a, speed + dw, z);
  const ContactForces higher =
      places_.height == StatePlaces::kNone ? here : forces_at(time, a, speed, z + dz);
  if (!here.known || !larger.known || !faster.known || !higher.known) return {};
  return ContactDerivatives{here.stiffness,
                            (larger.stiffness - here.stiffness) / da,
                            (faster.stiffness - here.stiffness) / dw,
                            (higher.stiffness - here.stiffness) / dz,
                            (larger.torque - here.torque) / da,
                            (faster.torque - here.torque) / dw,
                            (higher.torque - here.torque) / dz};
}

bool Equations::jacobian(double time, std::span<const double> y, std::span<double> jacobian) {
  std::ranges::fill(jacobian, 0.0);
  const Entries entries{jacobian, places_.count};
  const auto contact = contact_derivatives(time, y);
  if (!contact) return false;
  if (model_->driven) add_wave(entries, time, y, *contact);
  if (model_->driven && has_circuit()) add_circuit(entries, time);
  if (!mode_.held) add_rotor(entries, y, *contact);
  if (places_.height != StatePlaces::kNone) add_height(entries, time, y);
  return true;
}

void Equations::add_wave(const Entries& entry, double time, std::span<const double> y,
                         const ContactDerivatives& contact) const {
  const Complex zeta = zeta_of(y);
  const WaveRate wave = wave_rate(time, y, contact.stiffness);
  const auto put = [&](std::size_t in, Complex dzeta, Complex dstiffness) {
    const double dfree = dstiffness.real() / (2 * model_->mass * wave.free_rate);
    const Complex dgrowth = -dstiffness / wave.divisor - wave.growth * dfree / wave.rates;
    const Complex ddrive = -wave.drive * dfree / wave.rates;
    const Complex d = stretch_.off ? wave.growth.real() * dzeta + dgrowth.real() * zeta
                                   : ddrive + wave.growth * dzeta + dgrowth * zeta;
    entry(kReal, in) = d.real(), entry(kImaginary, in) = d.imag();
    if (stretch_.off) entry(kTurn, in) = dgrowth.imag();
  };
  const Complex along = direction(zeta);
  put(kReal, 1, along.real() * contact.stiffness_per_amplitude);
  put(kImaginary, kI, along.imag() * contact.stiffness_per_amplitude);
  put(kSpeed, 0, contact.stiffness_per_speed);
  if (places_.height != StatePlaces::kNone) put(places_.height, 0, contact.stiffness_per_height);
  if (has_circuit()) {
    const Complex per_voltage = model_->force_factor / wave.divisor;
    entry.put(kReal, places_.voltage, per_voltage);
    entry.put(kReal, places_.voltage + 1, kI * per_voltage);
    return;
  }
  const Electrical terminals = electrical(time, y);
  entry(kEnergy, kReal) = power_slope(time, terminals, 1);
  entry(kEnergy, kImaginary) = power_slope(time, terminals, kI);
}

// After the wave, of whose derivatives u' takes its share.
void Equations::add_circuit(const Entries& entry, double time) const {
  const MotionModel& m = *model_;
  const double w = omega(time), L = m.series_inductance, V = source(time).real();
  const bool coil = places_.current != StatePlaces::kNone;
  const Complex by_voltage =
      capacitive_admittance(time) + (coil ? 0.0 : 1 / m.series_resistance);  // -C_0 du' / du
  for (std::size_t in = 0; in < places_.count; ++in) {
    Complex slope = -m.force_factor * Complex{entry(kReal, in), entry(kImaginary, in)};
    if (in == kReal) slope -= m.force_factor * kI * w;
    if (in == kImaginary) slope -= m.force_factor * kI * kI * w;
    if (in == places_.voltage) slope -= by_voltage;
    if (in == places_.voltage + 1) slope -= by_voltage * kI;
    if (coil && in == places_.current) slope += 1.0;
    if (coil && in == places_.current + 1) slope += kI;
    entry.put(places_.voltage, in, slope / m.capacitance);
  }
  if (!coil) {
    entry(kEnergy, places_.voltage) = -V / m.series_resistance;
    return;
  }
  entry(kEnergy, places_.current) = V;
  const Complex per_current = -Complex{m.series_resistance, w * L} / L;
  entry.put(places_.current, places_.current, per_current);
  entry.put(places_.current, places_.current + 1, kI * per_current);
  entry.put(places_.current, places_.voltage, -1 / L);
  entry.put(places_.current, places_.voltage + 1, -kI / L);
}

void Equations::add_height(const Entries& entry, double time, std::span<const double> y) const {
  const auto [per_amplitude, per_height] = model_->normal_slopes(amplitude(time, y), height(y));
  const double mass = model_->rotor_mass;
  const Complex along = direction(zeta_of(y));
  entry(places_.height, places_.rise) = 1;
  entry(places_.rise, kReal) = along.real() * per_amplitude / mass;
  entry(places_.rise, kImaginary) = along.imag() * per_amplitude / mass;
  entry(places_.rise, places_.height) = per_height / mass;
  entry(places_.rise, places_.rise) = -model_->axial_damping / mass;
}

void Equations::add_rotor(const Entries& entry, std::span<const double> y,
                          const ContactDerivatives& contact) const {
  const double inertia = model_->inertia;
  const Complex along = direction(zeta_of(y));
  entry(kSpeed, kReal) = along.real() * contact.torque_per_amplitude / inertia;
  entry(kSpeed, kImaginary) = along.imag() * contact.torque_per_amplitude / inertia;
  entry(kSpeed, kSpeed) = (contact.torque_per_speed - model_->load_damping) / inertia;
  entry(kSpeed, kAngle) = -model_->stiffness / inertia;
  entry(kAngle, kSpeed) = 1;
  if (places_.height != StatePlaces::kNone)
    entry(kSpeed, places_.height) = contact.torque_per_height / inertia;
}

// Theta u of (M3.2) per zeta, X = -i omega Theta^2 R / (1 + R Y) with Y = i omega C_0 (1 - i tan delta), is Theta times this voltage.
Complex Equations::off_voltage_slope(double omega, const ModelSlope& q) const {
  const MotionModel& m = *model_;
  const Complex loss{1, -m.loss_tangent};
  const Complex Y = kI * omega * m.capacitance * loss;
  const Complex dY = kI * (q.omega * m.capacitance * loss + omega * q.capacitance * loss -
                           kI * omega * m.capacitance * q.loss_tangent);
  const Complex open = 1.0 + m.off_resistance * Y;
  const Complex top = -m.off_resistance * kI * omega * m.force_factor;
  const Complex dtop =
      -kI * (q.off_resistance * omega * m.force_factor +
             m.off_resistance * (q.omega * m.force_factor + omega * q.force_factor));
  return (dtop - top / open * (q.off_resistance * Y + m.off_resistance * dY)) / open;
}

// Derivative of zeta' at fixed zeta; while the drive is off, of its growth, whose imaginary part turns zeta.
Complex Equations::wave_slope(double time, std::span<const double> y,
                              const ContactGradients& contact, const ModelSlope& q) const {
  const MotionModel& m = *model_;
  const double w = omega(time), a = std::max(amplitude(time, y), contact_.floor());
  const std::size_t p = index_of(q.parameter);
  const Complex stiffness = Complex{contact.reactive_force.value, contact.active_force.value} / a;
  const Complex dstiffness =
      Complex{contact.reactive_force.gradient[p], contact.active_force.gradient[p]} / a;
  const WaveRate wave = wave_rate(time, y, stiffness);
  const double dfree =
      (q.stiffness_of_wave + dstiffness.real() - wave.free_rate * wave.free_rate * q.mass) /
      (2 * m.mass * wave.free_rate);
  const Complex ddivisor = kI * (q.mass * wave.rates + m.mass * (q.omega + dfree));
  Complex dresistance = q.stiffness_of_wave - 2 * w * m.mass * q.omega - w * w * q.mass +
                        kI * (q.omega * m.damping + w * q.damping) + dstiffness;
  if (stretch_.off) {
    dresistance -= q.force_factor * m.off_voltage(w) + m.force_factor * off_voltage_slope(w, q);
    return (-dresistance - wave.growth * ddivisor) / wave.divisor;
  }
  const Complex ddrive =
      has_circuit() ? q.force_factor * pair_at(y, places_.voltage)
                    : Complex{std::numbers::sqrt2 * (q.force_factor * stretch_.voltage.at(time) +
                                                     m.force_factor * q.voltage)};
  const Complex zeta = zeta_of(y);
  return (ddrive - dresistance * zeta - wave.of(zeta) * ddivisor) / wave.divisor;
}

// Derivatives of (M3.1) at fixed states.
// @param wave, dwave  zeta' and its derivative
Equations::CircuitRate Equations::circuit_slope(double time, std::span<const double> y,
                                                Complex wave, Complex dwave,
                                                const ModelSlope& q) const {
  const MotionModel& m = *model_;
  const double w = omega(time), L = m.series_inductance, dV = std::numbers::sqrt2 * q.voltage;
  const auto [u, I, V] = electrical(time, y);
  const CircuitRate rate = circuit_rate(time, y, wave);
  const Complex zeta = zeta_of(y), loss{1, -m.loss_tangent};
  const Complex dY = kI * (q.omega * m.capacitance * loss + w * q.capacitance * loss -
                           kI * w * m.capacitance * q.loss_tangent);
  const Complex dI = L == 0 ? (dV - I * q.series_resistance) / m.series_resistance : Complex{0, 0};
  const Complex dmotional =
      q.force_factor * (wave + kI * w * zeta) + m.force_factor * (dwave + kI * q.omega * zeta);
  const Complex voltage = (dI - dY * u - dmotional - rate.voltage * q.capacitance) / m.capacitance;
  if (L == 0) return {voltage, 0};
  const Complex dZ{q.series_resistance, q.omega * L + w * q.series_inductance};
  return {voltage, (dV - dZ * I - rate.current * q.series_inductance) / L};
}

// Derivative of the electrical power at fixed states.
double Equations::power_slope(double time, std::span<const double> y, const ModelSlope& q) const {
  const MotionModel& m = *model_;
  const double w = omega(time);
  const Complex zeta = zeta_of(y);
  const Electrical at = electrical(time, y);
  if (has_circuit()) {
    const double dV = std::numbers::sqrt2 * q.voltage;
    const Complex di = places_.current == StatePlaces::kNone
                           ? (dV - at.current * q.series_resistance) / m.series_resistance
                           : Complex{0, 0};
    return (dV * std::conj(at.current) + at.source * std::conj(di)).real();
  }
  const Complex loss{1, -m.loss_tangent};
  const Complex du =
      stretch_.off ? off_voltage_slope(w, q) * zeta : Complex{std::numbers::sqrt2 * q.voltage, 0};
  const Complex dadmittance = kI * (q.omega * m.capacitance * loss + w * q.capacitance * loss -
                                    kI * w * m.capacitance * q.loss_tangent);
  const Complex di = dadmittance * at.voltage + capacitive_admittance(time) * du +
                     kI * (q.omega * m.force_factor + w * q.force_factor) * zeta;
  return (du * std::conj(at.current) + at.voltage * std::conj(di)).real();
}

bool Equations::parameter_slopes(double time, std::span<const double> y, std::span<double> slopes) {
  std::ranges::fill(slopes, 0.0);
  const MotionModel& m = *model_;
  const double a = std::max(amplitude(time, y), contact_.floor());
  const double direction = stretch_.direction, speed = contact_speed(y[kSpeed]);
  const ContactGradients contact = slopes_->contact().at(a, direction * speed);
  if (contact.status != PointStatus::ok) return false;
  States rates{};
  if (!this->rates(time, y, rates)) return false;
  std::size_t k = 0;
  for (const ModelSlope& q : slopes_->columns()) {
    const std::span<double> column = slopes.subspan(places_.count * k++, places_.count);
    if (m.driven) {
      const Complex wave = wave_slope(time, y, contact, q);
      if (has_circuit()) {
        const auto [voltage, current] =
            circuit_slope(time, y, {rates[kReal], rates[kImaginary]}, wave, q);
        set_circuit(column, voltage, current);
      }
      const Complex rate = stretch_.off ? wave.real() * zeta_of(y) : wave;
      column[kReal] = rate.real(), column[kImaginary] = rate.imag();
      column[kTurn] = stretch_.off ? wave.imag() : 0;
      column[kEnergy] = power_slope(time, y, q);
    }
    if (!mode_.held) {
      const double torque = direction * contact.torque.gradient[index_of(q.parameter)];
      const double spring = q.stiffness * (y[kAngle] - m.neutral) - m.stiffness * q.neutral;
      column[kSpeed] = (torque - spring - q.load_damping * y[kSpeed] -
                        mode_.side * q.load_friction - rates[kSpeed] * q.inertia) /
                       m.inertia;
    }
    for (double& d : column) d *= q.scale;
  }
  return true;
}

bool Equations::events(double time, std::span<const double> y, std::span<double> values) {
  values[0] = values[1] = 1;
  if (!mode_.held) {
    values[0] = mode_.side * y[kSpeed];
    return true;
  }
  const HoldingLimits limits = holding_limits(time, y);
  if (!limits.known) return false;
  const double torque = load(time, y[kAngle]);
  values[0] = torque - limits.forward + model_->load_friction;
  values[1] = limits.backward + model_->load_friction - torque;
  return true;
}

}  // namespace twum::inline v0_1::motion
