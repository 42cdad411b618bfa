// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/studies/motor_problem.hpp>

#include <concepts>
#include <string>
#include <utility>

namespace twum::inline v0_1::python {

/// A motor in Python: it has a name and is immutable.
struct PyMotor {
  std::string name;
  Motor motor;
};

/// A metric with its derivatives.
struct PyDerivative {
  MetricDerivative of;
};

/// A design question about a motor with this name.
struct PyProblem {
  std::string name;
  studies::DesignProblem problem;
};

/// The classes of twum in Python.
template <typename T>
concept PythonClass = std::same_as<T, PyMotor> || std::same_as<T, PyDerivative> ||
    std::same_as<T, PyProblem> || std::same_as<T, OperatingPoint>;

/// Pickles objects of a class by a state of plain Python values, and the attributes that a class derived from it adds.
/// Python's own __reduce__(), which protocols 0 and 1 use, would ask pybind11 for an object without a value.
template <typename T, typename... Options, typename State, typename FromState>
void add_pickling(py::class_<T, Options...>& type, State state, FromState from_state) {
  type.def(py::pickle(
      [state](const py::object& self) {
        const py::object added = py::getattr(self, "__dict__", py::dict());
        return py::make_tuple(state(py::cast<const T&>(self)), added);
      },
      [from_state](const py::tuple& pickled) {
        try {
          const auto [content, added] = py::cast<std::pair<py::object, py::dict>>(pickled);
          return std::make_pair(from_state(content), added);
        } catch (const py::cast_error&) {
          throw py::value_error("not the pickled state of this class");
        }
      }));
  type.def("__reduce__", [](const py::object& self) {
    const py::object make = py::module_::import("copyreg").attr("__newobj__");
    return py::make_tuple(make, py::make_tuple(py::type::of(self)), self.attr("__getstate__")());
  });
}

}  // namespace twum::inline v0_1::python

namespace pybind11::detail {

/// T.__new__(T) makes an object without a value, for which pybind11 would pass memory that nothing has filled. It is
/// refused here.
template <twum::python::PythonClass T>
class type_caster<T> : public type_caster_base<T> {
 public:
  bool load(handle source, bool convert) {
    if (isinstance<T>(source)) {
      auto* object = reinterpret_cast<instance*>(source.ptr());
      if (!object->get_value_and_holder(get_type_info(typeid(T))).holder_constructed())
        throw type_error(cast<std::string>(str(type::of(source).attr("__name__"))) +
                         ": __init__() was not called for this object");
    }
    return type_caster_base<T>::load(source, convert);
  }
};

}  // namespace pybind11::detail
