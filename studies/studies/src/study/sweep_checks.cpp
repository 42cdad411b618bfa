// SPDX-License-Identifier: Apache-2.0
#include "study/sweep_checks.hpp"

#include "study/spacing.hpp"

#include <twum/core/design/parameters.hpp>
#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/schema/validate.hpp>
#include <twum/studies/text/number.hpp>
#include <twum/studies/text/words.hpp>

#include <cmath>
#include <string>

namespace twum::studies {
namespace {

constexpr double kUsualPoints = 5;
constexpr double kMostPoints = 1e6;  // what is more is refused by the table of the file

class SweepChecker {
 public:
  SweepChecker(const YamlNode& study, Diagnostics& diagnostics)
      : study_(study), diagnostics_(diagnostics), variables_(*study.find("variables")) {
    const YamlNode* sampling = study.find("sampling");
    sampling_ = sampling != nullptr ? sampling->scalar : "";
  }

  void check() {
    const bool drawn = sampling_ == "lhs" || sampling_ == "sobol";
    if (!drawn) refuse_entry("samples", "only of lhs and sobol; leave it out");
    if (!drawn) refuse_entry("seed", "only of lhs and sobol; leave it out");
    for (const YamlEntry& entry : variables_.entries) {
      if (drawn) refuse_points(entry);
      if (sampling_ == "list") require_list(entry);
      if (sampling_ == "grid") check_whole_points(entry);
    }
    if (sampling_ == "list") check_lengths();
    if (sampling_ == "grid") check_size();
  }

 private:
  static std::string path_of(const YamlEntry& entry) { return "study.variables." + entry.key; }

  void refuse_entry(const char* name, const char* remedy) {
    const YamlNode* node = study_.find(name);
    if (node == nullptr) return;
    diagnostics_.add(node->mark, std::string("study.") + name,
                     "given for sampling '" + sampling_ + "'", remedy);
  }

  void refuse_points(const YamlEntry& entry) {
    const YamlNode* points = entry.value.find("points");
    if (points == nullptr) return;
    diagnostics_.add(points->mark, path_of(entry) + ".points",
                     "given for sampling '" + sampling_ + "'",
                     "only of a grid; 'samples' below 'study' says how many designs are drawn");
  }

  void require_list(const YamlEntry& entry) {
    if (entry.value.kind != YamlNode::Kind::mapping) return;
    diagnostics_.add(entry.value.mark, path_of(entry), "a range for sampling 'list'",
                     "expected a list of values, or sampling 'grid'");
  }

  void check_lengths() {
    const YamlEntry* first = nullptr;
    for (const YamlEntry& entry : variables_.entries) {
      if (entry.value.kind != YamlNode::Kind::list) continue;
      if (first == nullptr) first = &entry;
      if (entry.value.items.size() == first->value.items.size()) continue;
      diagnostics_.add({entry.value.mark, path_of(entry),
                        std::to_string(entry.value.items.size()) + " values, but " + first->key +
                            " has " + std::to_string(first->value.items.size()),
                        "the lists of sampling 'list' have one length; for all combinations take "
                        "sampling 'grid'",
                        first->value.mark, first->key + " given here"});
    }
  }

  // A grid over a whole number, such as wavelengths, must hit whole numbers.
  void check_whole_points(const YamlEntry& entry) {
    const auto parameter = find_parameter(entry.key);
    const YamlNode* min = entry.value.find("min");
    const YamlNode* max = entry.value.find("max");
    if (!parameter || !info(*parameter).integer || min == nullptr || max == nullptr) return;
    const Schema schema = parameter_schema(info(*parameter));
    const auto low = quantity_of(*min, schema);
    const auto high = quantity_of(*max, schema);
    const YamlNode* scale = entry.value.find("scale");
    const bool log = scale != nullptr && scale->scalar == "log";
    const double points = points_of(entry.value);
    if (!low || !high || !(*low < *high) || (log && !(*low > 0))) return;
    if (!(points > 1 && points <= kMostPoints)) return;
    for (double i = 0; i < points; ++i) {
      const double value = between(*low, *high, i / (points - 1), log);
      if (std::abs(value - std::round(value)) <= 1e-9 * value) continue;
      diagnostics_.add(entry.value.mark, path_of(entry),
                       "a grid point at " + rounded_text(value, 6),
                       "must be whole numbers; give a list of values, or other 'points'");
      return;
    }
  }

  static double points_of(const YamlNode& range) {
    const YamlNode* points = range.find("points");
    return points == nullptr ? kUsualPoints : parse_number(points->scalar).value_or(kUsualPoints);
  }

  void check_size() {
    double designs = 1;
    for (const YamlEntry& entry : variables_.entries) {
      const bool list = entry.value.kind == YamlNode::Kind::list;
      designs *= list ? static_cast<double>(entry.value.items.size()) : points_of(entry.value);
    }
    if (designs <= kMostDesigns) return;
    diagnostics_.add(variables_.mark, "study.variables",
                     "a grid of " + rounded_text(designs, 3) + " designs",
                     "at most " + rounded_text(kMostDesigns, 1) +
                         "; take fewer points, or "
                         "sampling 'lhs' or 'sobol'");
  }

  const YamlNode& study_;
  Diagnostics& diagnostics_;
  const YamlNode& variables_;
  std::string sampling_;
};

void add_default(YamlNode& mapping, const char* name, const char* value) {
  if (mapping.find(name) != nullptr) return;
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.scalar = value;
  mapping.entries.push_back({name, {}, node});
}

}  // namespace

YamlNode with_sweep_defaults(YamlNode study) {
  const std::string sampling = study.find("sampling")->scalar;
  if (sampling == "lhs" || sampling == "sobol") {
    add_default(study, "samples", "1000");
    add_default(study, "seed", "1");
  }
  for (YamlEntry& entry : study.entries) {
    if (sampling != "grid" || entry.key != "variables") continue;
    for (YamlEntry& variable : entry.value.entries) {
      if (variable.value.kind == YamlNode::Kind::mapping)
        add_default(variable.value, "points", "5");
    }
  }
  return study;
}

void check_sweep(const YamlNode& study, Diagnostics& diagnostics) {
  const YamlNode* variables = study.find("variables");
  if (variables == nullptr || variables->kind != YamlNode::Kind::mapping) return;
  SweepChecker(study, diagnostics).check();
}

}  // namespace twum::studies
