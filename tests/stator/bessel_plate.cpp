// SPDX-License-Identifier: Apache-2.0
#include "stator/bessel_plate.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace twum::test {
namespace {

// w, w', w'', w''' with respect to rho of one solution on a ring.
using Jet = std::array<double, 4>;

// Z_n and Z_{n+1} of a kind of Bessel function. I and K are scaled by e^-x0 and e^x0: columns of the
// determinant may have any factor.
struct Pair {
  double value;
  double next;
};
using Kind = std::function<Pair(int n, double x, double x0)>;

const std::array<Kind, 4>& kinds() {
  static const std::array<Kind, 4> all{
      [](int n, double x, double) {
        return Pair{gsl_sf_bessel_Jn(n, x), gsl_sf_bessel_Jn(n + 1, x)};
      },
      [](int n, double x, double) {
        return Pair{gsl_sf_bessel_Yn(n, x), gsl_sf_bessel_Yn(n + 1, x)};
      },
      [](int n, double x, double x0) {
        const double e = std::exp(x - x0);
        return Pair{gsl_sf_bessel_In_scaled(n, x) * e, gsl_sf_bessel_In_scaled(n + 1, x) * e};
      },
      [](int n, double x, double x0) {
        const double e = std::exp(x0 - x);
        return Pair{gsl_sf_bessel_Kn_scaled(n, x) * e, gsl_sf_bessel_Kn_scaled(n + 1, x) * e};
      }};
  return all;
}

// Bessel's equation x^2 Z'' + x Z' - (n^2 -+ x^2) Z = 0 gives the second derivative, its derivative the third.
Jet jet(std::size_t kind, int n, double wave_number, double radius, double x0) {
  const double x = wave_number * radius;
  const auto [z, next] = kinds()[kind](n, x, x0);
  const double sign = kind < 2 ? 1 : -1;  // Z'' + Z'/x + (sign - n^2/x^2) Z = 0
  const double first = n * z / x + (kind == 2 ? next : -next);
  const double second = -first / x - (sign - n * n / (x * x)) * z;
  const double third = -second / x + first / (x * x) - (sign - n * n / (x * x)) * first -
                       2.0 * n * n / (x * x * x) * z;
  const double k = wave_number;
  return {z, k * first, k * k * second, k * k * k * third};
}

// Deflection, slope, radial moment and effective shear force of cos(n phi).
std::array<double, 4> edge_quantities(const Jet& w, const stator::Section& s, int n, double r) {
  const double nu = s.poisson_ratio;
  const double n2 = n * n;
  const double moment = w[2] + nu * (w[1] / r - n2 * w[0] / (r * r));
  const double laplacian_slope =
      w[3] + w[2] / r - w[1] / (r * r) - n2 * w[1] / (r * r) + 2 * n2 * w[0] / (r * r * r);
  const double twist = w[1] / r - w[0] / (r * r);
  const double shear = laplacian_slope - (1 - nu) * n2 / r * twist;
  return {w[0], w[1], s.bending_stiffness * moment, s.bending_stiffness * shear};
}

// Sign and size of the determinant of all conditions, rows and columns scaled to 1.
double determinant(const std::vector<stator::Segment>& segments, stator::InnerEdge edge, int n,
                   double omega) {
  const auto count = static_cast<Eigen::Index>(4 * segments.size());
  Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(count, count);
  const std::array<std::size_t, 2> inner_rows =
      edge == stator::InnerEdge::free      ? std::array<std::size_t, 2>{2, 3}
      : edge == stator::InnerEdge::clamped ? std::array<std::size_t, 2>{0, 1}
                                           : std::array<std::size_t, 2>{0, 2};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& segment = segments[i];
    const double k =
        std::sqrt(omega * std::sqrt(segment.section.mass / segment.section.bending_stiffness));
    for (std::size_t kind = 0; kind < 4; ++kind) {
      const double x0 = kind == 3 ? k * segment.inner : k * segment.outer;
      const auto at = [&](double r) {
        return edge_quantities(jet(kind, n, k, r, x0), segment.section, n, r);
      };
      const auto column = static_cast<Eigen::Index>(4 * i + kind);
      const auto inner = at(segment.inner);
      const auto outer = at(segment.outer);
      for (std::size_t q = 0; q < 4; ++q) {
        if (i > 0) conditions(static_cast<Eigen::Index>(4 * i - 2 + q), column) = -inner[q];
        if (i + 1 < segments.size())
          conditions(static_cast<Eigen::Index>(4 * i + 2 + q), column) = outer[q];
      }
      for (std::size_t q = 0; q < 2; ++q) {
        if (i == 0) conditions(static_cast<Eigen::Index>(q), column) = inner[inner_rows[q]];
        if (i + 1 == segments.size())
          conditions(count - 2 + static_cast<Eigen::Index>(q), column) = outer[2 + q];
      }
    }
  }
  for (Eigen::Index row = 0; row < count; ++row) conditions.row(row) /= conditions.row(row).norm();
  for (Eigen::Index column = 0; column < count; ++column) {
    conditions.col(column) /= conditions.col(column).norm();
  }
  return conditions.determinant();
}

}  // namespace

std::vector<double> exact_thin_plate(const std::vector<stator::Segment>& segments,
                                     stator::InnerEdge inner_edge, int nodal_diameters, int count) {
  // In units of the outer segment, lambda = sqrt(omega r^2 sqrt(m/D)); zeros of the determinant are a good
  // part of pi / (1 - b/a) apart, and the lowest is above 1.
  const auto& last = segments.back();
  const double unit =
      std::sqrt(last.section.bending_stiffness / last.section.mass) / (last.outer * last.outer);
  const auto value = [&](double lambda) {
    return determinant(segments, inner_edge, nodal_diameters, unit * lambda * lambda);
  };
  std::vector<double> frequencies;
  constexpr double kStep = 0.03;
  double low = 0.9;
  double at_low = value(low);
  while (static_cast<int>(frequencies.size()) < count) {
    double high = low + kStep;
    const double at_high = value(high);
    if (at_low * at_high < 0) {
      double a = low;
      double b = high;
      while (b - a > 1e-13 * b) {
        const double middle = 0.5 * (a + b);
        (value(middle) * at_low > 0 ? a : b) = middle;
        if (middle == a && middle == b) break;
      }
      frequencies.push_back(unit * a * a / (2 * std::numbers::pi));
    }
    low = high;
    at_low = at_high;
    if (low > 400) throw std::runtime_error("exact_thin_plate: no root");
  }
  return frequencies;
}

}  // namespace twum::test
