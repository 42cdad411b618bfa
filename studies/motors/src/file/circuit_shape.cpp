// SPDX-License-Identifier: Apache-2.0
#include "file/circuit_shape.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

namespace twum::inline v0_1::motors {
namespace {

constexpr const char* kCircuit = "equivalent_circuit";

Shape<double> positive(std::string text, std::string unit, std::string example) {
  Schema schema = quantity(std::move(text), std::move(unit), std::move(example)).schema;
  schema.min = 0;
  schema.min_excluded = true;
  return number(std::move(schema));
}

std::string entry_name(Parameter parameter) { return std::string(info(parameter).name); }

}  // namespace

const Shape<EquivalentCircuit>& circuit_shape() {
  using C = EquivalentCircuit;
  static const Shape<C> shape = mapping<C>(
      "circuit of a phase of the free stator, as an impedance analyser gives it; instead of the "
      "modal data",
      {required<C>("motional_resistance", positive("R_m of the series branch", "ohm", "132 ohm"),
                   &C::motional_resistance),
       required<C>("motional_inductance", positive("L_m of the series branch", "H", "82.6 mH"),
                   &C::motional_inductance),
       required<C>("motional_capacitance", positive("C_m of the series branch", "F", "0.2015 nF"),
                   &C::motional_capacitance),
       required<C>("blocked_capacitance", positive("C_0 in parallel with it", "F", "8.5 nF"),
                   &C::blocked_capacitance),
       required<C>(
           "force_factor",
           positive("modal force of a phase per volt; it does not follow from the impedance", "N/V",
                    "0.55 N/V"),
           &C::force_factor)});
  return shape;
}

bool check_circuit(const std::optional<EquivalentCircuit>& circuit, const Given& stator,
                   Diagnostics& diagnostics) {
  const YamlNode* node = stator.find(kCircuit);
  if (node == nullptr) return true;
  bool good = true;
  for (const Parameter modal :
       {Parameter::resonance_frequency, Parameter::modal_mass, Parameter::quality_factor,
        Parameter::modal_damping, Parameter::force_factor, Parameter::blocked_capacitance}) {
    const YamlNode* beside = stator.find(entry_name(modal));
    if (beside == nullptr) continue;
    diagnostics.add(
        {beside->mark, stator.path(entry_name(modal)), "follows from 'equivalent_circuit' already",
         "give the circuit or the modal data, not both", node->mark, "circuit given here"});
    good = false;
  }
  if (stator.right(kCircuit) == nullptr) return good;
  for (const auto& [parameter, value] : modal_data(*circuit)) {
    const std::string wrong = complaint(parameter, value);
    if (wrong.empty()) continue;
    const std::string shown = engineering(value, info(parameter).unit);
    diagnostics.add(node->mark, stator.path(kCircuit),
                    "the circuit gives a " + entry_name(parameter) + " of " + shown + ", which " +
                        wrong.substr(0, wrong.find(", but ")),
                    "correct the values or their units");
    good = false;
  }
  return good;
}

}  // namespace twum::inline v0_1::motors
