// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/expression.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A text of Python as UTF-8.
/// @throws TypeError for another type, InputError for a text with a NUL or a lone surrogate
std::string to_text(const std::string& name, py::handle value);

/// A view on a table's text as a Python string.
py::str to_py(std::string_view text);

/// The value of an int, float or real NumPy number; nothing for anything else, such as truth values, complex numbers,
/// dates and masked numbers.
std::optional<double> number_of(py::handle value);

/// A quantity: a number in the SI unit, or a text with a unit.
/// @throws InputError naming `name`; TypeError for any other object
double to_quantity(const std::string& name, py::handle value, std::string_view unit,
                   std::string_view example);
double to_speed(py::handle value);

/// Value of a parameter; its range is checked by with().
double to_parameter_value(Parameter parameter, py::handle value);

/// Reads one number in the SI unit, or a text with a unit, or throws.
using ToNumber = std::function<double(py::handle)>;

/// An array in SI units, of any shape, from an array of real numbers, or from a list, tuple or array of objects that
/// `one` reads.
/// @throws InputError or TypeError naming `name` for numbers that are not real, masked entries, rows of unequal
///         length, and anything else that is not an array
Array to_numbers(const std::string& name, py::handle values, const ToNumber& one);

/// Speeds from one quantity, an iterable of quantities, or an array of one dimension in rad/s.
std::vector<double> to_speeds(py::handle values);

/// "preload='140 N', thickness=0.3e-3" with everything that is wrong in one InputError.
std::vector<ParameterValue> to_parameter_values(const py::dict& arguments);

/// Metrics as a text between commas or a sequence of texts. Each keeps the text that the user typed, by which answers know
/// it.
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

}  // namespace twum::inline v0_1::python
