// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/policies/policy.hpp>

namespace twum::optim {

/// Makes Boost compute in double: long double differs from machine to machine, and valgrind has none. Boost's functions
/// name both entries where they call one another, so each of them is compiled once only if both are named here. Internal.
using DoublePrecision = boost::math::policies::policy<boost::math::policies::promote_float<false>,
                                                      boost::math::policies::promote_double<false>>;

}  // namespace twum::optim
