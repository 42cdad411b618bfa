// SPDX-License-Identifier: Apache-2.0
#include "curve/goal.hpp"

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

constexpr double kLastTurn = 0.01;  // share of an interval
constexpr double kBend = 1e-4;  // of value per crest speed: more than a slope changes in a bracket

}  // namespace

std::size_t GoalCurve::highest(const Vector<CurvePoint>& nodes) const {
  std::size_t top = 0;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (value(nodes[k]) > value(nodes[top])) top = k;
  }
  return top;
}

std::optional<Peak> GoalCurve::peak_between(double low, double high) const {
  const std::optional<Bracket> ends = slope_bracket(low, high);
  if (!ends) return {};
  const Bracket b = close_in([this](double speed) { return at(speed).slope; }, *ends);
  const Sloped left = at(b.low), right = at(b.high);
  const double scale = std::fabs(left.value) / points_.curve().crest();
  const PeakKind kind =
      left.slope - right.slope > kBend * scale ? PeakKind::kink : PeakKind::smooth;
  return left.value >= right.value ? Peak{b.low, left.value, kind}
                                   : Peak{b.high, right.value, kind};
}

// Speeds between which the slope goes from + to -, as far apart as it seems.
std::optional<Bracket> GoalCurve::slope_bracket(double low, double high) const {
  if (!(low < high)) return {};
  Sloped at_low = at(low), at_high = at(high);
  if (!(at_low.slope > 0)) return {};
  // A zone about to vanish may turn the slope up at the very end.
  if (!(at_high.slope < 0) && !(at_high.value < at_low.value)) {
    high -= kLastTurn * (high - low);
    at_high = at(high);
    if (!(at_high.slope < 0)) return {};
  }
  // A dip behind the maximum can hide it: halve towards the higher side.
  for (int i = 0; i < 50 && !(at_high.slope < 0); ++i) {
    const double middle = 0.5 * (low + high);
    const Sloped s = at(middle);
    const bool beyond = s.slope < 0 || s.value < at_low.value;
    (beyond ? high : low) = middle;
    (beyond ? at_high : at_low) = s;
  }
  if (!(at_high.slope < 0)) return {};
  return Bracket{low, high, at_low.slope, at_high.slope};
}

Peak GoalCurve::peak_at(const CurvePoint& p, PeakKind inside) const {
  const double begin = points_.curve().begin();
  const PeakKind of_begin = begin == 0 ? PeakKind::rest : PeakKind::kink;
  return {p.speed, value(p), p.speed > begin ? inside : of_begin};
}

}  // namespace twum::inline v0_1::core
