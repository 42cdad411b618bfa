// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/motor/settings.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/units.hpp>

#include <algorithm>

namespace twum::python {
namespace {

[[noreturn]] void refuse_type(const std::string& name, py::handle value, std::string_view unit,
                              std::string_view example) {
  const std::string bare = unit == "1" ? "" : " (in " + std::string(unit) + ")";
  throw py::type_error(name + ": expected a number" + bare + " or a text such as '" +
                       std::string(example) + "', not " +
                       py::cast<std::string>(py::type::of(value).attr("__name__")));
}

}  // namespace

py::str to_py(std::string_view text) { return py::str(text.data(), text.size()); }

std::optional<double> number_of(py::handle value) {
  if (PyBool_Check(value.ptr()) || PyUnicode_Check(value.ptr())) return {};
  if (PyFloat_Check(value.ptr())) return PyFloat_AS_DOUBLE(value.ptr());
  if (py::isinstance<py::array>(value) && py::cast<py::array>(value).ndim() > 0) return {};
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
      return studies::parse_quantity(py::cast<std::string>(value), {unit, example});
    } catch (const InputError& error) {
      throw InputError(name + ": " + error.what());
    }
  }
  if (const auto number = number_of(value)) return *number;
  refuse_type(name, value, unit, example);
}

double to_speed(py::handle value) { return to_quantity("speed", value, "rad/s", "100 rpm"); }

std::vector<double> to_speeds(py::handle values) {
  if (py::isinstance<py::array>(values)) {
    const Array array = Array::ensure(values);
    if (!array) throw py::error_already_set();
    if (array.ndim() != 1)
      throw InputError("speeds: expected an array of one dimension, not " +
                       std::to_string(array.ndim()));
    return {array.data(), array.data() + array.size()};
  }
  std::vector<double> speeds;
  if (py::isinstance<py::str>(values) || number_of(values)) return {to_speed(values)};
  for (const py::handle value : values) speeds.push_back(to_speed(value));
  return speeds;
}

double to_parameter_value(Parameter parameter, py::handle value) {
  const ParameterInfo& row = info(parameter);
  const std::string name(row.name);
  if (py::isinstance<py::str>(value)) {
    try {
      return studies::parse_setting(name + "=" + py::cast<std::string>(value)).second;
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
      const Parameter parameter = studies::parse_parameter(py::cast<std::string>(key));
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
    return studies::parse_metric_list(py::cast<std::string>(metrics));
  }
  std::vector<studies::MetricExpression> list;
  for (const py::handle one : metrics) {
    if (!py::isinstance<py::str>(one))
      throw py::type_error("metrics: expected texts such as 'stall_torque'");
    studies::MetricExpression expression = studies::parse_metric(py::cast<std::string>(one));
    const bool twice = std::any_of(
        list.begin(), list.end(), [&](const auto& other) { return other.text == expression.text; });
    if (twice) throw InputError("metrics: '" + expression.text + "' is there twice");
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

}  // namespace twum::python
