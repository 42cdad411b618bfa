// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <twum/motors/expression.hpp>

#include <string>

namespace twum::inline v0_1::python {

/// A metric that a function of Python computes: function(motor) gives its value, gradient(motor) a dict from names of parameters to
/// derivatives, in which those that are missing are 0. Both are called with the GIL, on any thread. What they raise ends the
/// search and reaches its caller; an EvaluationError says that the motor has no value.
/// @param name      None: the name of the function
/// @param gradient  may be None
/// @param motor     name of the motors that the functions are given
studies::OwnMetric to_own_metric(const py::object& function, const py::object& name,
                                 const py::object& gradient, const std::string& unit,
                                 const std::string& motor);

}  // namespace twum::inline v0_1::python
