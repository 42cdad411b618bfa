// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/control.hpp>

#include <Eigen/Core>
#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

constexpr std::size_t kSpeedState = 2;
constexpr Eigen::Index kAngleRow = 3;
constexpr std::size_t kSlowPoles = 3;  // of wave and rotor; those of a driver's circuit are faster

std::size_t input_of(Actuator actuator) { return actuator == Actuator::voltage ? 0 : 1; }

// x1 = Phi x + Gamma u over a sample with a held input u; angle, speed, phase and amplitude in units of their sizes.
struct SampledPlant {
  Eigen::MatrixXd phi;
  Eigen::VectorXd gamma;

  SampledPlant(const LinearPlant& plant, Actuator actuator, double sample_time) {
    const auto states = static_cast<Eigen::Index>(plant.states.size());
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(states);
    unit[0] = plant.states[0].steady, unit[2] = plant.states[2].steady;
    Eigen::MatrixXd joint = Eigen::MatrixXd::Zero(states + 1, states + 1);
    for (Eigen::Index row = 0; row < states; ++row) {
      const auto i = static_cast<std::size_t>(row);
      for (Eigen::Index column = 0; column < states; ++column)
        joint(row, column) =
            plant.a[i][static_cast<std::size_t>(column)] * unit[column] / unit[row];
      joint(row, states) = plant.b[i][input_of(actuator)] / unit[row];
    }
    const Eigen::MatrixXd sampled = (joint * sample_time).exp();
    phi = sampled.topLeftCorner(states, states);
    gamma = sampled.topRightCorner(states, 1);
  }

  // Of the speed as a difference of angles, (1 - 1/z) / T_s times the angle's.
  std::complex<double> speed(std::complex<double> z, double sample_time) const {
    const Eigen::MatrixXcd left =
        z * Eigen::MatrixXcd::Identity(phi.rows(), phi.cols()) - phi.cast<std::complex<double>>();
    const Eigen::VectorXcd x = left.partialPivLu().solve(gamma.cast<std::complex<double>>());
    return (1.0 - 1.0 / z) / sample_time * x[kAngleRow];
  }
};

// Where a function of the frequency passes zero between two frequencies.
double crossing(double low, double high, const std::function<double(double)>& of) {
  const bool rises = of(low) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    ((of(middle) < 0) == rises ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

// Largest real part of the three poles next to zero.
double slowest_rate(std::vector<std::complex<double>> poles) {
  std::ranges::sort(poles, {}, [](const std::complex<double>& p) { return std::abs(p); });
  poles.resize(std::min(poles.size(), kSlowPoles));
  return std::abs(std::ranges::max(poles, {}, [](const auto& p) { return p.real(); }).real());
}

}  // namespace

LoopPlant loop_plant(const LinearPlant& plant, Actuator actuator) {
  const std::size_t input = input_of(actuator);
  return {plant.inputs[input].steady, plant.states[kSpeedState].steady,
          plant.gains[kSpeedState][input], 1 / slowest_rate(plant.poles), plant.poles};
}

LoopGains loop_gains(const LoopPlant& plant, double sample_time, int delay) {
  const double dead_time = (delay + 1) * sample_time;  // theta_d
  const double closed = 2 * dead_time;                 // lambda
  // kp = tau / (K (lambda + theta_d)), ki = 1 / (K (lambda + theta_d))  (M8.1)
  const double per_output = plant.gain * (closed + dead_time);
  return {plant.time_constant / per_output, 1 / per_output};
}

// L(z) = C(z) z^-delay P(z), C(z) = kp + ki T_s z / (z - 1).
LoopMargins loop_margins(const LinearPlant& plant, const SpeedControl& control,
                         const LoopGains& gains) {
  const double sample = control.sample_time;
  const SampledPlant sampled(plant, control.actuator, sample);
  const auto loop = [&](double omega) {
    const std::complex<double> z = std::polar(1.0, omega * sample);
    const std::complex<double> controller =
        gains.proportional + gains.integral * sample * z / (z - 1.0);
    return controller * std::pow(z, -control.delay) * sampled.speed(z, sample);
  };
  const auto size = [&](double omega) { return std::abs(loop(omega)) - 1; };
  const auto imaginary = [&](double omega) { return loop(omega).imag(); };
  constexpr double kNone = std::numeric_limits<double>::infinity();
  LoopMargins margins{kNone, kNone, 0};
  // The loop's own angle turns by a few turns up to half of the sampling rate: 2000 steps of 0.5 % miss no crossing that counts.
  const double end = std::numbers::pi / sample;
  constexpr int kSteps = 2000;
  double before = end * 1e-4;
  for (int k = 1; k <= kSteps; ++k) {
    const double here = end * std::pow(1e-4, 1 - static_cast<double>(k) / kSteps);
    if ((size(before) < 0) != (size(here) < 0)) {
      const double omega = crossing(before, here, size);
      margins.phase = std::min(margins.phase, std::numbers::pi - std::abs(std::arg(loop(omega))));
      margins.crossover = omega / (2 * std::numbers::pi);
    }
    if ((imaginary(before) < 0) != (imaginary(here) < 0)) {
      const double omega = crossing(before, here, imaginary);
      const double real = loop(omega).real();
      if (real < 0) margins.gain = std::min(margins.gain, -1 / real);
    }
    before = here;
  }
  // Half of the sampling rate, where the loop is real.
  const double last = loop(end).real();
  if (last < 0) margins.gain = std::min(margins.gain, -1 / last);
  return margins;
}

}  // namespace twum::inline v0_1::motion
