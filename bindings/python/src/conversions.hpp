// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/studies/metrics/expression.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A view on a table's text as a Python string.
py::str to_py(std::string_view text);

/// The float that an int, float or NumPy number is; nothing for anything else, truth values included.
std::optional<double> number_of(py::handle value);

/// A quantity: a number in the SI unit, or a text with a unit.
/// @throws InputError naming `name`; TypeError for any other object
double to_quantity(const std::string& name, py::handle value, std::string_view unit,
                   std::string_view example);
double to_speed(py::handle value);

/// Speeds from a list of quantities or an array in rad/s.
std::vector<double> to_speeds(py::handle values);

/// Value of a parameter; its range is left to with().
double to_parameter_value(Parameter parameter, py::handle value);

/// "preload='140 N', thickness=0.3e-3" with everything that is wrong in one InputError.
std::vector<ParameterValue> to_parameter_values(const py::dict& arguments);

/// Metrics as a text between commas or a sequence of texts.
std::vector<studies::MetricExpression> to_metrics(py::handle metrics);

/// @throws EvaluationError naming the metric unless its status is ok
double value_or_throw(std::string_view name, const MetricValue& value);

/// The same numbers as an array of NumPy.
Array to_array(const std::vector<double>& values);

/// A list with entry(row) for each row.
template <typename Rows, typename Entry>
py::list list_of(const Rows& rows, Entry entry) {
  py::list list;
  for (const auto& row : rows) list.append(entry(row));
  return list;
}

/// A class of the module twum.results, which holds what calls return.
py::object attribute_of_results(const char* name);

}  // namespace twum::python
