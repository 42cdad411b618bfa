// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/contact_gradients.hpp>

namespace twum::inline v0_1::motion {

/// Derivatives of a number of the contact by way of the instantaneous normal force N(A, z), which acts as the preload does (M4.5).
struct NormalForceSlopes {
  double per_amplitude, per_height;
};
inline NormalForceSlopes by_normal_force(const ContactGradients::Number& number,
                                         const ContactGradients& contact) {
  const double per_force = number.gradient[index_of(Parameter::preload)];
  return {per_force * contact.normal_per_amplitude, per_force * contact.normal_per_height};
}

}  // namespace twum::inline v0_1::motion
