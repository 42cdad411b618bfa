// SPDX-License-Identifier: Apache-2.0
#include "design/radial_shape.hpp"

#include <cstdio>

namespace twum::inline v0_1 {
namespace {

using Rows = std::vector<std::pair<double, double>>;

constexpr std::size_t kFewestRows = 4;  // a not-a-knot spline of four rows is one cubic
constexpr int kSampledRadii = 64;  // number of radii at which a table's spline has to be positive

std::string millimetres(double length) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g mm", 1e3 * length);
  return text;
}

std::string shown_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string range_text(double low, double high) {
  return millimetres(low) + " to " + millimetres(high);
}

std::string row_complaint(const Rows& rows) {
  if (rows.size() < kFewestRows)
    return "needs at least 4 rows, but has " + std::to_string(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& [radius, shape] = rows[k];
    const std::string row = "row " + std::to_string(k + 1);
    if (!std::isfinite(radius) || !std::isfinite(shape)) return row + " must be finite numbers";
    if (k > 0 && !(radius > rows[k - 1].first))
      return row + " must have a larger radius than the row before, " +
             millimetres(rows[k - 1].first) + ", but has " + millimetres(radius);
  }
  return {};
}

std::string table_complaint(const Rows& rows, double inner, double outer) {
  const std::string wrong = row_complaint(rows);
  if (!wrong.empty()) return wrong;
  const double slack = 1e-12 * outer;  // rounding of sums and differences of radii
  if (rows.front().first > inner + slack || rows.back().first < outer - slack)
    return "must cover the contact track, " + range_text(inner, outer) + ", but covers " +
           range_text(rows.front().first, rows.back().first);
  const ShapeSpline spline(rows);
  for (int i = 0; i <= kSampledRadii; ++i) {
    const double radius = inner + (outer - inner) * i / kSampledRadii, shape = spline.at(radius);
    if (!(shape > 0))
      return "must be positive on the contact track, but is " + shown_number(shape) + " at " +
             millimetres(radius);
  }
  return {};
}

}  // namespace

// Continuity of the first derivative at the inner rows, and of the third at the second row and the last but one:
// with m_0 and m_n expressed by their neighbours a tridiagonal system for the others is left, solved by elimination.
ShapeSpline::ShapeSpline(const Rows& rows) : m_(rows.size()) {
  for (const auto& [radius, shape] : rows) x_.push_back(radius), y_.push_back(shape);
  const std::size_t n = rows.size() - 1;
  const auto h = [this](std::size_t k) { return x_[k + 1] - x_[k]; };
  const auto slope = [&](std::size_t k) { return (y_[k + 1] - y_[k]) / h(k); };
  std::vector<double> diagonal(n), upper(n), right(n);
  for (std::size_t k = 1; k < n; ++k) {
    double low = h(k - 1);
    diagonal[k] = 2 * (h(k - 1) + h(k)), upper[k] = h(k);
    right[k] = 6 * (slope(k) - slope(k - 1));
    if (k == 1) {
      const double ratio = h(0) / h(1);
      diagonal[k] += h(0) * (1 + ratio), upper[k] -= h(0) * ratio;
    }
    if (k == n - 1) {
      const double ratio = h(n - 1) / h(n - 2);
      diagonal[k] += h(n - 1) * (1 + ratio), low -= h(n - 1) * ratio;
    }
    if (k > 1) {
      const double factor = low / diagonal[k - 1];
      diagonal[k] -= factor * upper[k - 1], right[k] -= factor * right[k - 1];
    }
  }
  for (std::size_t k = n - 1; k >= 1; --k)
    m_[k] = (right[k] - (k < n - 1 ? upper[k] * m_[k + 1] : 0)) / diagonal[k];
  m_[0] = m_[1] + h(0) / h(1) * (m_[1] - m_[2]);
  m_[n] = m_[n - 1] + h(n - 1) / h(n - 2) * (m_[n - 1] - m_[n - 2]);
}

std::string track_complaint(const MotorDesign& design) {
  const Stator& stator = design.stator;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width,
               outer = stator.contact_radius + 0.5 * stator.contact_width;
  if (!(inner > 0))
    return "contact_width must be less than twice the contact_radius = " +
           millimetres(stator.contact_radius) + ", but is " + millimetres(stator.contact_width);
  const RadialShape& shape = stator.radial_shape;
#ifndef __wasm__  // a page leaves radial motion out
  if (stator.radial_motion && !has_radial_shape(design))
    return "radial_motion needs the wave's radial shape, by radial_shape or geometry, but is true "
           "without one";
#endif
  if ((stator.radial_slices == 1 && !stator.radial_motion) || stator.geometry) return {};
  if (!shape.table.empty()) {
    const std::string wrong = table_complaint(shape.table, inner, outer);
    return wrong.empty() ? wrong : "radial_shape.table " + wrong;
  }
  if (shape.root >= inner && shape.root <= outer)
    return "shape_root must lie outside the contact track, " + range_text(inner, outer) +
           ", but is " + millimetres(shape.root);
  return {};
}

}  // namespace twum::inline v0_1
