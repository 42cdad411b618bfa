// SPDX-License-Identifier: Apache-2.0
// The classes OperatingPoint and Derivative.
#include "conversions.hpp"
#include "motor_answers.hpp"

#include <twum/base/error.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

namespace twum::inline v0_1::python {
namespace {

// The enumeration value with this word. The values count from 0 without a gap up to `last`.
template <typename Enum>
Enum from_word(const std::string& word, Enum last) {
  for (int i = 0; i <= static_cast<int>(last); ++i)
    if (word == to_string(static_cast<Enum>(i))) return static_cast<Enum>(i);
  throw InputError("pickled by another version of twum: there is no " + studies::quoted(word));
}

// --- operating points

struct PointEntry {
  const char* name;
  double OperatingPoint::*member;
  const char* text;
};

constexpr PointEntry kPointEntries[] = {
    {"speed", &OperatingPoint::speed, "Rotor speed [rad/s]."},
    {"torque", &OperatingPoint::torque, "Torque on the rotor, positive in drive direction [N.m]."},
    {"output_power", &OperatingPoint::output_power, "Output power [W]."},
    {"stator_power", &OperatingPoint::stator_power, "Power from the stator to the layer [W]."},
    {"friction_power", &OperatingPoint::friction_power, "Friction power, snaps included [W]."},
    {"layer_loss", &OperatingPoint::layer_loss, "Viscous loss in the layer [W]."},
    {"stator_loss", &OperatingPoint::stator_loss, "Loss of the stator's own vibration [W]."},
    {"wear_intensity", &OperatingPoint::wear_intensity,
     "Friction power per area of the contact track [W/m^2]."},
    {"stick_fraction", &OperatingPoint::stick_fraction, "Share of the contact length that sticks."},
    {"reactive_force", &OperatingPoint::reactive_force,
     "Force of the contact on the wave, in phase with it [N]."},
    {"amplitude", &OperatingPoint::amplitude, "Amplitude of the wave [m]."},
    {"phase_lag", &OperatingPoint::phase_lag,
     "Lag of the wave behind the voltage [rad]; NaN, as what follows, without modal data."},
    {"voltage", &OperatingPoint::voltage, "Voltage of the inverter that holds the wave, rms [V]."},
    {"phase_current", &OperatingPoint::phase_current, "Current of a phase, rms [A]."},
    {"power_factor", &OperatingPoint::power_factor, "Electrical over apparent power of a phase."},
    {"electrical_power", &OperatingPoint::electrical_power,
     "Power out of the inverter, both phases together [W]."},
    {"dielectric_loss", &OperatingPoint::dielectric_loss, "Loss in the blocked capacitances [W]."},
    {"driver_loss", &OperatingPoint::driver_loss, "Loss in driver_resistance, both phases [W]."},
    {"terminal_voltage", &OperatingPoint::terminal_voltage,
     "Voltage across a phase, behind driver_inductance and driver_resistance, rms [V]."}};

py::dict point_state(const OperatingPoint& point) {
  py::dict state;
  for (const PointEntry& entry : kPointEntries) state[entry.name] = point.*entry.member;
  state["status"] = to_string(point.status);
  return state;
}

OperatingPoint point_from(const py::object& state) {
  OperatingPoint point;
  for (const PointEntry& entry : kPointEntries)
    point.*entry.member = py::cast<double>(state[entry.name]);
  point.status = from_word(py::cast<std::string>(state["status"]), PointStatus::unstable_amplitude);
  return point;
}

std::string point_text(const OperatingPoint& point) {
  const std::string speed = studies::engineering(point.speed, "rad/s");
  const bool answered = point.status == PointStatus::ok;
  return "<twum.OperatingPoint at " + speed + ": " +
         (answered ? "torque " + studies::engineering(point.torque, "N.m") + ", output power " +
                         studies::engineering(point.output_power, "W")
                   : std::string(to_string(point.status))) +
         ">";
}

void add_operating_point(py::module_& module) {
  py::class_<OperatingPoint> point(
      module, "OperatingPoint",
      "The motor in its periodic state at one speed, SI units; NaN unless status is 'ok'.");
  for (const PointEntry& entry : kPointEntries)
    point.def_readonly(entry.name, entry.member, entry.text);
  point.def_property_readonly("overall_efficiency", &OperatingPoint::overall_efficiency,
                              "Output over electrical power, 0 where the output is negative.");
  point.def_property_readonly("contact_efficiency", &OperatingPoint::contact_efficiency,
                              "Output over stator power; NaN where none goes in.");
  point.def_property_readonly("efficiency", &OperatingPoint::efficiency,
                              "Output over stator power and stator loss; NaN where none goes in.");
  point.def_property_readonly(
      "status", [](const OperatingPoint& p) { return to_string(p.status); },
      "'ok', or the short reason why there is no answer.");
  point.def("__repr__", &point_text);
  add_pickling(point, point_state, point_from);
}

// --- derivatives

double entry_of(const PyDerivative& self, const std::string& name) {
  const auto parameter = find_parameter(name);
  if (!parameter) throw py::key_error(name);
  return self.of.gradient[index_of(*parameter)];
}

py::dict gradient_dict(const PyDerivative& self) {
  py::dict entries;
  for (const ParameterInfo& row : parameter_table())
    entries[to_py(row.name)] = self.of.gradient[index_of(row.parameter)];
  return entries;
}

py::dict derivative_state(const PyDerivative& self) {
  py::dict state;
  state["value"] = self.of.value.value;
  state["status"] = to_string(self.of.value.status);
  state["smoothness"] = to_string(self.of.smoothness);
  state["gradient"] = gradient_dict(self);
  return state;
}

PyDerivative derivative_from(const py::object& state) {
  const auto word = [&](const char* name) { return py::cast<std::string>(state[name]); };
  MetricDerivative of;
  of.value.value = py::cast<double>(state["value"]);
  of.value.status = from_word(word("status"), MetricStatus::wear_localizes);
  of.smoothness = from_word(word("smoothness"), Smoothness::undefined);
  for (const ParameterInfo& row : parameter_table())
    of.gradient[index_of(row.parameter)] = py::cast<double>(state["gradient"][to_py(row.name)]);
  return {of};
}

// The value with the derivatives that are not 0.
std::string derivative_text(const PyDerivative& self) {
  if (self.of.value.status != MetricStatus::ok)
    return "<twum.Derivative: no value, " + std::string(to_string(self.of.value.status)) + ">";
  std::string text = "<twum.Derivative of " + io::number_text(self.of.value.value) + ", " +
                     to_string(self.of.smoothness) + ":";
  for (const ParameterInfo& row : parameter_table()) {
    const double slope = self.of.gradient[index_of(row.parameter)];
    if (slope != 0) text += " " + std::string(row.name) + " " + io::rounded_text(slope, 4);
  }
  return text + ">";
}

void add_derivative(py::module_& module) {
  py::class_<PyDerivative> derivative(
      module, "Derivative",
      "A metric with its exact derivatives with respect to every parameter, SI units. "
      "derivative['thickness']\n"
      "is one of them; it is 0 for a parameter that is not in use.");
  derivative.def_property_readonly(
      "value", [](const PyDerivative& d) { return d.of.value.value; },
      "The metric; NaN unless status is 'ok'.");
  derivative.def_property_readonly(
      "status", [](const PyDerivative& d) { return to_string(d.of.value.status); },
      "'ok', or the short reason why there is no value.");
  derivative.def_property_readonly(
      "smoothness", [](const PyDerivative& d) { return to_string(d.of.smoothness); },
      "What the derivatives can be trusted for: 'smooth', 'flat', 'one-sided' or 'undefined'.");
  derivative.def_property_readonly("gradient", &gradient_dict,
                                   "Every derivative by the name of its parameter.");
  derivative.def("__getitem__", &entry_of, py::arg("parameter"));
  derivative.def("__repr__", &derivative_text);
  add_pickling(derivative, derivative_state, derivative_from);
}

}  // namespace

void add_answer_classes(py::module_& module) {
  add_operating_point(module);
  add_derivative(module);
}

}  // namespace twum::inline v0_1::python
