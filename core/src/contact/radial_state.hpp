// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/periodic_state.hpp"

namespace twum::inline v0_1::contact {

/// find_periodic_state() where the surface also moves radially: laps, and Newton's method on the return map of the layer's four
/// numbers where they settle slowly. With mu_0 = mu the lap never increases the energy of a difference of states (E6.1 holds in
/// the plane, since Coulomb's law is monotone there, too).
PeriodicState find_radial_state(const ContactNumbers<double>& numbers, const LapGuess* guess,
                                double accuracy);

/// The same beside a state that is known, of numbers that differ by so little that its steps are as good: they are followed as far
/// as they go.
PeriodicState radial_state_beside(const ContactNumbers<double>& numbers,
                                  const PeriodicState& known);

/// periodic_means() of such a state.
template <typename S>
ContactMeans<S> radial_means(const ContactNumbers<S>& numbers, const PeriodicState& state);

}  // namespace twum::inline v0_1::contact
