// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/scalars.hpp"
#include "design/plate_numbers.hpp"

#include <twum/core/parameters.hpp>

#include <array>

namespace twum::inline v0_1::core {

/// What the contact model takes of a design: each is a direction of its derivatives, and the speed is the last one. All
/// other parameters act through these, by parameter_jacobian(): they add no direction. The mode of a plate has more numbers
/// of its shape than exponent and root, in whose place they stand.
inline constexpr std::array kModelParameters{
    Parameter::wavelengths,   Parameter::contact_radius,   Parameter::contact_width,
    Parameter::frequency,     Parameter::amplitude,        Parameter::neutral_plane_distance,
    Parameter::modal_damping, Parameter::thickness,        Parameter::youngs_modulus,
    Parameter::shear_modulus, Parameter::shear_viscosity,  Parameter::inertia,
    Parameter::preload,       Parameter::kinetic_friction, Parameter::static_friction,
    Parameter::rotor_taper,   Parameter::shape_exponent,   Parameter::shape_root};

/// Position of a parameter in kModelParameters.
constexpr std::size_t model_index(Parameter parameter) {
  std::size_t i = 0;
  while (kModelParameters[i] != parameter)
    ++i;  // one that is not there does not compile in a constant, else is a bug
  return i;
}

/// Numbers of the radial shape: exponent and root, or R of a mode at kShapePoints of the track.
inline constexpr std::size_t kShapeNumbers = kShapePoints.size();
inline constexpr std::size_t kModelNumbers = kModelParameters.size() + kShapeNumbers - 2;
/// Position of the first of them among the model's numbers; they are the last.
inline constexpr std::size_t kShapeIndex = model_index(Parameter::shape_exponent);
static_assert(kShapeIndex + 2 == kModelParameters.size());

inline constexpr int kSpeedDirection = static_cast<int>(kModelNumbers);
/// Padded to an even count: a direction that is always zero is cheaper than an odd one, which vector instructions cannot pair.
inline constexpr int kDirections = (kSpeedDirection + 2) / 2 * 2;

using ModelDual = Dual<double, kDirections>;
using ModelDual2 = Dual<contact::SpeedDual, kDirections>;  ///< and theirs along the speed

/// What the stator's modes and the drive take of a design beside kModelParameters: the contact does not know of them, so that
/// they are directions of what is made of its answers alone.
inline constexpr std::array kDriveParameters{Parameter::resonance_frequency,
                                             Parameter::modal_mass,
                                             Parameter::force_factor,
                                             Parameter::blocked_capacitance,
                                             Parameter::loss_tangent,
                                             Parameter::voltage,
                                             Parameter::voltage_ratio,
                                             Parameter::phase_error,
                                             Parameter::mode_splitting,
                                             Parameter::rotor_mass,
                                             Parameter::sensor_force_factor,
                                             Parameter::sensor_capacitance,
                                             Parameter::sensor_load_capacitance,
                                             Parameter::sensor_load_resistance,
#ifndef __wasm__  // see kHasSeriesBranch
                                             Parameter::driver_inductance,
                                             Parameter::driver_resistance,
#endif
                                             Parameter::sensor_position};

/// Direction of a parameter in kDriveParameters.
constexpr int drive_direction(Parameter parameter) {
  int i = 0;
  while (kDriveParameters[static_cast<std::size_t>(i)] != parameter) ++i;
  return kDirections + i;
}

/// What metrics take of the plate alone: consecutive numbers.
inline constexpr std::array kPlateMetrics{PlateNumber::mode_separation, PlateNumber::ceramic_stress,
                                          PlateNumber::stator_mass};

/// Direction of one of kPlateMetrics.
constexpr int plate_direction(PlateNumber number) {
  return kDirections + static_cast<int>(kDriveParameters.size()) + static_cast<int>(number) -
         static_cast<int>(kPlateMetrics[0]);
}

inline constexpr int kDesignDirections = plate_direction(kPlateMetrics.back()) + 1;

template <typename T>
using DesignDualOf = Dual<T, kDesignDirections>;
using DesignDual = DesignDualOf<double>;
using DesignDual2 = DesignDualOf<contact::SpeedDual>;

}  // namespace twum::inline v0_1::core

/// The closed list of scalars of the motor model, with the scalar of the speed that goes with each.
#define TWUM_FOR_EACH_MODEL_SCALAR(X) \
  X(double, double)                   \
  X(ModelDual, ModelDual)             \
  X(ModelDual2, ModelDual2)
