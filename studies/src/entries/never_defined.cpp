// SPDX-License-Identifier: Apache-2.0
#include "entries/never_defined.hpp"

#include <twum/base/error.hpp>
#include <twum/core/motion_metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/model_notes.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

// The range of a varied parameter, and the value it has first.
struct Ends {
  Parameter parameter;
  double min, max, first;
};

std::vector<Ends> ranges_of(const Study& study, const MotorDesign& motor) {
  std::vector<Ends> list;
  const auto add = [&](Parameter parameter, double min, double max, double start) {
    const double own = get(motor, parameter);
    const double value = !std::isnan(start) ? start : std::isnan(own) ? 0.5 * (min + max) : own;
    list.push_back({parameter, min, max, value});
  };
  const auto each = [&](const auto& asked) {
    if constexpr (requires { asked.sampling; }) {
      for (const SweepStudy::Variable& one : asked.variables) {
        const auto [low, high] = std::ranges::minmax_element(one.values);
        const bool range = one.values.empty();
        add(one.parameter, range ? one.min : *low, range ? one.max : *high,
            range ? one.min : one.values.front());
      }
    } else if constexpr (requires { asked.variables.front().start; }) {
      for (const DesignVariable& one : asked.variables)
        add(one.parameter, one.min, one.max, one.start);
    }
  };
  std::visit(each, study);
  return list;
}

MotorDesign with_sets(const Study& study, MotorDesign motor) {
  const auto first_sets = [&](const auto& asked) {
    if constexpr (requires { asked.choose; })
      for (const DesignChoice& choice : asked.choose)
        if (!choice.sets.empty()) motor = with(motor, choice.sets.front().values);
  };
  std::visit(first_sets, study);
  return motor;
}

bool starts_from_result(const Study& study) {
  return std::visit(
      [](const auto& asked) {
        if constexpr (requires { asked.start; })
          return !std::string(asked.start).empty();
        else
          return false;
      },
      study);
}

const YamlEntry* entry_of(const YamlNode& variables, Parameter parameter) {
  const auto found = std::ranges::find_if(variables.entries, [=](const YamlEntry& entry) {
    return find_parameter(entry.key) == parameter;
  });
  return found == variables.entries.end() ? nullptr : &*found;
}

constexpr const char* kThermal = "a thermal model; give 'thermal' in the motor file";
constexpr const char* kOperation =
    "an operation; give 'operation' in the motor file, such as [{torque: 0.5 N.m, time: 60 s}, "
    "{idle: 100 s}]";

constexpr const char* kWear =
    "wear data; give 'wear' in the motor file, such as {specific_wear: 1e-6 mm^3/(N.m), "
    "depth_limit: 100 um}";

// What worn() in a text lacks: the wear, or an operation where no load is named.
std::string missing_for_worn(const MotorDesign& motor, std::string_view from_worn) {
  if (!motor.wear) return kWear;
  int depth = 0;
  const bool named = std::ranges::any_of(from_worn.substr(5), [&](char c) {
    depth += (c == '(') - (c == ')');
    return depth == 0 && c == ',';
  });
  if (named || !motor.operation.empty()) return {};
  return std::string(kOperation) + ", or name a load, as in worn(stall_torque, 0.5 N.m)";
}

// What warm() in a text lacks: the ways of the heat, or an operation where no point is named.
std::string missing_for_warm(const MotorDesign& motor, std::string_view from_warm) {
  if (!motor.thermal) return kThermal;
  const std::string_view inside = from_warm.substr(0, from_warm.find_first_of("),", 5));
  const bool named = from_warm.substr(inside.size()).starts_with(',') ||
                     inside.find('(', 5) != std::string_view::npos;
  if (named || !motor.operation.empty()) return {};
  return std::string(kOperation) + ", or name a point, as in warm(stall_torque, 0.5 N.m)";
}

bool has_temperature_limit(const Thermal& thermal) {
  return thermal.stator.temperature_limit || thermal.rotor.temperature_limit ||
         thermal.housing.temperature_limit || thermal.contact_temperature_limit;
}

constexpr const char* kIntegrator =
    "an integrator; this twum was built without SUNDIALS: install libsundials-dev and build it "
    "again";

std::string missing_for_motion(const MotorDesign& motor, Metric metric) {
  if (!has_motion_metrics()) return kIntegrator;
  if (!motor.rotor.inertia)
    return "the rotor's inertia; give 'inertia' under 'rotor' in the motor file, such as 7e-6 "
           "kg.m^2";
  if (metric == Metric::bounce_rate_at && !motor.rotor.mass)
    return "the rotor's mass; give 'mass' under 'rotor' in the motor file, such as 0.1 kg";
  const bool of_start = metric == Metric::start_time_at || metric == Metric::start_overshoot_at;
  if (!of_start && !motor.stator.voltage)
    return "a drive voltage; give 'voltage' instead of 'amplitude' in the motor file";
  return {};
}

// What a motor has to give so that a metric has a meaning; empty if it gives it.
std::string missing_for(const MotorDesign& motor, Metric metric) {
  const MetricInfo& row = info(metric);
  if (row.needs_geometry && !motor.stator.geometry)
    return "the geometry of the stator; give 'geometry' under 'stator' in the motor file";
  if (row.needs_modes && !has_modal_data(motor))
    return "modal data; give resonance_frequency, modal_mass, force_factor and quality_factor, or "
           "a "
           "geometry, under 'stator' in the motor file";
  if (row.needs_thermal && !motor.thermal) return kThermal;
  if (row.needs_wear && !motor.wear) return kWear;
  if (wears_freely(motor) && is_of_life({metric}) && !has_motion_metrics())
    return std::string(kIntegrator) + ", or give 'profile: even' under 'wear' in the motor file";
  if (row.needs_operation && motor.operation.empty()) return kOperation;
  if (row.needs_motion) {
    const std::string missing = missing_for_motion(motor, metric);
    if (!missing.empty()) return missing;
  }
  const bool limits = metric == Metric::temperature_margin_at || metric == Metric::on_time_at ||
                      metric == Metric::duty_limit_at;
  if (limits && !has_temperature_limit(*motor.thermal))
    return "a temperature limit; give 'limit' under stator, rotor, housing or contact of 'thermal' "
           "in the motor file";
  const bool signal = metric == Metric::sensor_voltage_at || metric == Metric::sensor_phase_at;
  if (signal && !motor.stator.sensor)
    return "a sensor; give 'sensor' under 'stator' in the motor file";
  const bool limit_of_voltage = metric == Metric::pull_out_torque ||
                                metric == Metric::start_frequency ||
                                metric == Metric::pull_out_frequency;
  if (limit_of_voltage && !motor.stator.voltage)
    return "a drive voltage; give 'voltage' instead of 'amplitude' in the motor file";
  return {};
}

// Calls `use` with every metric that is named in a text, and its place there.
void for_each_metric(std::string_view text, const std::function<void(Metric, std::size_t)>& use) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = 0; at < text.size();) {
    if (!in_word(text[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && in_word(text[at])) ++at;
    if (const auto metric = find_metric(text.substr(begin, at - begin))) use(*metric, begin);
  }
}

class DefinedCheck {
 public:
  DefinedCheck(const MotorDesign& motor, Diagnostics& diagnostics)
      : motor_(motor), diagnostics_(diagnostics) {}

  void look(const YamlNode& node, const std::string& path) {
    if (node.kind == YamlNode::Kind::scalar) return look_at(node, path);
    for (const YamlEntry& entry : node.entries)
      if (!names_other_things(entry.key)) look(entry.value, path + "." + entry.key);
    for (std::size_t i = 0; i < node.items.size(); ++i)
      look(node.items[i], path + "[" + std::to_string(i) + "]");
  }

 private:
  // Their texts name no metric.
  static bool names_other_things(std::string_view key) {
    return key == "kind" || key == "data" || key == "start" || key == "choose" ||
           key == "variables";
  }

  using Missing = std::string (*)(const MotorDesign& motor, std::string_view from_word);

  void look_for(std::string_view word, Missing missing_for, const YamlNode& node,
                const std::string& path) {
    for (std::size_t at = node.scalar.find(word); at != std::string::npos;
         at = node.scalar.find(word, at + 1)) {
      const std::string missing = missing_for(motor_, std::string_view(node.scalar).substr(at));
      if (!missing.empty())
        diagnostics_.add(diagnostics_.source().mark_within(node.mark, node.scalar, at), path,
                         std::string(word) + ") has no value for this motor",
                         "it needs " + missing);
    }
  }

  void look_at(const YamlNode& node, const std::string& path) {
    look_for("warm(", missing_for_warm, node, path);
    look_for("worn(", missing_for_worn, node, path);
    for_each_metric(node.scalar, [&](Metric metric, std::size_t at) {
      const std::string missing = missing_for(motor_, metric);
      if (missing.empty()) return;
      diagnostics_.add(diagnostics_.source().mark_within(node.mark, node.scalar, at), path,
                       std::string(info(metric).name) + " has no value for this motor",
                       "it needs " + missing);
    });
  }

  const MotorDesign& motor_;
  Diagnostics& diagnostics_;
};

// The motor with its varied parameters; adds an error for one that lacks what it needs ("voltage needs modal_mass; ...").
std::optional<MotorDesign> varied_motor(const std::vector<Ends>& ranges, const MotorDesign& motor,
                                        const YamlNode& variables, Diagnostics& diagnostics) {
  std::vector<ParameterValue> values;
  for (const Ends& one : ranges) values.emplace_back(one.parameter, one.first);
  try {
    return with(motor, values);
  } catch (const InputError& error) {
    const std::string text = error.what();
    const std::size_t needs = text.find(" needs ");
    if (needs == std::string::npos)
      return {};  // values that do not fit each other; a search finds others
    const auto parameter = find_parameter(text.substr(0, needs));
    const YamlEntry* entry = parameter ? entry_of(variables, *parameter) : nullptr;
    if (entry == nullptr) return {};
    const std::size_t remedy = text.find("; ");
    diagnostics.add(entry->key_mark, "study.variables." + entry->key, text.substr(0, remedy),
                    remedy == std::string::npos ? "" : text.substr(remedy + 2));
    return {};
  }
}

// The note on the value of a parameter beyond the tested range; empty if there is none.
std::string range_note(const MotorDesign& motor, Parameter parameter, double value) {
  try {
    return tested_range_note(with(motor, parameter, value), parameter);
  } catch (const InputError&) {
  } catch (const EvaluationError&) {
  }
  return {};
}

// The end of a range as typed with another prefix, with which it would be usual: "2.2 um" for "2.2 mm".
std::string usual_spelling(const MotorDesign& motor, const Ends& range, double value,
                           std::string_view typed) {
  const std::size_t unit_at = typed.find_first_not_of("+-0123456789.eE ");
  if (unit_at == std::string_view::npos || info(range.parameter).unit == "1") return {};
  const std::string_view unit = typed.substr(unit_at);
  struct Prefix {
    std::string_view sign;
    double factor;
  };
  constexpr Prefix kPrefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"m", 1e-3}, {"", 1},
                                  {"k", 1e3},  {"M", 1e6},  {"G", 1e9}};
  const std::string_view base = info(range.parameter).unit;
  for (const Prefix& own : kPrefixes) {
    if (unit != std::string(own.sign) + std::string(base)) continue;
    for (const Prefix& other : kPrefixes)
      if (other.sign != own.sign &&
          range_note(motor, range.parameter, value / own.factor * other.factor).empty())
        return std::string(typed.substr(0, unit_at)) + std::string(other.sign) + std::string(base);
  }
  return {};
}

}  // namespace

void check_defined(const Study& study, const MotorDesign& motor, const YamlNode& root,
                   Diagnostics& diagnostics) {
  if (starts_from_result(study))
    return;  // the motor of the other study, checked when this one runs
  const YamlNode& node = *root.find("study");
  static const YamlNode kNothing;
  const YamlNode* variables = node.find("variables");
  try {
    const MotorDesign with_choice = with_sets(study, motor);
    const std::optional<MotorDesign> varied =
        varied_motor(ranges_of(study, with_choice), with_choice,
                     variables == nullptr ? kNothing : *variables, diagnostics);
    if (diagnostics.empty()) {
      const MotorDesign& checked = varied ? *varied : with_choice;
      DefinedCheck(checked, diagnostics).look(node, "study");
    }
  } catch (const InputError&) {  // a set that does not fit; the search itself reports it
  }
}

std::vector<std::string> range_notes(const Study& study, const MotorDesign& motor,
                                     const YamlNode& study_node, const std::string& path) {
  const YamlNode* variables = study_node.find("variables");
  std::vector<std::string> notes;
  if (variables == nullptr) return notes;
  for (const Ends& range : ranges_of(study, motor)) {
    const YamlEntry* entry = entry_of(*variables, range.parameter);
    if (entry == nullptr ||
        !range_note(motor, range.parameter, get(motor, range.parameter)).empty())
      continue;
    for (const auto& [name, value] : {std::pair{"min", range.min}, {"max", range.max}}) {
      const std::string note = range_note(motor, range.parameter, value);
      if (note.empty()) continue;
      const YamlNode* end = entry->value.find(name);
      const YamlNode& at = end == nullptr ? entry->value : *end;
      const std::string usual =
          end == nullptr ? "" : usual_spelling(motor, range, value, end->scalar);
      notes.push_back(printable(path, 200) + ":" + std::to_string(at.mark.line) + ": " + note +
                      (usual.empty() ? "" : "; did you mean '" + usual + "'?"));
    }
  }
  return notes;
}

}  // namespace twum::inline v0_1::studies
