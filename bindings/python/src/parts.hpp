// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace twum::inline v0_1::python {

namespace py = pybind11;

// Each part adds its names to the module.
void add_errors(py::module_& module);
void add_tables(py::module_& module);
void add_motor(py::module_& module);
void add_batch(py::module_& module);
void add_problem(py::module_& module);
void add_study(py::module_& module);

}  // namespace twum::inline v0_1::python
