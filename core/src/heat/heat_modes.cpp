// SPDX-License-Identifier: Apache-2.0
#include "heat/heat_modes.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace twum::inline v0_1::core {
namespace {

using Square = Rows3<double, kMasses>;

// One rotation of Jacobi's method, which makes a[p][q] zero; the columns of v turn with it.
void rotate(Square& a, Square& v, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = std::copysign(1, theta) / (std::fabs(theta) + std::hypot(theta, 1));
  const double c = 1 / std::hypot(t, 1), s = t * c;
  for (std::size_t k = 0; k < kMasses; ++k) {
    const double x = a[k][p], y = a[k][q];
    a[k][p] = c * x - s * y, a[k][q] = s * x + c * y;
  }
  for (std::size_t k = 0; k < kMasses; ++k) {
    const double x = a[p][k], y = a[q][k];
    a[p][k] = c * x - s * y, a[q][k] = s * x + c * y;
    const double m = v[k][p], n = v[k][q];
    v[k][p] = c * m - s * n, v[k][q] = s * m + c * n;
  }
}

// Zeros of sum of a_k exp(-mu_k t) in (0, end), the rates in rising order. Times exp(mu_0 t) its derivative is a sum of two, with
// at most one zero of its own: between it and the ends there is at most one zero each.
std::vector<double> zeros(const Masses<double>& a, const Masses<double>& mu, double end) {
  const double d1 = mu[1] - mu[0], d2 = mu[2] - mu[0];
  const auto f = [&](double t) {
    return a[0] + a[1] * std::exp(-d1 * t) + a[2] * std::exp(-d2 * t);
  };
  std::vector<double> ends{0};
  const double turn = std::log(-(d2 * a[2]) / (d1 * a[1])) / (d2 - d1);
  if (turn > 0 && turn < end) ends.push_back(turn);
  ends.push_back(end);
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Bracket b{ends[i], ends[i + 1], f(ends[i]), f(ends[i + 1])};
    if (b.at_low * b.at_high < 0)
      found.push_back(closed_in("an extremum of a temperature", f, b).nearest());
  }
  return found;
}

}  // namespace

HeatModes::HeatModes(const HeatNetwork& network)
    : matrices_(matrices_of(network)), capacities_(capacities_of(network)) {
  Square a{}, v{};
  for (std::size_t i = 0; i < kMasses; ++i) {
    v[i][i] = 1;
    for (std::size_t j = 0; j < kMasses; ++j)
      a[i][j] = matrices_.K[i][j] / std::sqrt(capacities_[i] * capacities_[j]);
  }
  constexpr int kSweeps = 12;  // it converges with the third power of what is left; five are usual
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    rotate(a, v, 0, 1), rotate(a, v, 0, 2), rotate(a, v, 1, 2);
  Masses<std::size_t> order{0, 1, 2};
  if (!network.one_node)
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return a[i][i] < a[j][j]; });
  for (std::size_t k = 0; k < kMasses; ++k) {
    rates_[k] = a[order[k]][order[k]];
    for (std::size_t i = 0; i < kMasses; ++i)
      shapes_[i][k] = v[i][order[k]] / std::sqrt(capacities_[i]);
  }
}

Masses<double> HeatModes::amplitudes(const Masses<double>& theta) const {
  Masses<double> z{};
  for (std::size_t k = 0; k < kMasses; ++k)
    for (std::size_t i = 0; i < kMasses; ++i) z[k] += shapes_[i][k] * capacities_[i] * theta[i];
  return z;
}

Masses<double> HeatModes::steady(const Sources<double>& p) const {
  Masses<double> z{};
  for (std::size_t k = 0; k < kMasses; ++k) {
    for (std::size_t i = 0; i < kMasses; ++i) z[k] += shapes_[i][k] * dot(matrices_.B[i], p);
    z[k] /= rates_[k];
  }
  return z;
}

Masses<double> HeatModes::masses(const Masses<double>& z) const {
  Masses<double> theta{};
  for (std::size_t i = 0; i < kMasses; ++i) theta[i] = dot(shapes_[i], z);
  return theta;
}

Masses<double> HeatModes::after(const Masses<double>& z, const Sources<double>& p,
                                double time) const {
  Masses<double> later = steady(p);
  for (std::size_t k = 0; k < kMasses; ++k)
    later[k] += std::exp(-rates_[k] * time) * (z[k] - later[k]);
  return later;
}

double Decay::at(double time) const {
  double value = base;
  for (std::size_t k = 0; k < kMasses; ++k) value += weights[k] * std::exp(-rates[k] * time);
  return value;
}

std::pair<double, double> Decay::range(double time) const {
  Masses<double> slopes;
  for (std::size_t k = 0; k < kMasses; ++k) slopes[k] = -rates[k] * weights[k];
  double low = std::min(at(0), at(time)), high = std::max(at(0), at(time));
  for (const double t : zeros(slopes, rates, time))
    low = std::min(low, at(t)), high = std::max(high, at(t));
  return {low, high};
}

Decay decay_of(const HeatModes& modes, std::size_t part, const Masses<double>& z,
               const Sources<double>& p) {
  const NetworkMatrices<double>& m = modes.matrices();
  const Masses<double> steady = modes.steady(p);
  Decay decay{dot(m.D[part], p), {}, modes.rates()};
  for (std::size_t k = 0; k < kMasses; ++k) {
    double weight = 0;  // of the mode in the part
    for (std::size_t i = 0; i < kMasses; ++i) weight += m.M[part][i] * modes.shape(i, k);
    decay.base += weight * steady[k];
    decay.weights[k] = weight * (z[k] - steady[k]);
  }
  return decay;
}

}  // namespace twum::inline v0_1::core
