// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Everything of twum::motion: a motor in time.

/// @namespace twum::motion
/// A motor in time: starts, stops, and changes of load and drive (docs/theory/motion.md). The rules of twum.hpp's libraries
/// hold: SI units, values in and out, InputError for a wrong argument.

#include <twum/motion/control.hpp>
#include <twum/motion/free_life.hpp>
#include <twum/motion/integrator_version.hpp>
#include <twum/motion/left_out.hpp>
#include <twum/motion/linear_plant.hpp>
#include <twum/motion/manoeuvres.hpp>
#include <twum/motion/motion.hpp>
#include <twum/motion/plant_table.hpp>
#include <twum/motion/profile.hpp>
