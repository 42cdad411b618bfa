// SPDX-License-Identifier: Apache-2.0
#include "force_factor.hpp"

#include <cmath>

namespace twum::inline v0_1::solid {
namespace {

using Vector = std::array<double, 3>;
using Complex = std::complex<double>;

// Gauss's rule of three points on [-1, 1].
constexpr double kPoint = 0.77459666924148337704;  // sqrt(3 / 5)
constexpr std::array kPoints{-kPoint, 0.0, kPoint};
constexpr std::array kWeights{5.0 / 9, 8.0 / 9, 5.0 / 9};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A node's shape function at one place.
struct Shape {
  double value;
  Vector slopes;  // along the three directions of the brick
};

// With x from -1 to 1 and the node at c in each direction, a corner has
// N = (1 + x1 c1) (1 + x2 c2) (1 + x3 c3) (x1 c1 + x2 c2 + x3 c3 - 2) / 8. The middle of an edge has c = 0 in one direction:
// there the factor is 1 - x^2, the last factor is left out, and the quotient is 4.
Shape shape_of(std::size_t node, const Vector& x) {
  Vector c{}, factor{}, slope{};
  bool corner = true;
  double last = -2;
  for (std::size_t d = 0; d < 3; ++d) {
    c[d] = brick_places()[node][d] - 1;
    const bool middle = c[d] == 0;
    corner = corner && !middle;
    factor[d] = middle ? 1 - x[d] * x[d] : 1 + x[d] * c[d];
    slope[d] = middle ? -2 * x[d] : c[d];
    last += x[d] * c[d];
  }
  const double product = factor[0] * factor[1] * factor[2];
  Shape shape{corner ? product * last / 8 : product / 4, {}};
  for (std::size_t d = 0; d < 3; ++d) {
    const double others = factor[(d + 1) % 3] * factor[(d + 2) % 3];
    shape.slopes[d] =
        corner ? others * (slope[d] * last + factor[d] * c[d]) / 8 : others * slope[d] / 4;
  }
  return shape;
}

// (d u_x / dx + d u_y / dy) e^(-i n phi) at one place of a brick, times the volume there over that of the brick's directions.
Complex stretch_at(const Sector& sector, int n, const Eigenmode& mode, const SectorBrick& brick,
                   const Vector& x) {
  std::array<Vector, 3> along{};              // d position / d x_d
  std::array<std::array<Complex, 2>, 3> u{};  // d (u_x, u_y) / d x_d
  Vector at{};
  for (std::size_t a = 0; a < brick.nodes.size(); ++a) {
    const auto index = static_cast<std::size_t>(brick.nodes[a]);
    const SectorNode& node = sector.nodes[index];
    const double c = std::cos(node.angle), s = std::sin(node.angle);
    const Vector place{node.radius * c, node.radius * s, node.height};
    const auto& motion = mode.motion[index];
    const Shape shape = shape_of(a, x);
    for (std::size_t d = 0; d < 3; ++d) {
      at[d] += shape.value * place[d];
      for (std::size_t k = 0; k < 3; ++k) along[d][k] += shape.slopes[d] * place[k];
      u[d][0] += shape.slopes[d] * (c * motion[0] - s * motion[1]);
      u[d][1] += shape.slopes[d] * (s * motion[0] + c * motion[1]);
    }
  }
  // The gradient of x_d, times the determinant, is the cross product of the other two directions.
  Complex stretch = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const Vector gradient = cross(along[(d + 1) % 3], along[(d + 2) % 3]);
    stretch += gradient[0] * u[d][0] + gradient[1] * u[d][1];
  }
  return stretch * std::polar(1.0, -n * std::atan2(at[1], at[0]));
}

Complex stretch_of(const Sector& sector, int n, const Eigenmode& mode, const SectorBrick& brick) {
  Complex sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        sum += kWeights[i] * kWeights[j] * kWeights[k] *
               stretch_at(sector, n, mode, brick, {kPoints[i], kPoints[j], kPoints[k]});
  return sum;
}

}  // namespace

Complex ceramic_stretch(const Sector& sector, int nodal_diameters, const Eigenmode& mode,
                        double inner, double outer) {
  Complex sum = 0;
  for (const SectorBrick& brick : sector.bricks) {
    const auto line = static_cast<std::size_t>(brick.place[0] / 2);
    const double radius = 0.5 * (sector.radii[line] + sector.radii[line + 1]);
    if (brick.part == Part::ceramic && radius > inner && radius < outer)
      sum += stretch_of(sector, nodal_diameters, mode, brick);
  }
  return sum;
}

}  // namespace twum::inline v0_1::solid
