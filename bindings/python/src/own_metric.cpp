// SPDX-License-Identifier: Apache-2.0
#include "own_metric.hpp"

#include "classes.hpp"
#include "conversions.hpp"

#include <twum/base/error.hpp>
#include <twum/motors/settings.hpp>

#include <array>
#include <memory>

namespace twum::inline v0_1::python {
namespace {

// A function of Python that threads without the GIL may copy and drop.
using Shared = std::shared_ptr<const py::object>;

Shared shared(const py::object& function) {
  return {new py::object(function), [](const py::object* object) {
            const py::gil_scoped_acquire gil;
            delete object;
          }};
}

// What a function of Python answers for a motor, by take(answer).
template <typename Take>
auto asked(const py::object& function, const std::string& name, const Motor& motor, Take take) {
  try {
    return take(function(PyMotor{name, motor}));
  } catch (py::error_already_set& error) {
    const py::object kind = py::module_::import("twum").attr("EvaluationError");
    if (!error.matches(kind)) throw;
    const py::object reason = py::getattr(error.value(), "reason", py::str("undefined"));
    throw EvaluationError(py::cast<std::string>(reason), error.what());
  }
}

// A wrong name is a fault of the program. As an InputError it would count as a design that is no motor.
Parameter named(const std::string& parameter) {
  try {
    return studies::parse_parameter(parameter);
  } catch (const InputError& error) {
    throw py::value_error("a gradient: " + std::string(error.what()));
  }
}

std::array<double, kParameterCount> to_gradient(const py::object& answer) {
  std::array<double, kParameterCount> gradient{};
  for (const auto& [parameter, slope] : py::cast<py::dict>(answer))
    gradient[index_of(named(py::cast<std::string>(parameter)))] = py::cast<double>(slope);
  return gradient;
}

}  // namespace

studies::OwnMetric to_own_metric(const py::object& function, const py::object& name,
                                 const py::object& gradient, const std::string& unit,
                                 const std::string& motor) {
  studies::OwnMetric own;
  own.name = py::cast<std::string>(name.is_none() ? function.attr("__name__") : name);
  own.unit = unit;
  own.value = [value = shared(function), motor](const Motor& of) {
    const py::gil_scoped_acquire gil;
    return asked(*value, motor, of,
                 [](const py::object& answer) { return py::cast<double>(answer); });
  };
  if (gradient.is_none()) return own;
  own.gradient = [slopes = shared(gradient), motor](const Motor& of) {
    const py::gil_scoped_acquire gil;
    return asked(*slopes, motor, of, to_gradient);
  };
  return own;
}

}  // namespace twum::inline v0_1::python
