// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "classes.hpp"
#include "parts.hpp"

#include <memory>

namespace twum::inline v0_1::python {

/// OperatingPoint and Derivative.
void add_answer_classes(py::module_& module);

/// Metrics, points, curves and fields as members of Motor.
void add_answers(py::class_<PyMotor, std::shared_ptr<PyMotor>>& motor);

/// Motions and linear plants as members of Motor.
void add_motions(py::class_<PyMotor, std::shared_ptr<PyMotor>>& motor);

}  // namespace twum::inline v0_1::python
