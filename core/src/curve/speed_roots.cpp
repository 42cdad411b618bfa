// SPDX-License-Identifier: Apache-2.0
#include "curve/speed_roots.hpp"

#include <twum/base/error.hpp>

namespace twum::inline v0_1::core {

Bracket close_in(FunctionRef<double(double)> f, const Bracket& ends) {
  try {
    return closed_in("a speed on the torque-speed curve", f, ends);
  } catch (const EvaluationError&) {
    throw SearchFailure{MetricStatus::unresolved};
  }
}

}  // namespace twum::inline v0_1::core
