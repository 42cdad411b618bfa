// SPDX-License-Identifier: Apache-2.0
#include "contact/collocation.hpp"

#include <cstddef>
#include <utility>

namespace twum::inline v0_1::contact {
namespace {

constexpr std::size_t kPoints = Collocation::N;

// P_N - P_(N-1) at 2 x - 1, whose zeros the points are, and its derivative.
std::pair<double, double> radau_polynomial(double x) {
  const double z = 2 * x - 1;
  double before = 1, p = z, slope_before = 0, slope = 1;
  for (std::size_t degree = 1; degree < kPoints; ++degree) {
    const auto k = static_cast<double>(degree);
    const double next = ((2 * k + 1) * z * p - k * before) / (k + 1);
    const double slope_next = slope_before + (2 * k + 1) * p;
    before = p, p = next, slope_before = slope, slope = slope_next;
  }
  return {p - before, 2 * (slope - slope_before)};
}

// The zero near x, other than 1.
double refined(double x) {
  for (int i = 0; i < 8; ++i) {
    const auto [f, slope] = radau_polynomial(x);
    x -= f / slope;
  }
  return x;
}

// Coefficients of the polynomial that is 1 at point k and 0 at the others.
Collocation::Row lagrange(const Collocation::Row& c, std::size_t k) {
  Collocation::Row poly{1};
  for (std::size_t j = 0, degree = 0; j < kPoints; ++j) {
    if (j == k) continue;
    const double scale = 1 / (c[k] - c[j]);
    ++degree;
    for (std::size_t i = degree + 1; i-- > 0;)
      poly[i] = scale * ((i > 0 ? poly[i - 1] : 0) - c[j] * (i < degree ? poly[i] : 0));
  }
  return poly;
}

}  // namespace

Collocation::Collocation() {
  place = {refined(0.057), refined(0.277), refined(0.584), refined(0.860), 1.0};
  for (std::size_t k = 0; k < kPoints; ++k) {
    const Row poly = lagrange(place, k);
    for (std::size_t i = 0; i < kPoints; ++i) {
      double sum = 0;
      for (std::size_t d = kPoints; d-- > 0;)
        sum = sum * place[i] + poly[d] / static_cast<double>(d + 1);
      integral[i][k] = sum * place[i];
    }
    constexpr double kLegendre = 70;  // leading coefficient of P_4(2 x - 1), 8! / 4!^2
    static_assert(N == 5);
    highest[k] = poly[kPoints - 1] / kLegendre;
    slope_at_end[k] = 0;
    for (std::size_t d = 1; d < kPoints; ++d) slope_at_end[k] += static_cast<double>(d) * poly[d];
  }
  rate = Factors<N>(integral).inverse();
  for (std::size_t i = 0; i < kPoints; ++i) {
    rate_of_one[i] = 0;
    for (std::size_t j = 0; j < kPoints; ++j) rate_of_one[i] += rate[i][j];
  }
  look = {0, place[0]};
  for (std::size_t i = 1; i < kPoints; ++i)
    look[2 * i] = 0.5 * (place[i - 1] + place[i]), look[2 * i + 1] = place[i];
  for (std::size_t i = 0; i < kLooks; ++i) look_weights[i] = weights_at(look[i]);
}

Collocation::Row Collocation::weights_at(double x) const {
  Row weights;
  for (std::size_t k = 0; k < kPoints; ++k) {
    weights[k] = 1;
    for (std::size_t j = 0; j < kPoints; ++j)
      if (j != k) weights[k] *= (x - place[j]) / (place[k] - place[j]);
  }
  return weights;
}

const Collocation& Collocation::points() {
  static const Collocation collocation;
  return collocation;
}

}  // namespace twum::inline v0_1::contact
