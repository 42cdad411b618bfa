// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/core/motor.hpp>

#include <span>

/// What a report shows of a contact track with width; internal.
namespace twum::inline v0_1::studies {

/// Pressure and slip over phase and radius, {"phase" [rad], "radius" [m], "pressure" [Pa]: base64 of floats, that of a
/// radius after that of the one before, NaN where nothing touches; "frames": [{"speed" [rad/s], "slip" [m/s]: likewise,
/// "zones": [[state, from, to], ...] of each radius}]}; null for one slice and where no speed has an answer.
/// Some ten milliseconds a frame.
Json track_json(const Motor& motor);

/// Torque [N m] at these speeds [rad/s] of the same motor with one slice, as base64 of doubles; null for one slice.
Json one_slice_torque_json(const Motor& motor, std::span<const double> speeds);

}  // namespace twum::inline v0_1::studies
