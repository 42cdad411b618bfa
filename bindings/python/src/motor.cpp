// SPDX-License-Identifier: Apache-2.0
// The class Motor: how one is made, and what is asked of it through the tables.
#include "classes.hpp"
#include "conversions.hpp"
#include "motor_answers.hpp"
#include "parts.hpp"
#include "telling/renderers.hpp"

#include <twum/base/error.hpp>
#include <twum/io/engineering.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/datasheet.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace twum::inline v0_1::python {
namespace {

using Class = py::class_<PyMotor, std::shared_ptr<PyMotor>>;

PyMotor changed(const studies::MotorFile& file, const py::dict& parameters) {
  return {file.name, Motor(with(file.design, to_parameter_values(parameters)))};
}

PyMotor make(const py::object& path, const std::optional<std::string>& name,
             const py::kwargs& parameters) {
  studies::MotorFile file;
  if (!path.is_none()) {
    const auto text = to_text("path", py::module_::import("os").attr("fsdecode")(path));
    file = studies::read_motor_file(text);
  }
  if (name) file.name = *name;
  return changed(file, parameters);
}

py::dict parameters_of(const PyMotor& self) {
  py::dict values;
  for (const ParameterInfo& row : parameter_table()) {
    const double value = get(self.motor.design(), row.parameter);
    if (!std::isnan(value)) values[to_py(row.name)] = value;
  }
  return values;
}

std::string file_text(const PyMotor& self) {
  return studies::motor_text({self.name, self.motor.design()});
}

// The rated point; nothing if the data sheet is to choose it.
studies::DatasheetOptions sheet_options(const PyMotor& self, const py::object& speed,
                                        const py::object& torque) {
  studies::DatasheetOptions sheet;
  if (!speed.is_none()) sheet.rated_speed = to_speed(speed);
  if (torque.is_none()) return sheet;
  const double load = to_quantity("torque", torque, "N.m", "0.5 N.m");
  if (sheet.rated_speed) {
    value_or_throw("amplitude_at", evaluate(self.motor, {Metric::amplitude_at, Argument::both,
                                                         *sheet.rated_speed, load}));
    sheet.held_torque = load;
  } else {
    sheet.rated_speed = value_or_throw(
        "speed_at", evaluate(self.motor, {Metric::speed_at, Argument::torque, load}));
  }
  return sheet;
}

std::string datasheet_of(const PyMotor& self, const py::object& speed, const py::object& torque) {
  return studies::datasheet_html({self.name, self.motor.design()},
                                 sheet_options(self, speed, torque));
}

PyMotor from_text(const py::object& text) {
  const studies::Source source("motor", py::cast<std::string>(text));
  const studies::MotorFile file = studies::read_motor(source);
  return {file.name, Motor(file.design)};
}

std::string representation(const PyMotor& self) {
  const MotorDesign& design = self.motor.design();
  std::string text = "<twum.Motor";
  if (!self.name.empty()) text += " " + std::string(py::repr(py::str(self.name)));
  const char* between = self.name.empty() ? " " : ", ";
  for (const Parameter parameter : {Parameter::contact_radius, Parameter::frequency,
                                    Parameter::amplitude, Parameter::voltage, Parameter::preload}) {
    if (!is_given(design, parameter)) continue;  // amplitude or voltage
    const ParameterInfo& row = info(parameter);
    text += std::exchange(between, ", ") + std::string(row.name) + " " +
            studies::engineering(get(design, parameter), row.unit);
  }
  return text + ">";
}

// What is given of the motor, as a cell of a notebook shows it.
std::string shown_as_html(const PyMotor& self) {
  using namespace studies::telling;
  Table table;
  table.heads = {{"parameter"}, {"value"}, {"meaning"}};
  for (const ParameterInfo& row : parameter_table()) {
    if (!is_given(self.motor.design(), row.parameter)) continue;
    const double value = get(self.motor.design(), row.parameter);
    const bool automatic = row.parameter == Parameter::radial_slices && value == 0;
    table.rows.push_back(
        {{name_part(std::string(row.name))},
         {automatic ? studies::telling::Part("auto") : value_part(value, std::string(row.unit))},
         {std::string(row.text)}});
  }
  return html(Phrase{strong(self.name.empty() ? "motor" : self.name)}) + html(table);
}

// "Young's modulus of the contact layer, E [Pa], such as '3 GPa'."
std::string parameter_doc(const ParameterInfo& row) {
  std::string doc(row.text);
  if (!row.symbol.empty()) doc += ", " + std::string(row.symbol);
  doc += " [" + std::string(row.unit) + "], such as '" + std::string(row.example) + "'.";
  doc.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(doc.front())));
  return doc;
}

std::string class_doc() {
  std::string doc =
      "Motor(path=None, /, *, name=None, **parameters)\n--\n\n"
      "A motor, immutable; one may be used by any number of threads.\n\n"
      "From a motor file, with parameters replaced; without a path from the 60 mm ring motor that "
      "a\n"
      "default design is. Parameters are numbers in SI units or texts with a unit:\n\n"
      "    Motor('ring-60.yaml', preload='140 N', thickness=0.3e-3)\n\n"
      "Its attributes are its parameters and metrics; point metrics are methods. InputError says\n"
      "everything that is wrong with the parameters.\n\nParameters:\n\n";
  for (const ParameterInfo& row : parameter_table())
    doc += "    " + std::string(row.name) + ": " + parameter_doc(row) + "\n";
  return doc;
}

void add_making(Class& motor) {
  motor.def(py::init(&make), py::arg("path") = py::none(), py::pos_only(), py::kw_only(),
            py::arg("name") = py::none());
  motor.def(
      "replace",
      [](const PyMotor& self, const py::kwargs& parameters) {
        return changed({self.name, self.motor.design()}, parameters);
      },
      "replace(self, **parameters)\n--\n\nThe motor with some parameters replaced. A value "
      "replaces its "
      "alternative (shear_modulus\nand poisson_ratio say the same in two ways); mu_0 keeps its "
      "ratio to "
      "mu when "
      "only mu\nis replaced.");
  motor.def_readonly("name", &PyMotor::name, "Name of the motor.");
  motor.def_property_readonly(
      "parameters", &parameters_of,
      "Every parameter that has a value by name, SI; G, gamma and m as they follow from others.");
  motor.def("file_text", &file_text,
            "file_text(self)\n--\n\nThe motor as the text of a motor file, to the last digit.");
  motor.def(
      "datasheet", &datasheet_of, py::arg("speed") = py::none(), py::kw_only(),
      py::arg("torque") = py::none(),
      "datasheet(self, speed=None, *, torque=None)\n--\n\nThe data sheet as the text of one "
      "HTML page: drawing, curves, rated point, limits,\nparameters. The rated point is at a "
      "speed or a torque; given both, the drive is adjusted\nto hold the torque at the speed. "
      "By default it is that of the largest overall\nefficiency, or of the largest output "
      "power if the motor has no modal data.");
  motor.def("__repr__", &representation);
  motor.def("_repr_html_", &shown_as_html,
            "_repr_html_(self)\n--\n\nIts parameters as a table, for notebooks.");
  motor.def(
      "__eq__",
      [](const PyMotor& self, const PyMotor& other) {
        return self.name == other.name && self.motor == other.motor;
      },
      py::is_operator());
  motor.def("__hash__", [](const PyMotor& self) {
    return py::hash(py::tuple(parameters_of(self).attr("values")()));
  });
  add_pickling(motor, &file_text, &from_text);
}

void add_parameters(Class& motor) {
  for (const ParameterInfo& row : parameter_table()) {
    motor.def_property_readonly(
        std::string(row.name).c_str(),
        [parameter = row.parameter](const PyMotor& self) {
          return get(self.motor.design(), parameter);
        },
        parameter_doc(row).c_str());
  }
}

}  // namespace

void add_motor(py::module_& module) {
  add_answer_classes(module);
  Class motor(module, "Motor", class_doc().c_str());
  add_making(motor);
  add_parameters(motor);
  add_answers(motor);
  add_motions(motor);
}

}  // namespace twum::inline v0_1::python
