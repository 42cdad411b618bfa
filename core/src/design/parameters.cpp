// SPDX-License-Identifier: Apache-2.0
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/plate.hpp>

#include "design/geometry_rows.hpp"
#include "design/layer_properties.hpp"
#include "design/motion_rows.hpp"
#include "design/motor_rows.hpp"
#include "design/plate_numbers.hpp"
#include "design/radial_shape.hpp"
#include "design/wear_design.hpp"
#include "design/wear_rows.hpp"

#include <twum/base/dual.hpp>
#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace twum::inline v0_1 {
namespace {

using P = Parameter;

// Every row, those of the stator's geometry last.
constexpr auto kRows = [] {
  std::array<ParameterRow, kMotorRows.size() + kThermalRows.size() + kWearRows.size() +
                               kMotionRows.size() + kGeometryRows.size()>
      rows{};
  auto next = std::copy(kMotorRows.begin(), kMotorRows.end(), rows.begin());
  next = std::copy(kThermalRows.begin(), kThermalRows.end(), next);
  next = std::copy(kWearRows.begin(), kWearRows.end(), next);
  next = std::copy(kMotionRows.begin(), kMotionRows.end(), next);
  std::copy(kGeometryRows.begin(), kGeometryRows.end(), next);
  return rows;
}();
static_assert(kRows.size() == kParameterCount, "a parameter has no row");

// A page has the texts besides (parameters_json()), and its core does without them.
constexpr auto kTable = [] {
  std::array<ParameterInfo, kParameterCount> table{};
  std::transform(kRows.begin(), kRows.end(), table.begin(), [](const auto& row) {
    ParameterInfo info = row.info;
#ifdef TWUM_WITHOUT_TEXTS
    info.file_entry = info.example = info.text = info.reason = info.fallback = {};
#endif
    return info;
  });
  return table;
}();

// Of what is asked of every parameter of every motor: apart from the texts it stays in the processor's cache.
struct Range {
  double min, max;
  bool integer;

  bool holds(double value) const {
    return std::isfinite(value) && value >= min && value <= max &&
           (!integer || value == std::floor(value));
  }
};

constexpr auto kRanges = [] {
  std::array<Range, kParameterCount> ranges{};
  std::transform(kRows.begin(), kRows.end(), ranges.begin(), [](const auto& row) {
    return Range{row.info.min, row.info.max, row.info.integer};
  });
  return ranges;
}();

constexpr auto kPlaces = [] {
  std::array<ParameterPlace, kParameterCount> places{};
  std::transform(kRows.begin(), kRows.end(), places.begin(),
                 [](const auto& row) { return row.place; });
  return places;
}();

constexpr bool every_parameter_in_its_place() {
  for (std::size_t i = 0; i < kParameterCount; ++i)
    if (index_of(kRows[i].info.parameter) != i || kRows[i].info.reason.empty()) return false;
  return true;
}
static_assert(every_parameter_in_its_place(), "the rows have another order than the parameters");

const ParameterPlace& place_of(Parameter parameter) { return kPlaces[index_of(parameter)]; }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string with_unit(double value, const ParameterInfo& row) {
  return row.unit == "1" ? number(value) : number(value) + " " + std::string(row.unit);
}

std::string block_of(Parameter parameter) {
  const std::string_view name = info(parameter).name;
  return std::string(name.substr(0, name.find('_')));
}

// Sets one parameter and removes its alternative. mu_0 follows mu; a value given for mu_0 is set afterwards.
void set(MotorDesign& design, Parameter parameter, double value) {
  if (std::string wrong = follows_from_geometry(design, parameter); !wrong.empty())
    throw InputError(wrong);
  if (place_of(parameter).set(design, value)) return;
  const std::string name(info(parameter).name);
  throw InputError(design.stator.geometry
                       ? name + " needs a stator with the block '" + block_of(parameter) +
                             "' in its geometry"
                       : name +
                             " needs a stator that is given by its geometry; this one is given "
                             "by its modal data");
}

// The first contradiction between parameters of a design; empty if there is none.
std::string contradiction(const MotorDesign& design) {
  const Stator& stator = design.stator;
  if (design.friction.threshold < design.friction.kinetic)
    return "static_friction must be at least kinetic_friction = " +
           number(design.friction.kinetic) + ", but is " + number(design.friction.threshold);
  if (std::string wrong = thermal_complaint(design); !wrong.empty()) return wrong;
  if (std::string wrong = operation_complaint(design); !wrong.empty()) return wrong;
  if (std::string wrong = wear_complaint(design); !wrong.empty()) return wrong;
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
  const ParameterPlace& place = place_of(parameter);
  return place.plate && design.stator.geometry ? plate_numbers(design)[index_of(*place.plate)]
                                               : place.get(design);
}

namespace {

bool in_use(const ParameterPlace& place, const MotorDesign& design, double value) {
  return place.in_use != nullptr ? place.in_use(design) : !std::isnan(value);
}

}  // namespace

bool in_use(const MotorDesign& design, Parameter parameter) {
  const ParameterPlace& place = place_of(parameter);
  if (place.plate && design.stator.geometry) return false;
  return in_use(place, design, place.get(design));
}

bool is_given(const MotorDesign& design, Parameter parameter) {
  if (in_use(design, parameter)) return true;
  const auto in_reserve = place_of(parameter).in_reserve;
  return in_reserve != nullptr && in_reserve(design) && get(design, parameter) != 0;
}

std::optional<PlateNumber> plate_number_of(Parameter parameter) {
  return place_of(parameter).plate;
}

std::optional<stator::Dimension> dimension_of(Parameter parameter) {
  return place_of(parameter).dimension;
}

std::string complaint(Parameter parameter, double value) {
  const ParameterInfo& row = info(parameter);
  if (kRanges[index_of(parameter)].holds(value)) return {};
  // called only for an error
  const auto found = [&] { return ", but is " + with_unit(value, row); };
  if (!std::isfinite(value)) return "must be a finite number" + found();
  if (!(value >= row.min)) return "must be at least " + with_unit(row.min, row) + found();
  if (!(value <= row.max)) return "must be at most " + with_unit(row.max, row) + found();
  return "must be a whole number" + found();
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
  keep_plate(result);
  if (const std::string wrong = contradiction(result); !wrong.empty()) throw InputError(wrong);
  if (const std::string wrong = track_complaint(result); !wrong.empty()) throw InputError(wrong);
  return result;
}

MotorDesign with(const MotorDesign& design, Parameter parameter, double value) {
  const std::array<ParameterValue, 1> one{{{parameter, value}}};
  return with(design, one);
}

namespace {

// Every point asks this of every parameter. With the row known to the compiler it takes a third of the time.
template <std::size_t row>
void check_range(const MotorDesign& design, std::vector<std::string>& complaints) {
  constexpr ParameterPlace place = kPlaces[row];
  if (place.plate && design.stator.geometry) return;
  const double value = place.get(design);
  if (kRanges[row].holds(value) || !in_use(place, design, value)) return;
  complaints.push_back(std::string(kTable[row].name) + " " +
                       complaint(kTable[row].parameter, value));
}

template <std::size_t... rows>
void check_ranges(const MotorDesign& design, std::vector<std::string>& complaints,
                  std::index_sequence<rows...>) {
  (check_range<rows>(design, complaints), ...);
}

}  // namespace

std::vector<std::string> complaints(const MotorDesign& design) {
  std::vector<std::string> found;
  check_ranges(design, found, std::make_index_sequence<kParameterCount>());
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

}  // namespace twum::inline v0_1
