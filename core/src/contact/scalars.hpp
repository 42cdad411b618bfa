// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>

#include <cmath>

namespace twum::inline v0_1::contact {

/// The radial motion of the surface is computed. The page leaves it out and says so: it would be an eighth larger.
#ifdef __wasm__
inline constexpr bool kHasRadialMotion = false;
#else
inline constexpr bool kHasRadialMotion = true;
#endif

/// A driver may have an inductance and a resistance in series with the phases. The page takes it as ideal, and says so.
#ifdef __wasm__
inline constexpr bool kHasSeriesBranch = false;
#else
inline constexpr bool kHasSeriesBranch = true;
#endif

/// The numbers that a contact depends on: the last is that of the radial motion.
inline constexpr int kContactNumbers = kHasRadialMotion ? 8 : 7;

/// Derivatives in the speed and in the wave's amplitude, in this order.
using MotionDual = Dual<double, 2>;
inline constexpr int kInSpeed = 0, kInAmplitude = 1;
using StateDual = Dual<double, 2>;                  ///< derivatives in the layer's state at entry
using PlaneDual = Dual<double, 4>;                  ///< the same of a layer that moves in the plane
using SpeedDual = Dual<double, 1>;                  ///< derivative along the speed
using NumbersDual = Dual<double, kContactNumbers>;  ///< derivatives in the contact numbers
using NumbersDual2 = Dual<SpeedDual, kContactNumbers>;  ///< and theirs along the speed

/// S with two directions more, for the layer's state at entry.
template <typename S>
struct WithState;
template <int N>
struct WithState<Dual<double, N>> {
  using Type = Dual<double, N + 2>;
};

/// The same for a layer that moves in the plane.
template <typename S>
struct WithPlaneState;
template <int N>
struct WithPlaneState<Dual<double, N>> {
  using Type = Dual<double, N + 4>;
};

/// Use the scalars with the layer's state also for layers that come back at rest. This is a little slower, but saves a second
/// version of the lap: the page has to be small.
#ifdef __wasm__
inline constexpr bool kStateAlways = true;
#else
inline constexpr bool kStateAlways = false;
#endif

/// a where the condition holds, else b; in lanes both are computed.
inline double select(bool condition, double a, double b) { return condition ? a : b; }

/// The argument of x + i y; in lanes it may be a little less.
inline double least_argument(double x, double y) { return std::atan2(y, x); }

}  // namespace twum::inline v0_1::contact

/// The closed list of scalars that the contact runs on: double, and these.
#define TWUM_FOR_EACH_CONTACT_DUAL(X) \
  X(MotionDual)                       \
  X(NumbersDual)                      \
  X(NumbersDual2)
#define TWUM_FOR_EACH_CONTACT_SCALAR(X) X(double) TWUM_FOR_EACH_CONTACT_DUAL(X)

/// The scalars of a jump's margin: double, and these. The program has laps in them for other reasons.
#define TWUM_FOR_EACH_MARGIN_DUAL(X) \
  X(WithState<NumbersDual>::Type)    \
  X(NumbersDual2)
#define TWUM_FOR_EACH_MARGIN_SCALAR(X) X(double) TWUM_FOR_EACH_MARGIN_DUAL(X)

/// Those of them that the periodic state is differentiated with in one lap.
#define TWUM_FOR_EACH_WITH_STATE(X) \
  X(WithState<MotionDual>::Type)    \
  X(WithState<NumbersDual>::Type)
