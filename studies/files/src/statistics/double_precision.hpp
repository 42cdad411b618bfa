// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/policies/policy.hpp>

namespace twum::studies {

// For Boost's distributions, which else compute in long double: what that is differs from machine to
// machine, and valgrind, which has none, would end when Boost prepares its constants.
using DoublePrecision = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace twum::studies
