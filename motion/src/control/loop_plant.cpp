// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/control.hpp>

#include <Eigen/Core>
#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace twum::motion {
namespace {

constexpr std::size_t kSpeedState = 2;
constexpr Eigen::Index kLoopStates = 4, kAngleRow = 3;

std::size_t input_of(Actuator actuator) { return actuator == Actuator::voltage ? 0 : 1; }

// x1 = Phi x + Gamma u over a sample with a held input u; angle, speed, phase and amplitude in units of their sizes.
struct SampledPlant {
  Eigen::Matrix4d phi;
  Eigen::Vector4d gamma;

  SampledPlant(const LinearPlant& plant, Actuator actuator, double sample_time) {
    Eigen::Vector4d unit;
    unit << plant.states[0].steady, 1, plant.states[2].steady, 1;
    Eigen::Matrix<double, 5, 5> joint = Eigen::Matrix<double, 5, 5>::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < 4; ++j) {
        const auto column = static_cast<Eigen::Index>(j);
        joint(row, column) = plant.a[i][j] * unit[column] / unit[row];
      }
      joint(row, 4) = plant.b[i][input_of(actuator)] / unit[row];
    }
    const Eigen::Matrix<double, 5, 5> sampled = (joint * sample_time).exp();
    phi = sampled.topLeftCorner<4, 4>();
    gamma = sampled.topRightCorner<4, 1>();
  }

  // Of the speed as a difference of angles, (1 - 1/z) / T_s times the angle's.
  std::complex<double> speed(std::complex<double> z, double sample_time) const {
    const Eigen::Matrix4cd left =
        z * Eigen::Matrix4cd::Identity() - phi.cast<std::complex<double>>();
    const Eigen::Vector4cd x = left.partialPivLu().solve(gamma.cast<std::complex<double>>());
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

}  // namespace

LoopPlant loop_plant(const LinearPlant& plant, Actuator actuator) {
  const std::size_t input = input_of(actuator);
  return {plant.inputs[input].steady, plant.states[kSpeedState].steady,
          plant.gains[kSpeedState][input], 1 / std::abs(plant.poles.front().real()), plant.poles};
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

}  // namespace twum::motion
