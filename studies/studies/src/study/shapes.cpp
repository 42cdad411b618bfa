// SPDX-License-Identifier: Apache-2.0
#include "study/shapes.hpp"

#include "study/solver_entry.hpp"

#include <twum/studies/metrics/constraint.hpp>
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/motor/motor_file.hpp>

#include <utility>

namespace twum::studies::shapes {
namespace {

SchemaEntry entry(std::string name, Schema schema, bool required) {
  SchemaEntry result;
  result.name = std::move(name);
  result.schema = std::move(schema);
  result.required = required;
  return result;
}

Schema of_kind(ValueKind kind, std::string text) {
  Schema schema;
  schema.kind = kind;
  schema.text = std::move(text);
  return schema;
}

Schema checked_text(std::string text, std::string example, void (*check)(std::string_view)) {
  Schema schema = of_kind(ValueKind::text, std::move(text));
  schema.example = std::move(example);
  schema.check = check;
  return schema;
}

// A standard deviation has the parameter's unit but not its range: more than 0.
Schema spread_of(const ParameterInfo& parameter) {
  Schema schema = value_of(parameter);
  schema.text = "standard deviation";
  schema.min = 0;
  schema.min_excluded = true;
  schema.whole = false;
  return schema;
}

Schema with_word(const char* name, std::vector<SchemaEntry> entries) {
  entries.insert(entries.begin(), needed("distribution", word("its shape", {name})));
  return mapping("", std::move(entries));
}

}  // namespace

SchemaEntry needed(std::string name, Schema schema) {
  return entry(std::move(name), std::move(schema), true);
}

SchemaEntry optional(std::string name, Schema schema, std::string fallback) {
  SchemaEntry result = entry(std::move(name), std::move(schema), false);
  result.fallback = std::move(fallback);
  return result;
}

SchemaEntry hidden(SchemaEntry entry) {
  entry.shown = false;
  return entry;
}

SchemaEntry either(std::string name, Schema schema, std::string other) {
  SchemaEntry result = entry(std::move(name), std::move(schema), true);
  result.twin = std::move(other);
  return result;
}

SchemaEntry instead(std::string name, Schema schema, std::string other) {
  SchemaEntry result = entry(std::move(name), std::move(schema), false);
  result.twin = std::move(other);
  return result;
}

Schema mapping(std::string text, std::vector<SchemaEntry> entries) {
  Schema schema = of_kind(ValueKind::mapping, std::move(text));
  schema.entries = std::move(entries);
  return schema;
}

Schema list(std::string text, Schema item) {
  Schema schema = of_kind(ValueKind::list, std::move(text));
  schema.items.push_back(std::move(item));
  return schema;
}

Schema quantity(std::string text, std::string unit, std::string example) {
  Schema schema = of_kind(ValueKind::quantity, std::move(text));
  schema.unit = std::move(unit);
  schema.example = std::move(example);
  return schema;
}

Schema count(std::string text, std::string example, double least, double most) {
  Schema schema = of_kind(ValueKind::count, std::move(text));
  schema.example = std::move(example);
  schema.min = least;
  schema.max = most;
  return schema;
}

Schema fraction(std::string text, std::string example) {
  Schema schema = quantity(std::move(text), "1", std::move(example));
  schema.min = 0;
  schema.min_excluded = true;
  schema.max = 1 - 1e-12;
  return schema;
}

Schema word(std::string text, std::vector<std::string> words) {
  Schema schema = of_kind(ValueKind::word, std::move(text));
  schema.example = words.front();
  schema.words = std::move(words);
  return schema;
}

Schema path(std::string text, std::string example) {
  return checked_text(std::move(text), std::move(example), nullptr);
}

Schema metric(std::string text) {
  return checked_text(std::move(text), "peak_power",
                      [](std::string_view typed) { parse_metric(typed); });
}

Schema metrics() {
  Schema schema = list("metrics and parameters", metric("a metric"));
  schema.sample = "- stall_torque\n- no_load_speed\n- wear_intensity_at(80 rpm)";
  return schema;
}

Schema constraints() {
  Schema schema = list("limits that must hold",
                       checked_text("a limit", "stall_torque >= 0.8 N.m",
                                    [](std::string_view typed) { parse_constraint(typed); }));
  schema.sample = "- no_load_speed >= 100 rpm\n- max_pressure <= 10 MPa";
  return schema;
}

Schema solver(const char* evaluations) { return solver_schema(evaluations); }

Schema samples() { return count("number of samples", "1000", 1, 1e9); }
Schema seed() { return count("seed of the random numbers", "1", 0, 9007199254740992.0); }
Schema folder() {
  return path("result directory of another study, whose best design or front is the start",
              "results/first");
}

Schema by_parameter(Schema (*shape)(const ParameterInfo&), std::string text, std::string sample) {
  Schema schema = of_kind(ValueKind::mapping, std::move(text));
  schema.sample = std::move(sample);
  for (const ParameterInfo& row : parameter_table()) {
    SchemaEntry one = entry(std::string(row.name), shape(row), false);
    one.alias = row.symbol;
    one.alias_counts = true;
    if (row.twin) one.twin = info(*row.twin).name;
    schema.entries.push_back(std::move(one));
  }
  return schema;
}

Schema value_of(const ParameterInfo& parameter) { return parameter_schema(parameter); }

Schema values_of(const ParameterInfo& parameter) { return list("values", value_of(parameter)); }

Schema range(const ParameterInfo& parameter) {
  return mapping(std::string(parameter.text),
                 {needed("min", value_of(parameter)), needed("max", value_of(parameter)),
                  optional("scale", word("spacing", {"linear", "log"}), "linear"),
                  optional("start", value_of(parameter), "the motor's own value")});
}

Schema sweep_range(const ParameterInfo& parameter) {
  Schema limits = mapping(std::string(parameter.text),
                          {needed("min", value_of(parameter)), needed("max", value_of(parameter)),
                           optional("points", count("grid points", "5", 2, 1e6), "5, for a grid"),
                           optional("scale", word("spacing", {"linear", "log"}), "linear")});
  Schema schema = of_kind(ValueKind::any_of, std::string(parameter.text));
  schema.alternatives = {values_of(parameter), std::move(limits)};
  return schema;
}

Schema distribution(const ParameterInfo& parameter) {
  const Schema value = value_of(parameter);
  Schema schema = of_kind(ValueKind::variant, std::string(parameter.text));
  schema.selector = "distribution";
  schema.words = {"normal", "uniform", "lognormal", "triangular"};
  const Schema spread = spread_of(parameter);
  schema.alternatives = {
      with_word("normal", {needed("mean", value), needed("sd", spread)}),
      with_word("uniform", {needed("min", value), needed("max", value)}),
      with_word("lognormal", {needed("mean", value), needed("sd", spread)}),
      with_word("triangular", {needed("min", value), needed("mode", value), needed("max", value)})};
  return schema;
}

}  // namespace twum::studies::shapes
