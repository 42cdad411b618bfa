// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"

#include <twum/base/error.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/result_store.hpp>

#include <exception>
#include <string>
#include <string_view>
#include <utility>

namespace twum::inline v0_1::python {
namespace {

// The exceptions of Python. They live as long as the process, as the module does.
struct ErrorClasses {
  py::handle error, input, file, evaluation, store;
};

ErrorClasses& classes() {
  static ErrorClasses instance;
  return instance;
}

py::handle make(py::module_& module, const char* name, const py::tuple& bases, const char* doc) {
  PyObject* type =
      PyErr_NewExceptionWithDoc((std::string("twum.") + name).c_str(), doc, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

// The library's advice names commands and their options. In Python these are functions and arguments.
std::string in_python(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"'twum metrics'", "twum.metric_table()"},
      {"'twum parameters'", "twum.parameter_table()"},
      {"'twum solvers'", "twum.solver_table()"},
      {"'twum run'", "twum.run()"},
      {" with -o", ""},
      {"--fresh", "fresh=True"}};
  for (const auto& [command, here] : kWords)
    for (std::size_t at = text.find(command); at != std::string::npos;
         at = text.find(command, at + here.size()))
      text.replace(at, command.size(), here);
  return text;
}

void set_error(const py::handle& kind, const std::exception& error) {
  PyErr_SetString(kind.ptr(), in_python(error.what()).c_str());
}

void set_evaluation_error(const EvaluationError& error) {
  const py::object exception =
      py::reinterpret_borrow<py::object>(classes().evaluation)(error.what());
  exception.attr("reason") = error.reason();
  PyErr_SetObject(classes().evaluation.ptr(), exception.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const studies::FileError& error) {
    set_error(classes().file, error);
  } catch (const InputError& error) {
    set_error(classes().input, error);
  } catch (const EvaluationError& error) {
    set_evaluation_error(error);
  } catch (const studies::StoreError& error) {
    set_error(classes().store, error);
  } catch (const Error& error) {
    set_error(classes().error, error);
  }
}

}  // namespace

void add_errors(py::module_& module) {
  const auto exception = py::reinterpret_borrow<py::object>(PyExc_Exception);
  const auto value_error = py::reinterpret_borrow<py::object>(PyExc_ValueError);
  const auto os_error = py::reinterpret_borrow<py::object>(PyExc_OSError);
  ErrorClasses& c = classes();
  c.error = make(module, "Error", py::make_tuple(exception), "Root of what twum raises.");
  c.input =
      make(module, "InputError", py::make_tuple(c.error, value_error),
           "What was asked cannot be: a value out of range, an unknown name, a wrong unit. The\n"
           "text says where, what was found, and what would be right.");
  c.file = make(module, "FileError", py::make_tuple(c.input),
                "Everything that is wrong with a file, each with its place.");
  c.evaluation =
      make(module, "EvaluationError", py::make_tuple(c.error),
           "A valid motor has no answer at the point asked for. `reason` is a short word,\n"
           "such as 'no-periodic-state'.");
  c.store = make(module, "StoreError", py::make_tuple(c.error, os_error),
                 "A result could not be written or read back.");
  py::register_exception_translator(translate);
}

}  // namespace twum::inline v0_1::python
