// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <twum/base/error.hpp>
#include <twum/io/units.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <set>

namespace twum::inline v0_1::python {
namespace {

[[noreturn]] void refuse_type(const std::string& name, py::handle value, std::string_view unit,
                              std::string_view example) {
  const std::string bare = unit == "1" ? "" : " (in " + std::string(unit) + ")";
  throw py::type_error(name + ": expected a number" + bare + " or a text such as '" +
                       std::string(example) + "', not " +
                       py::cast<std::string>(py::type::of(value).attr("__name__")));
}

bool is_real(const py::array& array) {
  const char kind = array.dtype().kind();
  return kind == 'f' || kind == 'i' || kind == 'u';
}

// A scalar of NumPy, or an array without a dimension.
bool is_numpy_scalar(py::handle value) {
  if (py::isinstance<py::array>(value)) return py::cast<py::array>(value).ndim() == 0;
  return py::isinstance(value, py::module_::import("numpy").attr("generic"));
}

bool is_masked(py::handle values) {
  const py::module_ ma = py::module_::import("numpy.ma");
  return py::isinstance(values, ma.attr("MaskedArray")) &&
         py::cast<bool>(ma.attr("is_masked")(values));
}

// False for texts, bytes, sets and dictionaries, whose entries are not numbers or have no order.
bool is_list_like(py::handle values) {
  PyObject* const object = values.ptr();
  if (PyUnicode_Check(object) || PyBytes_Check(object) || PyByteArray_Check(object)) return false;
  if (PyAnySet_Check(object) || PyDict_Check(object)) return false;
  return py::isinstance<py::iterable>(values);
}

// The values as a NumPy array. A list becomes an array of objects, because NumPy would convert truth values in it to
// numbers.
py::array numpy_array(const std::string& name, py::handle values) {
  const py::object asarray = py::module_::import("numpy").attr("asarray");
  if (py::hasattr(values, "__array__") || PyObject_CheckBuffer(values.ptr())) {
    const py::array array = asarray(values);
    return array.dtype().kind() == 'U' ? py::array(array.attr("astype")("object")) : array;
  }
  try {
    return asarray(py::list(py::reinterpret_borrow<py::object>(values)),
                   py::arg("dtype") = "object");
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    throw InputError(name + ": expected rows of one length; " +
                     py::cast<std::string>(py::str(error.value())));
  }
}

// Converts the entries one by one.
Array from_objects(const py::array& objects, const ToNumber& one) {
  Array numbers(std::vector<py::ssize_t>(objects.shape(), objects.shape() + objects.ndim()));
  double* to = numbers.mutable_data();
  for (const py::handle entry : objects.attr("flat")) *to++ = one(entry);
  return numbers;
}

}  // namespace

std::string to_text(const std::string& name, py::handle value) {
  if (!PyUnicode_Check(value.ptr()))
    throw py::type_error(name + ": expected a text, not " +
                         py::cast<std::string>(py::type::of(value).attr("__name__")));
  py::ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (text == nullptr) {
    PyErr_Clear();
    throw InputError(name + ": a text with a lone surrogate, which stands for no character");
  }
  std::string result(text, static_cast<std::size_t>(size));
  if (result.find('\0') != std::string::npos)
    throw InputError(name + ": a text with a NUL character in it");
  return result;
}

py::str to_py(std::string_view text) { return py::str(text.data(), text.size()); }

std::optional<double> number_of(py::handle value) {
  if (PyBool_Check(value.ptr()) || PyUnicode_Check(value.ptr())) return {};
  if (PyFloat_Check(value.ptr())) return PyFloat_AS_DOUBLE(value.ptr());
  if (py::isinstance<py::array>(value) || py::hasattr(value, "dtype")) {
    if (!is_numpy_scalar(value) || is_masked(value)) return {};
    if (!is_real(py::array::ensure(value))) return {};
  }
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1.0 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    return {};
  }
  return number;
}

double to_quantity(const std::string& name, py::handle value, std::string_view unit,
                   std::string_view example) {
  if (py::isinstance<py::str>(value)) {
    try {
      return studies::parse_quantity(to_text(name, value), {unit, example});
    } catch (const InputError& error) {
      throw InputError(name + ": " + error.what());
    }
  }
  if (const auto number = number_of(value)) return *number;
  refuse_type(name, value, unit, example);
}

double to_speed(py::handle value) { return to_quantity("speed", value, "rad/s", "100 rpm"); }

Array to_numbers(const std::string& name, py::handle values, const ToNumber& one) {
  if (!is_list_like(values)) return to_array({one(values)});
  if (is_masked(values))
    throw InputError(name +
                     ": some entries are masked; give a number for each, or leave them out: "
                     "values.compressed()");
  const py::array array = numpy_array(name, values);
  if (is_real(array)) return Array::ensure(array);
  if (array.dtype().kind() == 'O') return from_objects(array, one);
  throw py::type_error(name + ": expected real numbers or texts with a unit, not an array of " +
                       py::cast<std::string>(py::str(array.dtype())));
}

std::vector<double> to_speeds(py::handle values) {
  if (py::isinstance<py::str>(values) || number_of(values)) return {to_speed(values)};
  const Array array = to_numbers("speeds", values, to_speed);
  if (array.ndim() != 1)
    throw InputError("speeds: expected an array of one dimension, not " +
                     std::to_string(array.ndim()));
  return {array.data(), array.data() + array.size()};
}

double to_parameter_value(Parameter parameter, py::handle value) {
  const ParameterInfo& row = info(parameter);
  const std::string name(row.name);
  if (py::isinstance<py::str>(value)) {
    try {
      return studies::parse_setting(name + "=" + to_text(name, value)).second;
    } catch (const InputError& error) {
      throw InputError(name + ": " + error.what());
    }
  }
  if (const auto number = number_of(value)) return *number;
  refuse_type(name, value, row.unit, row.example);
}

std::vector<ParameterValue> to_parameter_values(const py::dict& arguments) {
  std::vector<ParameterValue> values;
  std::string wrong;
  for (const auto& [key, value] : arguments) {
    try {
      const Parameter parameter = studies::parse_parameter(to_text("name of a parameter", key));
      const double number = to_parameter_value(parameter, value);
      const std::string refusal = complaint(parameter, number);
      if (!refusal.empty()) throw InputError(std::string(info(parameter).name) + " " + refusal);
      values.emplace_back(parameter, number);
    } catch (const InputError& error) {
      wrong += (wrong.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  if (!wrong.empty()) throw InputError(wrong);
  return values;
}

std::vector<studies::MetricExpression> to_metrics(py::handle metrics) {
  if (py::isinstance<py::str>(metrics)) {
    const std::string text = to_text("metrics", metrics);
    std::vector<studies::MetricExpression> list = studies::parse_metric_list(text);
    const std::vector<std::string_view> typed = io::split_list(text);
    for (std::size_t i = 0; i < list.size(); ++i) list[i].text = typed[i];
    return list;
  }
  std::vector<studies::MetricExpression> list;
  std::set<std::string> known;
  for (const py::handle one : metrics) {
    if (!py::isinstance<py::str>(one))
      throw py::type_error("metrics: expected texts such as 'stall_torque'");
    const std::string typed = to_text("metrics", one);
    studies::MetricExpression expression = studies::parse_metric(typed);
    if (!known.insert(expression.text).second)
      throw InputError("metrics: '" + expression.text + "' is given twice");
    expression.text = typed;
    list.push_back(std::move(expression));
  }
  return list;
}

double value_or_throw(std::string_view name, const MetricValue& value) {
  if (value.status == MetricStatus::ok) return value.value;
  const std::string reason = to_string(value.status);
  throw EvaluationError(reason, std::string(name) + " has no value for this motor: " + reason);
}

Array to_array(const std::vector<double>& values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

py::object attribute_of_results(const char* name) {
  return py::module_::import("twum.results").attr(name);
}

}  // namespace twum::inline v0_1::python
