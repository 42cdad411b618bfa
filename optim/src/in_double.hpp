// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/policies/policy.hpp>

namespace twum::optim {

/// Boost computes in double: long double differs from machine to machine, and valgrind has none. Both entries are named because its functions name both where they call one
/// another: each is then compiled once. Internal.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_float<false>,
                                               boost::math::policies::promote_double<false>>;

}  // namespace twum::optim
