// SPDX-License-Identifier: Apache-2.0
// The compiled part of the Python module.
#include "interruptible.hpp"
#include "parts.hpp"

#include <twum/base/version.hpp>

PYBIND11_MODULE(_twum, module) {
  using namespace twum::python;
  // Every docstring begins with its signature as inspect.signature() reads it.
  py::options options;
  options.disable_function_signatures();
  module.doc() = "The compiled part of twum.";
  module.attr("__version__") = twum::version();
  add_errors(module);
  add_tables(module);
  add_motor(module);
  add_batch(module);
  add_problem(module);
  add_study(module);
  add_end_of_calls();
}
