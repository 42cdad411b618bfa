// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace twum::inline v0_1::motion {

/// True if this build has an integrator, so that simulate() works.
bool has_integrator() noexcept;

/// Version of SUNDIALS, the integrator, such as "6.4.1"; "none" without it.
std::string integrator_version();

}  // namespace twum::inline v0_1::motion
