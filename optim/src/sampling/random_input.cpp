// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/random_input.hpp>

#include <algorithm>
#include <cmath>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kMostDeviations = 8.2;

struct Offset {
  double value{0.0};
  double by_normal{0.0};
};

// t(Phi(z)) of U1.4, by the smaller of the two tails.
Offset triangular_offset(double below, double above, double z) {
  const double width = below + above;
  const bool lower = normal_cdf(z) * width <= below;
  const double side = lower ? below : above;
  const double root = std::sqrt(normal_cdf(lower ? z : -z) * side * width);
  const double slope = root > 0.0 ? 0.5 * side * width / root * normal_density(z) : 0.0;
  return {lower ? root - side : side - root, slope};
}

// P - x for x = 1 (relative) or any x (absolute), U1.1, U1.3, U1.4.
Offset offset(const RandomInput& input, double z) {
  switch (input.law) {
    case Law::uniform:
      return {input.spread * std::erf(z / std::sqrt(2.0)), 2.0 * input.spread * normal_density(z)};
    case Law::triangular: return triangular_offset(input.spread, input.above, z);
    case Law::normal:
    case Law::lognormal:
    case Law::given: break;
  }
  return {input.spread * z, input.spread};
}

// U1.2 and its derivatives.
BuiltValue lognormal(const RandomInput& input, double x, double z) {
  const double ratio = input.relative ? input.spread : input.spread / x;
  const double square = ratio * ratio;
  const double sigma = std::sqrt(std::log1p(square));
  const double by_log_ratio = square / (sigma * (1.0 + square));  // ratio times dsigma/dratio
  const double value = x * std::exp(sigma * z - 0.5 * sigma * sigma);
  const double by_spread = value * (z - sigma) * by_log_ratio;
  const double by_design = (input.relative ? value : value - by_spread) / x;
  return {value, by_design, sigma * value, by_spread};
}

}  // namespace

BuiltValue RandomInput::at(double design, double z) const {
  z = std::clamp(z, -kMostDeviations, kMostDeviations);
  if (law == Law::given) return transform(z);
  if (law == Law::lognormal) return lognormal(*this, design, z);
  const Offset o = offset(*this, z);
  const double scale = relative ? design : 1.0;
  const double deviation = scale * o.value;
  return {design + deviation, relative ? 1.0 + o.value : 1.0, scale * o.by_normal, deviation};
}

const char* to_string(Law value) noexcept {
  switch (value) {
    case Law::normal: return "normal";
    case Law::lognormal: return "lognormal";
    case Law::uniform: return "uniform";
    case Law::triangular: return "triangular";
    case Law::given: return "given";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
