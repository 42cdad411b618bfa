// SPDX-License-Identifier: Apache-2.0
#include "performance/speed_roots.hpp"

#include <boost/math/tools/toms748_solve.hpp>

namespace twum::performance {

Bracket close_in(const std::function<double(double)>& f, double low, double high, double f_low,
                 double f_high) {
  if (f_low == 0) return {low, low};
  if (f_high == 0) return {high, high};
  if (!((f_low < 0) != (f_high < 0)) || std::isnan(f_low) || std::isnan(f_high)) {
    throw SearchFailure{MetricStatus::unresolved};
  }
  boost::uintmax_t limit = 120;
  const auto found = boost::math::tools::toms748_solve(
      f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>(51), limit);
  return {found.first, found.second};
}

}  // namespace twum::performance
