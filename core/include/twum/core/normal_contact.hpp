// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1 {

/// Normal contact of wave and rotor, theory section 3: on |theta| <= theta_L the pressure is
///
///     p(theta) = P (cos theta - c),   P = E A / h,   c = cos theta_L            (partial contact)
///
/// and in full contact the same with theta_L = pi and c = -F_N kappa / (2 pi n b P) <= -1
/// (T3.1 to T3.4). Scalar is double, or a Dual that carries derivatives.
template <typename Scalar>
struct NormalContact {
  Scalar half_angle;          ///< theta_L = kappa L [rad], 0 .. pi
  Scalar edge_cosine;         ///< c [1]; below -1 in full contact
  Scalar pressure_amplitude;  ///< P = E A / h [Pa]
  Scalar half_length;         ///< L = theta_L / kappa [m]
  /// preload over the preload that just closes the contact all round, A_1 / A (D1.5) [1]
  Scalar load_ratio;
  Scalar ratio;         ///< alpha = L / lambda = theta_L / (2 pi) [1], 0 .. 0.5
  Scalar max_pressure;  ///< p(0) [Pa]
  bool full;            ///< the layer touches the stator all round
};

/// Half angle theta_L of partial contact that carries a load.
///
/// Solves sin t - t cos t = load (T3.2) with full relative accuracy in t; the left side rises strictly
/// from 0 to pi, so there is one answer. Smooth for load > 0, as load^(1/3) at 0. A few Newton
/// steps; never throws.
/// @param load  F_N h kappa / (2 n b E A) [1], 0 <= load < pi.
/// @return theta_L in [0, pi) [rad].
double contact_half_angle(double load);

}  // namespace twum::inline v0_1
