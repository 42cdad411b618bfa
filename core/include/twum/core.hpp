// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Everything of twum::core: designs, operating points, curves, fields, metrics with derivatives.

/// @namespace twum
/// One motor: its design, operating points, curves, fields, metrics with derivatives.
///
/// These rules hold for every function here, in twum::optim and in twum::studies, unless its comment says otherwise:
///
/// * Numbers are in SI units; equations such as T3.2 are those of docs/theory.
/// * Functions take and return values and have no state that a caller could notice. A function, and a const member of
///   an object, may be called by any number of threads at once.
/// * A wrong argument throws an InputError that says what was found and what would be right, and changes nothing. Any
///   function may also throw std::bad_alloc.
/// * The result depends on the arguments alone, not on threads, time or locale. Only the decimal point in the text of
///   an error follows the locale.

#include <twum/base/error.hpp>
#include <twum/base/same_containers.hpp>
#include <twum/base/version.hpp>
#include <twum/core/backward_wave.hpp>
#include <twum/core/batch.hpp>
#include <twum/core/contact_gradients.hpp>
#include <twum/core/contact_slopes.hpp>
#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/frequency_response.hpp>
#include <twum/core/heat.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/life.hpp>
#include <twum/core/load.hpp>
#include <twum/core/metric_request.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motion_metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/normal_contact.hpp>
#include <twum/core/operating_point.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/plate.hpp>
#include <twum/core/steady_heat.hpp>
#include <twum/core/track_wear.hpp>
#include <twum/core/workspace.hpp>
#include <twum/core/worn_in.hpp>
#include <twum/core/zone.hpp>
