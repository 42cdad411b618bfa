// SPDX-License-Identifier: Apache-2.0
#include "model/track_pieces.hpp"

#include <twum/base/scalar_search.hpp>

namespace twum::inline v0_1::core {
namespace {

constexpr int kLooksPerMode = 16;  // a polynomial of degree 4 turns three times at most
constexpr int kLooksPerRow = 4;    // of a table: its spline turns at most twice between two rows

double zero_between(FunctionRef<double(double)> f, double low, double high) {
  return closed_in("a zero of the clearance over the track", f, {low, high, f(low), f(high)})
      .nearest();
}

}  // namespace

double clearance_slope(const DrivenMotor<double>& m, double radius, double versine) {
  return clearance(m, Dual<double, 1>::variable(radius, 0), Dual<double, 1>(0.0), versine).d[0];
}

double clearance_zero(const DrivenMotor<double>& m, double indentation, double versine, double low,
                      double high) {
  return zero_between([&](double radius) { return clearance(m, radius, indentation, versine); },
                      low, high);
}

Vector<double> radii_between_turns(const DrivenMotor<double>& m) {
  const double inner = m.r - 0.5 * m.b, outer = m.r + 0.5 * m.b;
  Vector<double> radii;
  radii.reserve(kLooksPerMode + 1);
  radii.push_back(inner);
  if (m.track.table) {
    double before = inner;
    for (const double row : m.track.table->knots()) {
      if (!(row > inner && row < outer)) continue;
      for (int i = 1; i <= kLooksPerRow; ++i)
        radii.push_back(before + (row - before) * i / kLooksPerRow);
      before = row;
    }
    for (int i = 1; i < kLooksPerRow; ++i)
      radii.push_back(before + (outer - before) * i / kLooksPerRow);
  }
  for (int i = 1; m.track.mode && i < kLooksPerMode; ++i)
    radii.push_back(inner + (outer - inner) * i / kLooksPerMode);
  radii.push_back(outer);
  Vector<double> turns;
  for (std::size_t k = 1; k < radii.size(); ++k) {
    for (const double versine : {kLiftOff, kFull}) {
      const auto slope = [&](double radius) { return clearance_slope(m, radius, versine); };
      if (slope(radii[k - 1]) * slope(radii[k]) < 0)
        turns.push_back(zero_between(slope, radii[k - 1], radii[k]));
    }
  }
  radii.insert(radii.end(), turns.begin(), turns.end());
  std::sort(radii.begin(), radii.end());
  return radii;
}

}  // namespace twum::inline v0_1::core
