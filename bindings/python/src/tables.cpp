// SPDX-License-Identifier: Apache-2.0
// The tables of parameters, metrics and solvers, and quantities.
#include "conversions.hpp"
#include "parts.hpp"

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/optim/solvers.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/engineering.hpp>
#include <twum/studies/units/units.hpp>

namespace twum::python {
namespace {

const char* takes(Argument argument) {
  switch (argument) {
    case Argument::speed: return "speed";
    case Argument::torque: return "torque";
    case Argument::speed_or_torque: return "speed or torque";
    default: return "";
  }
}

py::list parameters() {
  py::list rows;
  for (const ParameterInfo& row : parameter_table()) {
    py::dict entry;
    entry["name"] = to_py(row.name);
    entry["symbol"] = to_py(row.symbol);
    entry["unit"] = to_py(row.unit);
    entry["min"] = row.min;
    entry["max"] = row.max;
    entry["example"] = to_py(row.example);
    entry["text"] = to_py(row.text);
    rows.append(entry);
  }
  return rows;
}

py::list metrics() {
  py::list rows;
  for (const MetricInfo& row : metric_table()) {
    py::dict entry;
    entry["name"] = to_py(row.name);
    entry["unit"] = to_py(row.unit);
    entry["takes"] = takes(row.argument);
    entry["text"] = to_py(row.text);
    rows.append(entry);
  }
  return rows;
}

py::list solvers() {
  py::list rows;
  for (const optim::SolverInfo& row : optim::solvers()) {
    py::dict entry;
    entry["name"] = row.name;
    entry["text"] = row.description;
    entry["gradient"] = row.gradient;
    entry["global"] = row.global;
    entry["available"] = row.available;
    rows.append(entry);
  }
  return rows;
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
      [](const std::string& text, const std::string& unit) {
        return studies::parse_quantity(text, {unit, "1 " + unit});
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

}  // namespace twum::python
