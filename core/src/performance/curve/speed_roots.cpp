// SPDX-License-Identifier: Apache-2.0
#include "performance/curve/speed_roots.hpp"

#include <cmath>

namespace twum::performance {

Bracket close_in(const std::function<double(double)>& f, const Bracket& ends) {
  const bool differ = (ends.at_low < 0) != (ends.at_high < 0);
  const bool tells = ends.at_low == 0 || ends.at_high == 0 ||
                     (differ && !std::isnan(ends.at_low) && !std::isnan(ends.at_high));
  if (!tells) throw SearchFailure{MetricStatus::unresolved};
  return closed_in(f, ends);
}

}  // namespace twum::performance
