// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "classes.hpp"

namespace twum::inline v0_1::python {

/// A question as plain Python values: the motor as the text of its file, and the arguments of the calls that built
/// it.
py::dict problem_state(const PyProblem& self);

/// The question that has this state.
PyProblem problem_from(const py::object& state);

}  // namespace twum::inline v0_1::python
