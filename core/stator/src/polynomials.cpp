// SPDX-License-Identifier: Apache-2.0
#include "polynomials.hpp"

#include <twum/base/gauss_rule.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::stator {
namespace {

// Coefficients of the derivative: P_k' = (2k-1) P_{k-1} + (2k-5) P_{k-3} + ...
std::vector<double> differentiated(const std::vector<double>& series) {
  std::vector<double> result(std::max<std::size_t>(series.size(), 2) - 1, 0.0);
  for (std::size_t k = 1; k < series.size(); ++k) {
    for (std::size_t j = k; j >= 1; j -= 2) {
      result[j - 1] += series[k] * static_cast<double>(2 * j - 1);
      if (j == 1) break;
    }
  }
  return result;
}

// P_k - P_{k-2} over the root of its norm: the integral of P_{k-1}.
std::vector<double> bubble(int k) {
  std::vector<double> series(static_cast<std::size_t>(k) + 1, 0.0);
  const double scale = 1 / std::sqrt(2.0 * (2 * k - 1));
  series[static_cast<std::size_t>(k)] = scale;
  series[static_cast<std::size_t>(k) - 2] = -scale;
  return series;
}

// The integral of the integral of P_{k-2}, scaled likewise: it and its slope vanish at the ends.
std::vector<double> flat_bubble(int k) {
  std::vector<double> series(static_cast<std::size_t>(k) + 1, 0.0);
  const double j = k - 2;
  const double scale = std::sqrt((2 * j + 1) / 2);
  series[static_cast<std::size_t>(k)] = scale / ((2 * j + 1) * (2 * j + 3));
  series[static_cast<std::size_t>(k) - 2] = -scale * 2 / ((2 * j - 1) * (2 * j + 3));
  series[static_cast<std::size_t>(k) - 4] = scale / ((2 * j - 1) * (2 * j + 1));
  return series;
}

}  // namespace

Basis make_basis(Continuity continuity, int degree) {
  Basis basis{continuity, {}};
  if (continuity == Continuity::value) {
    basis.legendre = {{0.5, -0.5}, {0.5, 0.5}};
    for (int k = 2; k <= degree; ++k) basis.legendre.push_back(bubble(k));
    return basis;
  }
  // Cubic Hermite functions: value and slope at -1, value and slope at 1.
  basis.legendre = {{0.5, -0.6, 0.0, 0.1},
                    {1.0 / 6, -0.1, -1.0 / 6, 0.1},
                    {0.5, 0.6, 0.0, -0.1},
                    {-1.0 / 6, -0.1, 1.0 / 6, 0.1}};
  for (int k = 4; k <= degree; ++k) basis.legendre.push_back(flat_bubble(k));
  return basis;
}

BasisTable make_table(Continuity continuity, int degree) {
  BasisTable table{make_basis(continuity, degree), {}, {}, {}};
  // 1 / rho is not a polynomial, so there are four points more than the squares of the basis need.
  for (const GaussRule::Node& node : gauss_rule(degree + 4).nodes) {
    table.points.push_back(2 * node.place - 1);
    table.weights.push_back(2 * node.weight);
  }
  auto series = table.basis.legendre;
  for (auto& derivative : table.values) {
    for (const double x : table.points) {
      auto& row = derivative.emplace_back();
      for (const auto& function : series) row.push_back(legendre_sum(function, x));
    }
    for (auto& function : series) function = differentiated(function);
  }
  return table;
}

}  // namespace twum::inline v0_1::stator
