// SPDX-License-Identifier: Apache-2.0
#include "plate_modes.hpp"
#include "plate_solver.hpp"
#include "quantity_text.hpp"

#include <twum/base/dual.hpp>
#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::stator {

namespace {

template <typename S>
S function_at(const std::vector<RadialFunction::Piece>& pieces, const S& radius) {
  if (pieces.empty()) return S(0.0);
  const auto beyond = std::find_if(
      pieces.begin(), pieces.end() - 1,
      [&](const RadialFunction::Piece& piece) { return value_of(radius) <= piece.outer; });
  const double middle = 0.5 * (beyond->inner + beyond->outer);
  const S x = (radius - middle) / (0.5 * (beyond->outer - beyond->inner));
  return legendre_sum(beyond->coefficients, x);
}

}  // namespace

double RadialFunction::operator()(double radius) const { return function_at(pieces_, radius); }

double RadialFunction::slope(double radius) const {
  return function_at(pieces_, Dual<double, 1>::variable(radius, 0)).d[0];
}

int RadialFunction::sign_changes(double inner, double outer) const {
  // The lowest modes have few zeros, and an edge layer is wider than the 400th part of a plate.
  constexpr int kSamples = 400;
  std::vector<double> values;
  double largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    values.push_back((*this)(inner + (outer - inner) * i / kSamples));
    largest = std::max(largest, std::abs(values.back()));
  }
  std::erase_if(values, [&](double value) { return std::abs(value) <= 1e-6 * largest; });
  int changes = 0;
  for (std::size_t i = 1; i < values.size(); ++i) changes += values[i] * values[i - 1] < 0;
  return changes;
}

RadialFunction deflection(const Mesh& mesh, const std::vector<Segment>& segments,
                          const std::vector<double>& coefficients) {
  std::vector<RadialFunction::Piece> pieces;
  for (const Element& element : mesh.elements) {
    const Segment& segment = segments[element.segment];
    const double width = segment.outer - segment.inner;
    const double inner = segment.inner + width * element.from;
    const double outer = segment.inner + width * element.to;
    pieces.push_back(
        {inner, outer, legendre_series(element, 0, 0.5 * (outer - inner), coefficients)});
  }
  return RadialFunction(std::move(pieces));
}

double frequency_of(double eigenvalue, const std::vector<Segment>& segments) {
  if (eigenvalue <= 1e-6 * unit_eigenvalue(segments)) return 0;
  return std::sqrt(eigenvalue) / (2 * std::numbers::pi);
}

namespace {

void check(const std::vector<Segment>& segments, PlateTheory theory, int nodal_diameters,
           int count) {
  if (segments.empty()) throw InputError("plate: no segment; at least one is needed");
  if (nodal_diameters < 0) {
    throw InputError("plate: " + std::to_string(nodal_diameters) +
                     " nodal diameters; the number must be 0 or more");
  }
  if (count < 1)
    throw InputError("plate: " + std::to_string(count) + " modes asked for; ask for 1 or more");
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const std::string name = "plate: segment " + std::to_string(i + 1);
    if (!(s.inner > 0 && s.outer > s.inner && std::isfinite(s.outer))) {
      throw InputError(name + " reaches from " + quantity_text(s.inner, "m") + " to " +
                       quantity_text(s.outer, "m") + "; it needs 0 < inner < outer");
    }
    if (i > 0 && s.inner != segments[i - 1].outer) {
      throw InputError(name + " begins at " + quantity_text(s.inner, "m") +
                       "; it must begin where the one before ends, at " +
                       quantity_text(segments[i - 1].outer, "m"));
    }
    const Section& section = s.section;
    if (!(section.bending_stiffness > 0 && section.mass > 0 && section.shear_stiffness > 0 &&
          section.rotary_inertia >= 0 && std::abs(section.poisson_ratio) < 1)) {
      throw InputError(name +
                       ": bending stiffness, shear stiffness and mass must be above 0, rotary "
                       "inertia at least 0, and Poisson's ratio between -1 and 1");
    }
    if (theory == PlateTheory::mindlin && section.rotary_inertia == 0) {
      throw InputError(name + ": Mindlin's plate needs a rotary inertia above 0");
    }
  }
}

}  // namespace

std::vector<PlateMode> plate_modes(const std::vector<Segment>& segments, PlateTheory theory,
                                   InnerEdge inner_edge, int nodal_diameters, int count) {
  check(segments, theory, nodal_diameters, count);
  const Mesh mesh = make_mesh(segments, theory, inner_edge, nodal_diameters);
  const Spectrum spectrum = solve(mesh, segments, count);
  std::vector<PlateMode> modes;
  for (std::size_t i = 0; i < spectrum.vectors.size(); ++i) {
    RadialFunction shape = deflection(mesh, segments, spectrum.vectors[i]);
    const int circles = shape.sign_changes(segments.front().inner, segments.back().outer);
    modes.push_back({frequency_of(spectrum.eigenvalues[i], segments), std::move(shape), circles});
  }
  return modes;
}

const char* to_string(PlateTheory value) noexcept {
  switch (value) {
    case PlateTheory::mindlin: return "mindlin";
    case PlateTheory::kirchhoff: return "kirchhoff";
  }
  return "unknown";
}

const char* to_string(InnerEdge value) noexcept {
  switch (value) {
    case InnerEdge::free: return "free";
    case InnerEdge::clamped: return "clamped";
    case InnerEdge::supported: return "supported";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::stator
