// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/policies/policy.hpp>

namespace twum::studies {

// Makes Boost's distributions compute in double. By default they use long double, which differs between machines, and
// which valgrind does not support: the program would end when Boost initializes its constants. Boost's functions name both
// entries where they call one another, so each of them is compiled once only if both are named here.
using DoublePrecision = boost::math::policies::policy<boost::math::policies::promote_float<false>,
                                                      boost::math::policies::promote_double<false>>;

}  // namespace twum::studies
