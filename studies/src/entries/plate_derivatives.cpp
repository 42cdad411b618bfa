// SPDX-License-Identifier: Apache-2.0
#include "entries/plate_derivatives.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::studies {
namespace {

// Radii as near as this are one edge of the plate, as a share of its outer radius.
constexpr double kSameEdge = 1e-9;

constexpr Parameter kRadii[] = {
    Parameter::substrate_inner_radius,  Parameter::substrate_outer_radius,
    Parameter::web_inner_radius,        Parameter::web_outer_radius,
    Parameter::teeth_inner_radius,      Parameter::teeth_outer_radius,
    Parameter::ceramic_inner_radius,    Parameter::ceramic_outer_radius,
    Parameter::electrodes_inner_radius, Parameter::electrodes_outer_radius};

bool is_joint(const stator::StatorModel& plate, std::string_view name) {
  return std::any_of(plate.joint_edges.begin(), plate.joint_edges.end(), [=](auto dimension) {
    return stator::dimension_table()[static_cast<std::size_t>(dimension)].name == name;
  });
}

// Nothing if the plate has a derivative in the radius alone.
std::optional<Parameter> radius_beside(const MotorDesign& design, Parameter radius,
                                       const std::vector<DerivedParameter>& derived) {
  if (!is_joint(*plate_model(design, stator::OtherModes::none, stator::Derivatives::none),
                info(radius).name))
    return {};
  return equal_radius(design, radius, derived);
}

// Where the search begins.
template <typename Asked>
MotorDesign first_design(const Asked& asked, const MotorDesign& motor) {
  std::vector<double> values;
  for (const DesignVariable& one : asked.variables)
    values.push_back(std::isnan(one.start) ? get(motor, one.parameter) : one.start);
  return VariedParameters(motor, parameters_of(asked.variables), asked.derived).motor(values);
}

class DerivativeCheck {
 public:
  DerivativeCheck(const YamlNode& root, Diagnostics& diagnostics)
      : variables_(*root.find("study")->find("variables")), diagnostics_(diagnostics) {}

  template <typename Asked>
  void radii(const Asked& asked, const MotorDesign& motor) {
    try {
      const MotorDesign first = first_design(asked, motor);
      for (const DesignVariable& one : asked.variables)
        if (const auto other = radius_beside(first, one.parameter, asked.derived))
          say_of_radius(one.parameter, *other, get(first, one.parameter));
    } catch (const InputError&) {  // not a valid motor; the study itself reports it
    } catch (const EvaluationError&) {
    }
  }

  void wavelengths(const std::vector<DesignVariable>& variables) {
    for (const DesignVariable& one : variables)
      if (one.parameter == Parameter::wavelengths)
        add(one.parameter,
            "a different number of wavelengths is a different mode of the plate, so there is no "
            "derivative",
            "leave it out, and compare numbers of wavelengths with 'kind: sweep'");
  }

 private:
  void say_of_radius(Parameter radius, Parameter other, double place) {
    const std::string name(info(radius).name), beside(info(other).name);
    add(radius,
        "starts at " + engineering(place, "m") + ", the same value as " + beside +
            "; the derivative in one of two equal radii is undefined",
        "move both, with 'derived: {" + beside + ": " + name + "}', or start from another value");
  }

  void add(Parameter parameter, std::string found, std::string expected) {
    const auto entry =
        std::find_if(variables_.entries.begin(), variables_.entries.end(),
                     [=](const YamlEntry& one) { return find_parameter(one.key) == parameter; });
    if (entry == variables_.entries.end()) return;
    diagnostics_.add(entry->key_mark, "study.variables." + entry->key, std::move(found),
                     std::move(expected));
  }

  const YamlNode& variables_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Parameter> equal_radius(const MotorDesign& design, Parameter radius,
                                      const std::vector<DerivedParameter>& derived) {
  if (!design.stator.geometry || std::ranges::find(kRadii, radius) == std::end(kRadii)) return {};
  const double place = get(design, radius),
               same = kSameEdge * get(design, Parameter::substrate_outer_radius);
  for (const Parameter other : kRadii) {
    if (other == radius || !in_use(design, other)) continue;
    const bool follows = std::any_of(derived.begin(), derived.end(),
                                     [=](const auto& one) { return one.parameter == other; });
    if (!follows && std::fabs(get(design, other) - place) <= same) return other;
  }
  return {};
}

void check_plate_derivatives(const Study& study, const MotorDesign& motor, const YamlNode& root,
                             Diagnostics& diagnostics) {
  if (!motor.stator.geometry) return;
  if (const auto* asked = std::get_if<SensitivityStudy>(&study)) {
    if (asked->method != SensitivityMethod::local) return;
    DerivativeCheck check(root, diagnostics);
    check.radii(*asked, motor);
    check.wavelengths(asked->variables);
  }
  const auto of_search = [&](const auto& asked) {
    if constexpr (requires { asked.choose; })
      if (asked.start.empty()) DerivativeCheck(root, diagnostics).radii(asked, motor);
  };
  std::visit(of_search, study);
}

}  // namespace twum::inline v0_1::studies
