// SPDX-License-Identifier: Apache-2.0
// The tables of parameters, metrics and solvers, and quantities.
#include "conversions.hpp"
#include "parts.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/units.hpp>
#include <twum/io/words.hpp>
#include <twum/optim/solvers.hpp>

namespace twum::inline v0_1::python {
namespace {

using namespace py::literals;

const char* takes(Argument argument) {
  switch (argument) {
    case Argument::speed: return "speed";
    case Argument::torque: return "torque";
    case Argument::both: return "torque and speed";
    case Argument::angle: return "angle";
    case Argument::periods: return "periods";
    case Argument::speed_or_torque: return "speed or torque";
    case Argument::either: return "speed or torque, not both";
    default: return "";
  }
}

py::list parameters() {
  return list_of(parameter_table(), [](const ParameterInfo& row) {
    return py::dict("name"_a = row.name, "symbol"_a = row.symbol, "unit"_a = row.unit,
                    "min"_a = row.min, "max"_a = row.max, "example"_a = row.example,
                    "text"_a = row.text);
  });
}

py::list metrics() {
  return list_of(metric_table(), [](const MetricInfo& row) {
    return py::dict("name"_a = row.name, "unit"_a = row.unit, "takes"_a = takes(row.argument),
                    "text"_a = row.text);
  });
}

py::list solvers() {
  return list_of(optim::solvers(), [](const optim::SolverInfo& row) {
    return py::dict("name"_a = row.name, "text"_a = row.description, "gradient"_a = row.gradient,
                    "global"_a = row.global, "available"_a = row.available);
  });
}

}  // namespace

void add_tables(py::module_& module) {
  module.def(
      "parameter_table", parameters,
      "parameter_table()\n--\n\nEvery parameter of a motor: name, symbol, unit, range, example "
      "and text, one dictionary each.");
  module.def(
      "metric_table", metrics,
      "metric_table()\n--\n\nEvery metric: name, unit, what it takes, and text, one dictionary "
      "each.");
  module.def("solver_table", solvers,
             "solver_table()\n--\n\nEvery solver of optimizations, one dictionary each.");
  module.def(
      "quantity",
      [](const py::str& text, const py::str& unit) {
        const std::string si = to_text("unit", unit);
        if (si != "1") studies::parse_measure("1 " + si);  // is one
        return studies::parse_quantity(to_text("text", text), {si, "1 " + si});
      },
      py::arg("text"), py::arg("unit"),
      "quantity(text, unit)\n--\n\nThe number that a text such as '100 rpm' is in an SI unit such "
      "as "
      "'rad/s'.");
  module.def(
      "engineering",
      [](double value, const std::string& unit) { return studies::engineering(value, unit); },
      py::arg("value"), py::arg("unit"),
      "engineering(value, unit)\n--\n\nAn SI value as people say it: engineering(1.6e-6, 'm') is "
      "'1.6 "
      "um', speeds are in rpm.");
}

}  // namespace twum::inline v0_1::python
