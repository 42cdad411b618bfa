// SPDX-License-Identifier: Apache-2.0
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include "design/geometry_rows.hpp"
#include "design/layer_properties.hpp"
#include "design/motor_rows.hpp"
#include "design/plate_numbers.hpp"
#include "design/radial_shape.hpp"

#include <twum/base/dual.hpp>
#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace twum {
namespace {

using P = Parameter;

// Every row, those of the stator's geometry last.
constexpr std::array<ParameterInfo, kParameterCount> kTable = [] {
  std::array<ParameterInfo, kParameterCount> table{};
  std::copy(kMotorRows.begin(), kMotorRows.end(), table.begin());
  std::copy(kGeometryRows.begin(), kGeometryRows.end(), table.begin() + kMotorRows.size());
  for (ParameterInfo& row : table) row.twin = row.alternative;
  return table;
}();

constexpr bool every_parameter_in_its_place() {
  for (std::size_t i = 0; i < kParameterCount; ++i)
    if (index_of(kTable[i].parameter) != i || kTable[i].reason.empty()) return false;
  return true;
}
static_assert(every_parameter_in_its_place(),
              "a parameter has no row of its own, or not in its place");

double or_nan(const std::optional<double>& value) { return value.value_or(kNoValue); }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string with_unit(double value, const ParameterInfo& row) {
  return row.unit == "1" ? number(value) : number(value) + " " + std::string(row.unit);
}

// Creates the block of a parameter if the design has none.
Imbalance& imbalance_of(Stator& stator) {
  if (!stator.imbalance) stator.imbalance.emplace();
  return *stator.imbalance;
}
Sensor& sensor_of(Stator& stator) {
  if (!stator.sensor) stator.sensor.emplace();
  return *stator.sensor;
}

// Sets one parameter and removes its alternative. mu_0 follows mu; a value given for mu_0 is set afterwards.
void set(MotorDesign& design, Parameter parameter, double value) {
  if (std::string wrong = follows_from_geometry(design, parameter); !wrong.empty())
    throw InputError(wrong);
  Stator& stator = design.stator;
  ContactLayer& layer = design.layer;
  Friction& friction = design.friction;
  RadialShape& shape = design.stator.radial_shape;
  switch (parameter) {
    case P::wavelengths: stator.wavelengths = value; break;
    case P::contact_radius: stator.contact_radius = value; break;
    case P::contact_width: stator.contact_width = value; break;
    case P::neutral_plane_distance: stator.neutral_plane_distance = value; break;
    case P::frequency: stator.frequency = value, stator.frequency_ratio.reset(); break;
    case P::frequency_ratio: stator.frequency_ratio = value; break;
    case P::amplitude: stator.amplitude = value, stator.voltage.reset(); break;
    case P::voltage: stator.voltage = value; break;
    case P::modal_damping: stator.modal_damping = value, stator.quality_factor.reset(); break;
    case P::quality_factor: stator.quality_factor = value; break;
    case P::resonance_frequency: stator.resonance_frequency = value; break;
    case P::modal_mass: stator.modal_mass = value; break;
    case P::force_factor: stator.force_factor = value; break;
    case P::blocked_capacitance: stator.blocked_capacitance = value; break;
    case P::loss_tangent: stator.loss_tangent = value; break;
    case P::voltage_ratio: imbalance_of(stator).voltage_ratio = value; break;
    case P::phase_error: imbalance_of(stator).phase_error = value; break;
    case P::mode_splitting: imbalance_of(stator).mode_splitting = value; break;
    case P::sensor_force_factor: sensor_of(stator).force_factor = value; break;
    case P::sensor_capacitance: sensor_of(stator).capacitance = value; break;
    case P::sensor_load_capacitance: sensor_of(stator).load_capacitance = value; break;
    case P::sensor_load_resistance: sensor_of(stator).load_resistance = value; break;
    case P::sensor_position: sensor_of(stator).position = value; break;
    case P::radial_slices: stator.radial_slices = static_cast<int>(value); break;
    case P::shape_exponent: shape.exponent = value, shape.table.clear(); break;
    case P::shape_root: shape.root = value, shape.table.clear(); break;
    case P::thickness: layer.thickness = value; break;
    case P::youngs_modulus: layer.youngs_modulus = value; break;
    case P::poisson_ratio: layer.poisson_ratio = value, layer.given_shear_modulus.reset(); break;
    case P::density: layer.density = value, layer.given_inertia.reset(); break;
    case P::loss_factor: layer.loss_factor = value, layer.given_shear_viscosity.reset(); break;
    case P::shear_modulus: layer.given_shear_modulus = value; break;
    case P::shear_viscosity: layer.given_shear_viscosity = value; break;
    case P::inertia: layer.given_inertia = value; break;
    case P::kinetic_friction:
      friction.static_ = friction_ratio(friction) * value;
      friction.kinetic = value;
      break;
    case P::static_friction: friction.static_ = value; break;
    case P::rotor_taper: design.rotor.taper = value; break;
    case P::rotor_mass: design.rotor.mass = value; break;
    case P::preload: design.preload = value; break;
    default: set_of_geometry(design, parameter, value);
  }
}

// The first contradiction between parameters of a design; empty if there is none.
std::string contradiction(const MotorDesign& design) {
  const Stator& stator = design.stator;
  if (design.friction.static_ < design.friction.kinetic)
    return "static_friction must be at least kinetic_friction = " +
           number(design.friction.kinetic) + ", but is " + number(design.friction.static_);
  if (stator.geometry) {
    if (!stator.voltage || has_modal_data(design)) return {};
    return "voltage needs quality_factor (or modal_damping, more than 0); give it, or amplitude in "
           "place of voltage";
  }
  if (stator.frequency_ratio && !stator.resonance_frequency)
    return "frequency_ratio needs resonance_frequency; give it, or frequency in place of "
           "frequency_ratio";
  if (stator.quality_factor && !(stator.resonance_frequency && stator.modal_mass))
    return "quality_factor needs resonance_frequency and modal_mass; give them, or modal_damping "
           "in "
           "place of quality_factor";
  if (stator.sensor && !(stator.sensor->capacitance + stator.sensor->load_capacitance > 0 ||
                         stator.sensor->load_resistance))
    return "sensor_capacitance must be more than 0 F, or a load on the sensor be given, but is 0 F";
  if (!stator.voltage || has_modal_data(design)) return {};
  std::string missing;
  const auto need = [&missing](bool given, const char* name) {
    if (!given) missing += (missing.empty() ? "" : ", ") + std::string(name);
  };
  need(stator.resonance_frequency.has_value(), "resonance_frequency");
  need(stator.modal_mass.has_value(), "modal_mass");
  need(stator.force_factor.has_value(), "force_factor");
  need(modal_damping(design) > 0, "quality_factor (or modal_damping, more than 0)");
  return "voltage needs " + missing +
         "; give what is missing (in a motor file 'equivalent_circuit' gives all of it), or "
         "amplitude in place of voltage";
}

void refuse_alternatives_together(std::span<const ParameterValue> values) {
  for (const auto& [parameter, value] : values) {
    for (const auto& [other, other_value] : values) {
      if (info(parameter).alternative == other) {
        throw InputError(std::string(info(parameter).name) + " and " +
                         std::string(info(other).name) + " exclude each other; give one of them");
      }
    }
  }
}

}  // namespace

std::span<const ParameterInfo> parameter_table() { return kTable; }

const ParameterInfo& info(Parameter parameter) { return kTable[index_of(parameter)]; }

std::optional<Parameter> find_parameter(std::string_view name_or_symbol) {
  if (name_or_symbol.empty()) return {};
  for (const ParameterInfo& row : kTable) {
    if (row.name == name_or_symbol || row.symbol == name_or_symbol) return row.parameter;
  }
  return {};
}

double get(const MotorDesign& design, Parameter parameter) {
  const Stator& stator = design.stator;
  const ContactLayer& layer = design.layer;
  const auto used = [&] { return in_use(design, parameter); };
  const auto from_plate = plate_number_of(parameter);
  if (from_plate && stator.geometry) return plate_numbers(design)[index_of(*from_plate)];
  switch (parameter) {
    case P::wavelengths: return stator.wavelengths;
    case P::contact_radius: return stator.contact_radius;
    case P::contact_width: return stator.contact_width;
    case P::neutral_plane_distance: return stator.neutral_plane_distance;
    case P::frequency: return drive_frequency(design);
    case P::frequency_ratio:
      return used() ? *stator.frequency_ratio
                    : stator.frequency / get(design, P::resonance_frequency);
    case P::amplitude: return used() ? stator.amplitude : kNoValue;
    case P::voltage: return or_nan(stator.voltage);
    case P::modal_damping: return modal_damping(design);
    case P::quality_factor:
      return used() ? *stator.quality_factor
                    : modal_damping_of(stator.modal_damping, get(design, P::resonance_frequency),
                                       get(design, P::modal_mass));
    case P::resonance_frequency: return or_nan(stator.resonance_frequency);
    case P::modal_mass: return or_nan(stator.modal_mass);
    case P::force_factor: return or_nan(stator.force_factor);
    case P::blocked_capacitance: return stator.blocked_capacitance;
    case P::loss_tangent: return stator.loss_tangent;
    case P::voltage_ratio: return stator.imbalance.value_or(Imbalance{}).voltage_ratio;
    case P::phase_error: return stator.imbalance.value_or(Imbalance{}).phase_error;
    case P::mode_splitting: return stator.imbalance.value_or(Imbalance{}).mode_splitting;
    case P::sensor_force_factor: return used() ? stator.sensor->force_factor : kNoValue;
    case P::sensor_capacitance: return used() ? stator.sensor->capacitance : kNoValue;
    case P::sensor_load_capacitance: return used() ? stator.sensor->load_capacitance : kNoValue;
    case P::sensor_load_resistance: return used() ? *stator.sensor->load_resistance : kNoValue;
    case P::sensor_position: return used() ? stator.sensor->position : kNoValue;
    case P::radial_slices: return stator.radial_slices;
    case P::shape_exponent: return stator.radial_shape.exponent;
    case P::shape_root: return stator.radial_shape.root;
    case P::thickness: return layer.thickness;
    case P::youngs_modulus: return layer.youngs_modulus;
    case P::poisson_ratio:
      return used() ? layer.poisson_ratio
                    : poisson_ratio_of(layer.youngs_modulus, shear_modulus(design));
    case P::density: return used() ? layer.density : density_of(inertia(design), layer.thickness);
    case P::loss_factor:
      return used() ? layer.loss_factor
                    : loss_factor_of(shear_viscosity(design), shear_modulus(design),
                                     2 * std::numbers::pi * drive_frequency(design));
    case P::shear_modulus: return shear_modulus(design);
    case P::shear_viscosity: return shear_viscosity(design);
    case P::inertia: return inertia(design);
    case P::kinetic_friction: return design.friction.kinetic;
    case P::static_friction: return design.friction.static_;
    case P::rotor_taper: return design.rotor.taper;
    case P::rotor_mass: return or_nan(design.rotor.mass);
    case P::preload: return design.preload;
    default: return get_of_geometry(design, parameter);
  }
}

bool in_use(const MotorDesign& design, Parameter parameter) {
  const Stator& stator = design.stator;
  const ContactLayer& layer = design.layer;
  const bool sliced = design.stator.radial_slices != 1;
  if (is_of_geometry(parameter)) return in_use_of_geometry(design, parameter);
  if (stator.geometry && plate_number_of(parameter)) return false;
  switch (parameter) {
    case P::radial_slices:
    case P::rotor_taper: return sliced;
    case P::shape_exponent:
    case P::shape_root: return sliced && !stator.geometry && stator.radial_shape.table.empty();
    case P::frequency: return !stator.frequency_ratio;
    case P::frequency_ratio: return stator.frequency_ratio.has_value();
    case P::amplitude: return !stator.voltage;
    case P::voltage: return stator.voltage.has_value();
    case P::modal_damping: return !stator.quality_factor;
    case P::quality_factor: return stator.quality_factor.has_value();
    case P::resonance_frequency: return stator.resonance_frequency.has_value();
    case P::modal_mass: return stator.modal_mass.has_value();
    case P::force_factor:
    case P::blocked_capacitance: return stator.force_factor.has_value();
    case P::loss_tangent: return stator.geometry || stator.force_factor;
    case P::voltage_ratio:
    case P::phase_error:
    case P::mode_splitting: return stator.imbalance.has_value();
    case P::sensor_force_factor:
    case P::sensor_capacitance:
    case P::sensor_load_capacitance:
    case P::sensor_position: return stator.sensor.has_value();
    case P::sensor_load_resistance:
      return stator.sensor.has_value() && stator.sensor->load_resistance.has_value();
    case P::rotor_mass: return design.rotor.mass.has_value();
    case P::poisson_ratio: return !layer.given_shear_modulus;
    case P::shear_modulus: return layer.given_shear_modulus.has_value();
    case P::loss_factor: return !layer.given_shear_viscosity;
    case P::shear_viscosity: return layer.given_shear_viscosity.has_value();
    case P::density: return !layer.given_inertia;
    case P::inertia: return layer.given_inertia.has_value();
    default: return true;
  }
}

bool is_given(const MotorDesign& design, Parameter parameter) {
  if (in_use(design, parameter)) return true;
  switch (parameter) {
    case P::shape_exponent:
    case P::shape_root:
      if (design.stator.geometry || !design.stator.radial_shape.table.empty()) return false;
      [[fallthrough]];
    case P::rotor_taper:
    case P::blocked_capacitance:
    case P::loss_tangent:
      if (design.stator.geometry && plate_number_of(parameter)) return false;
      return get(design, parameter) != 0;
    default: return false;
  }
}

std::string complaint(Parameter parameter, double value) {
  const ParameterInfo& row = info(parameter);
  // called only for an error
  const auto found = [&] { return ", but is " + with_unit(value, row); };
  if (!std::isfinite(value)) return "must be a finite number" + found();
  if (!(value >= row.min)) return "must be at least " + with_unit(row.min, row) + found();
  if (!(value <= row.max)) return "must be at most " + with_unit(row.max, row) + found();
  if (row.integer && value != std::floor(value)) return "must be a whole number" + found();
  return {};
}

void require_admissible(Parameter parameter, double value) {
  const std::string wrong = complaint(parameter, value);
  if (!wrong.empty()) throw InputError(std::string(info(parameter).name) + " " + wrong);
}

MotorDesign with(const MotorDesign& design, std::span<const ParameterValue> values) {
  refuse_alternatives_together(values);
  MotorDesign result = design;
  for (const auto& [parameter, value] : values) {
    require_admissible(parameter, value);
    if (parameter != P::static_friction) set(result, parameter, value);
  }
  for (const auto& [parameter, value] : values) {
    if (parameter == P::static_friction) set(result, parameter, value);
  }
  if (const std::string wrong = contradiction(result); !wrong.empty()) throw InputError(wrong);
  if (const std::string wrong = track_complaint(result); !wrong.empty()) throw InputError(wrong);
  return result;
}

MotorDesign with(const MotorDesign& design, Parameter parameter, double value) {
  const std::array<ParameterValue, 1> one{{{parameter, value}}};
  return with(design, one);
}

std::vector<std::string> complaints(const MotorDesign& design) {
  std::vector<std::string> found;
  for (const ParameterInfo& row : kTable) {
    if (!in_use(design, row.parameter)) continue;
    const std::string wrong = complaint(row.parameter, get(design, row.parameter));
    if (!wrong.empty()) found.push_back(std::string(row.name) + " " + wrong);
  }
  if (std::string wrong = contradiction(design); !wrong.empty()) found.push_back(std::move(wrong));
  if (std::string wrong = track_complaint(design); !wrong.empty())
    found.push_back(std::move(wrong));
  for (std::string& wrong : geometry_complaints(design)) found.push_back(std::move(wrong));
  return found;
}

void require_motor(const MotorDesign& design) {
  std::string text;
  for (const std::string& wrong : complaints(design)) text += (text.empty() ? "" : "; ") + wrong;
  if (!text.empty()) throw InputError("motor design: " + text);
}

}  // namespace twum
