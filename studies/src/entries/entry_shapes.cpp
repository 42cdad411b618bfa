// SPDX-License-Identifier: Apache-2.0
#include "entries/entry_shapes.hpp"

#include "entries/repeats.hpp"

#include <twum/io/words.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/motors/settings.hpp>

#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies::shapes {
namespace {

bool check_range(DesignVariable& range, const Given& given, Diagnostics& diagnostics) {
  const bool low = given.right("min") != nullptr;
  const bool high = given.right("max") != nullptr;
  if (low && high) rising(given, "min", range.min, "max", range.max, diagnostics);
  const YamlNode* start = given.right("start");
  if (start != nullptr && ((low && range.start < range.min) || (high && range.start > range.max)))
    diagnostics.add(start->mark, given.path("start"),
                    quoted(start->scalar) + " is outside the range",
                    "must lie between min and max");
  check_log(given, range.min, diagnostics);
  return true;
}

Shape<DesignVariable> range(const ParameterInfo& parameter) {
  const Shape<double> own = value_of(parameter, "start of the search");
  Field<DesignVariable> start = required<DesignVariable>("start", own, &DesignVariable::start);
  start.entry.required = false;
  start.entry.fallback = "the motor's own value";
  start.write = [write = own.write](const DesignVariable& from) {
    return std::isnan(from.start) ? std::nullopt : std::optional<YamlNode>(write(from.start));
  };
  return mapping<DesignVariable>(
      std::string(parameter.text),
      {required<DesignVariable>("min", value_of(parameter, kSmallestValue), &DesignVariable::min),
       required<DesignVariable>("max", value_of(parameter, kLargestValue), &DesignVariable::max),
       standard<DesignVariable>("scale", shapes::spacing(), &DesignVariable::scale),
       std::move(start)},
      check_range);
}

void check_list(const Given& given, const char* name, Diagnostics& diagnostics) {
  const YamlNode* list = given.find(name);
  if (list == nullptr) return;
  Repeats repeats(given.path(name), "leave one of them out", diagnostics);
  for (const YamlNode& item : list->items)
    if (!item.scalar.empty()) repeats.see(item, item.scalar);
}

void check_family(const YamlNode& family, const Spot& spot, Diagnostics& diagnostics) {
  if (family.entries.size() == 1) return;
  diagnostics.add(family.mark, spot.path, "found " + counted(family.entries.size(), "parameter"),
                  "expected one: a family varies a single parameter");
}

}  // namespace

Shape<DutyPoint> duty_point() {
  return mapping<DutyPoint>(
      "one operating point",
      {required<DutyPoint>("torque", quantity("load torque", "N.m", "0.5 N.m"), &DutyPoint::torque),
       required<DutyPoint>("speed", quantity("rotor speed", "rad/s", "100 rpm"),
                           &DutyPoint::speed)},
      [](DutyPoint& duty, const Given& given, Diagnostics& /*diagnostics*/) {
        const YamlNode* torque = given.right("torque");
        const YamlNode* speed = given.right("speed");
        if (torque != nullptr && speed != nullptr)
          duty.text = "torque_at(" + speed->scalar + ") >= " + torque->scalar;
        return true;
      });
}

void check_held(const Given& given, const std::optional<double>& torque,
                const std::optional<double>& speed, Diagnostics& diagnostics) {
  const YamlNode* node = given.right("speed");
  if (node == nullptr || !torque || *speed > 0) return;
  diagnostics.add(node->mark, given.path("speed"), "a torque that is held at rest",
                  "expected a speed of more than 0 rpm; at rest friction holds without a wave");
}

Shape<CurveStudy::Family> family(const char* example) {
  using Family = CurveStudy::Family;
  const auto values = by_parameter<Family>(
      [](const ParameterInfo& row) {
        return shape_as<Family, std::vector<double>>(
            list("values", value_of(row, "a value")),
            [](std::vector<double> list) {
              return Family{{}, std::move(list)};
            },
            [](const Family& family) { return family.values; });
      },
      "one parameter and its values", example, check_family);
  return shape_as<Family, std::vector<Family>>(
      values, [](std::vector<Family> list) { return std::move(list.front()); },
      [](const Family& family) { return std::vector<Family>{family}; });
}

Shape<MetricExpression> metric(std::string text, std::string example) {
  return text_of<MetricExpression>(std::move(text), std::move(example), parse_metric,
                                   [](const MetricExpression& value) { return value.text; });
}

namespace {

DesignObjective parse_wanted(std::string_view text) {
  if (!is_statistic(text)) return {parse_metric(text)};
  StatisticRequest statistic = parse_statistic(text);
  MetricExpression metric = statistic.metric;
  return {std::move(metric), false, std::move(statistic)};
}

bool is_share(const DesignObjective& goal) {
  using Kind = StatisticRequest::Kind;
  return goal.statistic &&
         (goal.statistic->kind == Kind::yield || goal.statistic->kind == Kind::probability);
}

}  // namespace

Shape<DesignObjective> wanted(std::string text, bool maximize, std::string example) {
  auto shape = text_of<DesignObjective>(std::move(text), std::move(example), parse_wanted,
                                        [](const DesignObjective& goal) { return goal.text(); });
  shape.read = [read = shape.read, maximize](DesignObjective& into, const YamlNode& node,
                                             const Spot& spot, Diagnostics& diagnostics) {
    if (!read(into, node, spot, diagnostics)) return false;
    into.maximize = maximize;
    if (maximize || !is_share(into)) return true;
    diagnostics.add(node.mark, spot.path, "minimizes a share of the motors",
                    "expected 'maximize: " + into.text() + "' in an optimize study");
    return false;
  };
  return shape;
}

Shape<std::vector<MetricExpression>> metrics() {
  auto shape = list("metrics and parameters", metric("a metric"));
  shape.schema.sample = "- stall_torque\n- no_load_speed\n- wear_intensity_at(80 rpm)";
  return shape;
}

namespace {

struct TolerantLimit {
  MotorLimit limit;
  std::string tolerance;
};

Shape<MotorLimit> plain_limit() {
  return text_of<MotorLimit>("a limit", "stall_torque >= 0.8 N.m", parse_limit,
                             [](const MotorLimit& value) { return value.text; });
}

bool apply_tolerance(TolerantLimit& into, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* typed = given.right("tolerance");
  if (typed == nullptr || given.right("limit") == nullptr) return false;
  try {
    into.limit = with_tolerance(std::move(into.limit), into.tolerance);
    return true;
  } catch (const ValueError& error) {
    diagnostics.add(typed->mark, given.path("tolerance"), error.found(), error.expected());
    return false;
  }
}

}  // namespace

Shape<MotorLimit> tolerant_limit() {
  const auto as_typed = text_of<std::string>(
      "largest violation that counts as kept, in the unit of the limit", "1e-4 N.m",
      [](std::string_view text) { return std::string(text); },
      [](const std::string& text) { return text; });
  const auto shape = mapping<TolerantLimit>(
      "a limit with its own tolerance",
      {required<TolerantLimit>("limit", plain_limit(), &TolerantLimit::limit),
       required<TolerantLimit>("tolerance", as_typed, &TolerantLimit::tolerance)},
      apply_tolerance);
  return shape_as<MotorLimit, TolerantLimit>(
      shape, [](TolerantLimit value) { return std::move(value.limit); },
      [](const MotorLimit& limit) {
        return TolerantLimit{limit, limit.tolerance_text};
      });
}

Shape<std::vector<MotorLimit>> constraints() {
  auto shape = list(
      "limits that must hold",
      one_of<MotorLimit>("a limit", {plain_limit(), tolerant_limit()}, [](const MotorLimit& limit) {
        return limit.tolerance_text.empty() ? std::size_t{0} : std::size_t{1};
      }));
  shape.schema.sample = "- no_load_speed >= 100 rpm\n- max_pressure <= 10 MPa";
  return shape;
}

Shape<std::uint64_t> samples() { return count("number of samples", "1000", 1, 1e9); }

Shape<optim::Scale> spacing() {
  return word<optim::Scale>("spacing", {optim::Scale::linear, optim::Scale::log});
}

Shape<std::uint64_t> seed() {
  // At most 2^53 - 1: above it not every integer is a double, so two seeds could be equal.
  return count("seed of the random numbers", "1", 0, 9007199254740991.0);
}

Shape<std::string> folder() {
  return path("result directory of another study, whose best design or front is the start",
              "results/first");
}

Shape<double> value_of(const ParameterInfo& parameter, std::string text) {
  Schema schema = parameter_schema(parameter);
  schema.text = std::move(text);
  return number(std::move(schema));
}

void needs_one(const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
  if (node.entries.empty())
    diagnostics.add(node.mark, spot.path, "no variable", "name at least one parameter");
}

ErasedShape erased_by_parameter(const std::function<ErasedShape(const ParameterInfo&)>& shape_of,
                                std::string text, std::string sample, CountCheck check_count,
                                const ErasedList& list, Parameter& (*parameter_of)(void* item)) {
  std::vector<ErasedShape> all;
  ErasedShape shape;
  shape.schema.kind = ValueKind::mapping;
  shape.schema.text = std::move(text);
  shape.schema.sample = std::move(sample);
  for (const ParameterInfo& row : parameter_table()) {
    all.push_back(shape_of(row));
    SchemaEntry entry;
    entry.name = row.name;
    entry.schema = all.back().schema;
    entry.alias = row.symbol;
    entry.alias_counts = true;
    if (row.alternative) entry.alternative_entry = info(*row.alternative).name;
    shape.schema.entries.push_back(std::move(entry));
  }
  const auto shapes = kept(std::move(all));
  shape.read = [schema = kept(shape.schema), shapes, check_count, list, parameter_of](
                   void* into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    list.clear(into);
    if (node.kind != YamlNode::Kind::mapping) {
      say_wrong_kind(node, *schema, spot, diagnostics);
      return false;
    }
    if (check_count != nullptr) check_count(node, spot, diagnostics);
    for (const auto& [number, entry] : given_entries(node, *schema, spot, diagnostics)) {
      const Spot place = spot.entry(entry->key, entry->key_mark);
      void* const item = list.add(into);
      if ((*shapes)[number].read(item, entry->value, place, diagnostics))
        parameter_of(item) = parameter_table()[number].parameter;
      else
        list.drop(into);
    }
    return list.size(into) > 0 && list.size(into) == node.entries.size();
  };
  shape.write = [shapes, list, parameter_of](void* values) {
    YamlNode node;
    node.kind = YamlNode::Kind::mapping;
    for (std::size_t i = 0; i < list.size(values); ++i) {
      void* const item = list.item(values, i);
      const ParameterInfo& row = info(parameter_of(item));
      const auto number = static_cast<std::size_t>(&row - parameter_table().data());
      node.entries.push_back({std::string(row.name), {}, (*shapes)[number].write(item)});
    }
    return node;
  };
  return shape;
}

Shape<std::vector<DesignVariable>> variables(std::string text, std::string sample) {
  return by_parameter<DesignVariable>(range, std::move(text), std::move(sample));
}

Shape<std::vector<DerivedParameter>> derived() {
  const auto rule = [](const ParameterInfo& row) {
    Shape<DerivedParameter> shape;
    shape.schema.kind = ValueKind::text;
    shape.schema.text = row.text;
    shape.schema.example = row.example;
    shape.read = [schema = kept(shape.schema), parameter = row.parameter](
                     DerivedParameter& into, const YamlNode& node, const Spot& spot,
                     Diagnostics& diagnostics) {
      return says_no_error(node, *schema, spot, diagnostics, [&](const std::string& typed) {
        into = parse_derived(parameter, typed);
      });
    };
    shape.write = [](const DerivedParameter& derived) { return scalar_node(derived.value.text); };
    return shape;
  };
  return by_parameter<DerivedParameter>(rule, "parameters that follow from others, as expressions",
                                        "contact_width: 0.15 * contact_radius");
}

Shape<std::vector<Override>> overrides() {
  return by_parameter<Override>(
      [](const ParameterInfo& row) {
        return shape_as<Override, double>(
            parameter_shape(row),
            [](double value) {
              return Override{{}, value};
            },
            [](const Override& one) { return one.value; });
      },
      "overrides of the motor", "preload: 140 N", nullptr);
}

bool rising(const Given& given, const char* low, double low_value, const char* high,
            double high_value, Diagnostics& diagnostics) {
  const bool mode = std::string_view(low) == "mode" || std::string_view(high) == "mode";
  if (low_value < high_value || (mode && low_value == high_value)) return true;
  const YamlNode& first = *given.right(low);
  const YamlNode& second = *given.right(high);
  diagnostics.add({second.mark, given.path(high), quoted(second.scalar) + " is not above " + low,
                   "must be more than " + printable(first.scalar), first.mark,
                   std::string(low) + " given here"});
  return false;
}

void check_log(const Given& given, double min, Diagnostics& diagnostics) {
  const YamlNode* scale = given.find("scale");
  const YamlNode* least = given.right("min");
  if (scale == nullptr || scale->scalar != "log" || least == nullptr || min > 0) return;
  diagnostics.add({least->mark, given.path("min"),
                   quoted(least->scalar) + " with a logarithmic scale", "must be more than 0",
                   scale->mark, "logarithmic scale asked for here"});
}

void check_repeats(const Given& given, Diagnostics& diagnostics) {
  if (const YamlNode* metrics = given.find("metrics")) {
    Repeats repeats(given.path("metrics"), "leave one of them out", diagnostics);
    for (const YamlNode& item : metrics->items) {
      if (item.kind != YamlNode::Kind::scalar) continue;
      const auto parameter = find_parameter(trimmed(item.scalar));  // or its symbol
      repeats.see(item, std::string(parameter ? info(*parameter).name : trimmed(item.scalar)));
    }
  }
  check_list(given, "constraints", diagnostics);
  check_list(given, "limits", diagnostics);
}

}  // namespace twum::inline v0_1::studies::shapes
