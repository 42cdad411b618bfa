// SPDX-License-Identifier: Apache-2.0
#include "entries/tolerance_shape.hpp"

#include "schema/scalar_checks.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies::shapes {
namespace {

using Shape_ = Tolerance::Shape;

constexpr const char* kTolerances =
    "preload: 5 %\n"
    "kinetic_friction: {range: 15 %}";

// A spread has the parameter's unit but not its range: more than 0.
Schema absolute_spread(const ParameterInfo& row) {
  Schema schema = parameter_schema(row);
  schema.min = 0;
  schema.min_excluded = true;
  schema.whole = false;
  schema.absolute = false;  // a difference
  return schema;
}

Schema relative_spread() {
  Schema schema;
  schema.kind = ValueKind::quantity;
  schema.example = "3 %";
  schema.min = 0;
  schema.min_excluded = true;
  return schema;
}

// "3 %" is relative to the design's value; a number with a unit is absolute.
Shape<Spread> spread(const ParameterInfo& row, std::string text) {
  Shape<Spread> shape;
  shape.schema.text = std::move(text);
  shape.schema.example = "3 %";
  shape.read = [schema = shape.schema, absolute = kept(absolute_spread(row))](
                   Spread& into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    return says_no_error(node, schema, spot, diagnostics, [&](const std::string& typed) {
      const std::string_view value = trimmed(typed);
      const bool relative = !value.empty() && value.back() == '%';
      into = {read_number(value, relative ? relative_spread() : *absolute), relative};
    });
  };
  shape.write = [absolute = number(absolute_spread(row)).write](const Spread& value) {
    return value.relative ? scalar_node(number_text(100 * value.amount) + " %")
                          : absolute(value.amount);
  };
  return shape;
}

// The entries that a distribution may have: about a centre, or between limits.
struct Entries {
  std::vector<std::string_view> about, between;
};

Entries entries_of(Shape_ shape) {
  switch (shape) {
    case Shape_::normal:
    case Shape_::lognormal: return {{"sd"}, {}};
    case Shape_::uniform: return {{"range"}, {"min", "max"}};
    case Shape_::truncated:
    case Shape_::beta: return {{"sd", "from", "to"}, {}};
    case Shape_::weibull: return {{"sd"}, {}};
    case Shape_::triangular: break;
  }
  return {{"below", "above"}, {"min", "mode", "max"}};
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "'" : i + 1 < names.size() ? ", '" : " and '") + std::string(names[i]) + "'";
  return text;
}

std::string wanted(const Entries& entries) {
  return "expected " + joined(entries.about) +
         (entries.between.empty() ? "" : ", or " + joined(entries.between));
}

bool has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Adds errors for entries that a distribution of this shape does not use, and for missing ones.
bool check_entries(Shape_ shape, const Given& given, Diagnostics& diagnostics) {
  const Entries entries = entries_of(shape);
  const std::string of = std::string("of a ") + to_string(shape) + " distribution";
  const auto any = [&](const auto& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return given.find(name) != nullptr; });
  };
  const bool between = any(entries.between) && !any(entries.about);
  const std::vector<std::string_view>& own = between ? entries.between : entries.about;
  const bool two_ends = given.find("min") != nullptr && given.find("max") != nullptr;
  if (two_ends && given.find("distribution") == nullptr && !any(entries.about)) {
    diagnostics.add(given.node().mark, given.path(), "two ends without a distribution",
                    "add 'distribution: uniform', or with 'mode' triangular");
    return false;
  }
  bool good = true;
  for (const YamlEntry& entry : given.node().entries) {
    const bool known =
        entry.key == "distribution" || has(own, entry.key) || (!between && entry.key == "mean");
    if (known || !has({"mean", "sd", "range", "below", "above", "min", "mode", "max", "from", "to"},
                      entry.key))
      continue;
    diagnostics.add(entry.key_mark, given.path(entry.key),
                    "does not describe a " + std::string(to_string(shape)) + " distribution",
                    wanted(entries));
    good = false;
  }
  for (const std::string_view name : own) {
    if (given.find(name) != nullptr) continue;
    diagnostics.add(given.node().mark, given.path(std::string(name)), "missing",
                    wanted(entries) + " " + of);
    good = false;
  }
  return good;
}

bool check_order(const Tolerance& value, const Given& given, Diagnostics& diagnostics) {
  const auto rises = [&](const char* low, const auto& a, const char* high, const auto& b) {
    const bool both = given.right(low) != nullptr && given.right(high) != nullptr;
    return !both || rising(given, low, *a, high, *b, diagnostics);
  };
  if (value.shape == Shape_::uniform) return rises("min", value.min, "max", value.max);
  if (value.shape == Shape_::truncated || value.shape == Shape_::beta)
    return rises("from", value.from, "to", value.to);
  if (value.shape != Shape_::triangular) return true;
  const bool low = rises("min", value.min, "mode", value.mode);
  return rises("mode", value.mode, "max", value.max) && low;
}

Shape<Tolerance> spelled_out(const ParameterInfo& row) {
  using T = Tolerance;
  const auto number = [&](const char* name, const char* text, auto member, std::string fallback) {
    return optional<T>(name, value_of(row, text), member, std::move(fallback));
  };
  const auto width = [&](const char* name, const char* text, auto member) {
    return optional<T>(name, spread(row, text), member, "none");
  };
  T fresh;
  fresh.parameter = row.parameter;
  return mapping<T>(
      std::string(row.text),
      {optional<T>("distribution",
                   word<Shape_>("distribution of the values",
                                {"normal", "uniform", "lognormal", "triangular", "truncated",
                                 "weibull", "beta"}),
                   &T::shape, "normal; with 'range' uniform"),
       number("mean", "mean; for triangular the most likely value", &T::mean, "the design's value"),
       width("sd", "standard deviation; not for uniform and triangular", &T::sd),
       width("range", "half width; for uniform", &T::range),
       width("below", "width below the design's value; for triangular", &T::below),
       width("above", "width above the design's value; for triangular", &T::above),
       number("min", "smallest value; for uniform and triangular", &T::min, "none"),
       number("mode", "most likely value; for triangular", &T::mode, "none"),
       number("max", "largest value; for uniform and triangular", &T::max, "none"),
       number("from", "lower end; for truncated and beta", &T::from, "none"),
       number("to", "upper end; for truncated and beta", &T::to, "none")},
      [](T& into, const Given& given, Diagnostics& diagnostics) {
        const YamlNode* named = given.find("distribution");
        if (named == nullptr && given.find("range") != nullptr) into.shape = Shape_::uniform;
        if (named != nullptr && given.right("distribution") == nullptr) return false;
        const bool complete = check_entries(into.shape, given, diagnostics);
        return check_order(into, given, diagnostics) && complete;
      },
      fresh);
}

Shape<Tolerance> tolerance(const ParameterInfo& row) {
  const Shape<Tolerance> normal = shape_as<Tolerance, Spread>(
      spread(row, "a standard deviation"),
      [parameter = row.parameter](Spread sd) {
        Tolerance value;
        value.parameter = parameter;
        value.sd = sd;
        return value;
      },
      [](const Tolerance& value) { return *value.sd; });
  const auto shape = one_of<Tolerance>(std::string(row.text), {normal, spelled_out(row)},
                                       [](const Tolerance& /*value*/) { return std::size_t{1}; });
  return shape;
}

// [NAME, NAME, COEFFICIENT]
Shape<ToleranceCorrelation> correlation() {
  Shape<ToleranceCorrelation> shape;
  shape.schema.kind = ValueKind::list;
  shape.schema.text = "two parameters and the coefficient of their correlation, between -1 and 1";
  shape.schema.example = "[preload, kinetic_friction, 0.7]";
  shape.schema.min_items = shape.schema.max_items = 3;
  shape.schema.items.push_back(path("a parameter, or the coefficient", "preload").schema);
  shape.read = [schema = kept(shape.schema)](ToleranceCorrelation& into, const YamlNode& node,
                                             const Spot& spot, Diagnostics& diagnostics) {
    const auto wrong = [&](const YamlNode& at, std::string found) {
      diagnostics.add(at.mark, spot.path, std::move(found),
                      "expected two parameters and a number between -1 and 1, such as "
                      "[preload, kinetic_friction, 0.7]");
      return false;
    };
    if (node.kind == YamlNode::Kind::refused) return false;
    if (node.kind != YamlNode::Kind::list || node.items.size() != 3)
      return wrong(node, std::string(kind_phrase(node.kind)));
    const auto a = find_parameter(node.items[0].scalar), b = find_parameter(node.items[1].scalar);
    const auto coefficient = parse_number(node.items[2].scalar);
    if (!a) return wrong(node.items[0], quoted(node.items[0].scalar));
    if (!b) return wrong(node.items[1], quoted(node.items[1].scalar));
    if (!coefficient || !(std::fabs(*coefficient) < 1))
      return wrong(node.items[2], quoted(node.items[2].scalar));
    into = {*a, *b, *coefficient};
    return true;
  };
  shape.write = [](const ToleranceCorrelation& value) {
    YamlNode node;
    node.kind = YamlNode::Kind::list;
    node.items = {scalar_node(std::string(info(value.a).name)),
                  scalar_node(std::string(info(value.b).name)),
                  scalar_node(number_text(value.coefficient))};
    return node;
  };
  return shape;
}

}  // namespace

Shape<std::vector<Tolerance>> tolerances(std::string text) {
  return by_parameter<Tolerance>(tolerance, std::move(text), kTolerances);
}

Shape<std::vector<ToleranceCorrelation>> correlations() {
  auto shape = list("parameters that scatter together", correlation());
  shape.schema.example = "[[preload, kinetic_friction, 0.7]]";
  shape.read = [read = shape.read](std::vector<ToleranceCorrelation>& into, const YamlNode& node,
                                   const Spot& spot, Diagnostics& diagnostics) {
    if (node.kind != YamlNode::Kind::list || !node.items.empty())
      return read(into, node, spot, diagnostics);
    diagnostics.add(
        node.mark, spot.path, "found an empty list",
        "expected pairs such as [[preload, kinetic_friction, 0.7]]; without 'correlations' "
        "all parameters are independent, so leave it out");
    return false;
  };
  return shape;
}

void check_correlations(const std::vector<Tolerance>& tolerances,
                        const std::vector<ToleranceCorrelation>& correlations, const Given& given,
                        const std::string& of, Diagnostics& diagnostics) {
  const YamlNode* list = given.right("correlations");
  if (list == nullptr) return;
  const auto add = [&](std::size_t i, std::string found, std::string expected) {
    diagnostics.add(list->items[i].mark, given.path("correlations") + "[" + std::to_string(i) + "]",
                    std::move(found), std::move(expected));
  };
  const std::vector<optim::CorrelatedPair> pairs = correlated_pairs(tolerances, correlations);
  bool known = true;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const auto& [place, parameter] :
         {std::pair(pairs[i].a, correlations[i].a), std::pair(pairs[i].b, correlations[i].b)}) {
      if (place < tolerances.size()) continue;
      add(i, quoted(info(parameter).name) + " does not scatter",
          "add it to '" + of + "', or leave it out: columns of 'parts' correlate by their rows");
      known = false;
    }
  if (!known) return;
  if (const auto wrong = optim::Correlation::wrong_pair(tolerances.size(), pairs))
    add(*wrong,
        quoted(info(correlations[*wrong].a).name) + " and " +
            quoted(info(correlations[*wrong].b).name) + " with " +
            number_text(correlations[*wrong].coefficient),
        "expected a pair of its own, and a coefficient that agrees with the others: no parameters "
        "have all of these correlations at once, where pairs that are not named are independent");
}

void check_tolerances(const std::vector<Tolerance>& tolerances, const MotorDesign& design,
                      const YamlNode& mapping, const std::string& path, Diagnostics& diagnostics) {
  for (const Tolerance& one : tolerances) {
    const auto wrong = complaint(one, get(design, one.parameter));
    if (!wrong) continue;
    const auto entry = std::find_if(
        mapping.entries.begin(), mapping.entries.end(),
        [&](const YamlEntry& given) { return find_parameter(given.key) == one.parameter; });
    diagnostics.add(entry->value.mark, path + "." + entry->key, wrong->found(), wrong->expected());
  }
}

std::vector<std::string> tolerance_notes(const std::vector<Tolerance>& tolerances,
                                         const MotorDesign& design) {
  constexpr double kSame = 1e-6;  // above the rounding of a typed value
  std::vector<std::string> notes;
  for (const Tolerance& one : tolerances) {
    const double own = get(design, one.parameter);
    const double centre = one.centre(own);
    if (std::isnan(own) || std::fabs(centre - own) <= kSame * std::fabs(own)) continue;
    const ParameterInfo& row = info(one.parameter);
    notes.push_back(std::string(row.name) + " varies about " + engineering(centre, row.unit) +
                    ", but the motor has " + engineering(own, row.unit) +
                    ", so the answer is for another motor; give the spread alone, such as '" +
                    std::string(row.name) + ": 3 %', to vary it about the motor's own value");
  }
  return notes;
}

}  // namespace twum::inline v0_1::studies::shapes
