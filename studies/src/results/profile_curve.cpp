// SPDX-License-Identifier: Apache-2.0
#include "results/profile_curve.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {

double along_profile(const std::vector<optim::ProfilePoint>& profile, double value) {
  const optim::ProfilePoint &first = profile.front(), &last = profile.back();
  if (value <= first.value) return first.z + first.slope * (value - first.value);
  if (value >= last.value) return last.z + last.slope * (value - last.value);
  std::size_t k = 0;
  while (value >= profile[k + 1].value) ++k;
  const optim::ProfilePoint &p = profile[k], &q = profile[k + 1];
  const double step = q.value - p.value, t = (value - p.value) / step, chord = (q.z - p.z) / step;
  const double sign = chord < 0 ? -1 : 1;
  const auto limited = [&](double slope) {
    return sign * std::clamp(sign * slope, 0.0, 3 * std::fabs(chord));
  };
  return (1 + 2 * t) * (1 - t) * (1 - t) * p.z + t * (1 - t) * (1 - t) * step * limited(p.slope) +
         t * t * (3 - 2 * t) * q.z + t * t * (t - 1) * step * limited(q.slope);
}

double value_at_part(const CalibrateResult::Estimate& e, double part) {
  const double value = e.parameter.value, end = part < 0 ? e.low : e.high;
  const double share = std::fabs(part);
  if (share == 0 || share == 1 || end == value) return share == 0 ? value : end;
  const bool rises = e.profile.size() > 1 && along_profile(e.profile, end) != 0;
  if (!rises) return e.log ? value * std::pow(end / value, share) : std::lerp(value, end, share);
  const double sought = share * along_profile(e.profile, end);
  const auto excess = [&](double at) { return along_profile(e.profile, at) - sought; };
  const auto [low, high] = std::minmax(value, end);
  return closed_in("the value of a parameter along its profile", excess,
                   {low, high, excess(low), excess(high)})
      .nearest();
}

}  // namespace twum::studies
