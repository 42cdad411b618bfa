// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Everything of twum::core: designs, operating points, curves, fields, metrics with derivatives.

/// @namespace twum
/// One motor: its design, operating points, curves, fields, metrics with derivatives.
///
/// What holds of every function here, in twum::optim and in twum::studies, unless it says otherwise:
///
/// * Numbers are in SI units; equations such as T3.2 are those of docs/theory.
/// * Values go in and come out; nothing is kept between calls. A function, and a const member of an
///   object, may be called by any number of threads at once.
/// * A wrong argument is an InputError that says what was found and what would be right; nothing has
///   changed then. Memory may run out besides (std::bad_alloc).
/// * The answer follows from the arguments alone: not from threads, time or locale, whose decimal point
///   shows in the words of an error only.

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/core/contact/normal_contact.hpp>
#include <twum/core/contact/zone.hpp>
#include <twum/core/design/motor_design.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/core/design/plate.hpp>
#include <twum/core/performance/backward_wave.hpp>
#include <twum/core/performance/batch.hpp>
#include <twum/core/performance/equivalent_circuit.hpp>
#include <twum/core/performance/frequency_response.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>
