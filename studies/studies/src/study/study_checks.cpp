// SPDX-License-Identifier: Apache-2.0
#include "study/study_checks.hpp"

#include "study/repeats.hpp"
#include "study/sampling_checks.hpp"
#include "study/solver_entry.hpp"
#include "study/sweep_checks.hpp"

#include <twum/core/design/parameters.hpp>
#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/schema/validate.hpp>
#include <twum/studies/text/words.hpp>

#include <string>

namespace twum::studies {
namespace {

// Two values of one parameter in one mapping, both there and valid.
struct Pair {
  const YamlNode* first{nullptr};
  const YamlNode* second{nullptr};
  double a{0};
  double b{0};

  Pair(const YamlNode& node, const char* first_name, const char* second_name, const Schema& value)
      : first(node.find(first_name)), second(node.find(second_name)) {
    const auto low = first != nullptr ? quantity_of(*first, value) : std::nullopt;
    const auto high = second != nullptr ? quantity_of(*second, value) : std::nullopt;
    if (!low || !high) first = second = nullptr;
    a = low.value_or(0);
    b = high.value_or(0);
  }
  explicit operator bool() const { return first != nullptr; }
};

class StudyChecker {
 public:
  explicit StudyChecker(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void check_variables(const YamlNode& variables, const std::string& path) {
    for (const YamlEntry& entry : variables.entries) {
      const auto parameter = find_parameter(entry.key);
      if (parameter)
        check_variable(entry.value, parameter_schema(info(*parameter)), path + "." + entry.key);
    }
    if (variables.kind == YamlNode::Kind::mapping && variables.entries.empty()) {
      diagnostics_.add(variables.mark, path, "no variable", "name at least one parameter");
    }
  }

  void check_family(const YamlNode& family) {
    if (family.kind != YamlNode::Kind::mapping || family.entries.size() == 1) return;
    diagnostics_.add(family.mark, "study.family",
                     std::to_string(family.entries.size()) + " parameters",
                     "a family is over one parameter");
  }

  // Names of columns: each once.
  void check_metrics(const YamlNode& metrics) {
    Repeats repeats("study.metrics", "leave one of them out", diagnostics_);
    for (const YamlNode& item : metrics.items) {
      if (item.kind != YamlNode::Kind::scalar) continue;
      const auto parameter = find_parameter(trimmed(item.scalar));  // or its symbol
      repeats.see(item, std::string(parameter ? info(*parameter).name : trimmed(item.scalar)));
    }
  }

 private:
  void check_variable(const YamlNode& node, const Schema& value, const std::string& path) {
    rising(node, "min", "max", value, path);
    rising(node, "min", "mode", value, path);
    rising(node, "mode", "max", value, path);
    inside(node, value, path);
    const YamlNode* scale = node.find("scale");
    const YamlNode* min = node.find("min");
    if (scale == nullptr || min == nullptr || scale->scalar != "log") return;
    const auto least = quantity_of(*min, value);
    if (least && !(*least > 0)) {
      diagnostics_.add({min->mark, path + ".min", quoted(min->scalar) + " with a logarithmic scale",
                        "must be more than 0", scale->mark, "logarithmic scale asked for here"});
    }
  }

  void rising(const YamlNode& node, const char* low, const char* high, const Schema& value,
              const std::string& path) {
    const Pair pair(node, low, high, value);
    if (!pair || pair.a < pair.b || (std::string_view(low) == "mode" && pair.a == pair.b) ||
        (std::string_view(high) == "mode" && pair.a == pair.b)) {
      return;
    }
    diagnostics_.add({pair.second->mark, path + "." + high,
                      quoted(pair.second->scalar) + " is not above " + low,
                      "must be more than " + printable(pair.first->scalar), pair.first->mark,
                      std::string(low) + " given here"});
  }

  void inside(const YamlNode& node, const Schema& value, const std::string& path) {
    const Pair above(node, "min", "start", value);
    const Pair below(node, "start", "max", value);
    if ((!above || above.a <= above.b) && (!below || below.a <= below.b)) return;
    const YamlNode* start = node.find("start");
    diagnostics_.add(start->mark, path + ".start", quoted(start->scalar) + " is outside the range",
                     "must lie between min and max");
  }

  Diagnostics& diagnostics_;
};

// A limit that is there twice is a slip of the pen.
void check_repeats(const YamlNode& study, const std::string& name, Diagnostics& diagnostics) {
  const YamlNode* list = study.find(name);
  if (list == nullptr) return;
  Repeats repeats("study." + name, "leave one of them out", diagnostics);
  for (const YamlNode& item : list->items) {
    if (!item.scalar.empty()) repeats.see(item, item.scalar);
  }
}

const YamlNode* goal_of(const YamlNode& objective) {
  const YamlNode* goal = objective.find("maximize");
  return goal != nullptr ? goal : objective.find("minimize");
}

// Two goals of a front have to be different.
void check_goals(const YamlNode& study, Diagnostics& diagnostics) {
  const YamlNode* list = study.find("objectives");
  if (list == nullptr) return;
  Repeats repeats("study.objectives", "a front is between different metrics", diagnostics);
  for (const YamlNode& objective : list->items) {
    if (const YamlNode* goal = goal_of(objective)) repeats.see(*goal, goal->scalar);
  }
}

// A fit moves between the values of its variables.
void refuse_whole_numbers(const YamlNode& study, Diagnostics& diagnostics) {
  const YamlNode* variables = study.find("variables");
  if (variables == nullptr) return;
  for (const YamlEntry& entry : variables->entries) {
    const auto parameter = find_parameter(entry.key);
    if (parameter && info(*parameter).integer)
      diagnostics.add(entry.key_mark, "study.variables." + entry.key,
                      "only whole numbers, which a fit cannot move between",
                      "set it in the motor, one study for each value");
  }
}

}  // namespace

void check_study(const YamlNode& study, Diagnostics& diagnostics) {
  StudyChecker checker(diagnostics);
  if (const YamlNode* variables = study.find("variables"))
    checker.check_variables(*variables, "study.variables");
  if (const YamlNode* family = study.find("family")) checker.check_family(*family);
  if (const YamlNode* metrics = study.find("metrics")) checker.check_metrics(*metrics);
  const YamlNode* kind = study.find("kind");
  if (kind != nullptr && kind->scalar == "sweep") check_sweep(study, diagnostics);
  if (kind != nullptr && kind->scalar == "sensitivity") check_sensitivity(study, diagnostics);
  if (kind != nullptr && kind->scalar == "uncertainty") check_uncertainty(study, diagnostics);
  if (kind != nullptr && kind->scalar == "calibrate") refuse_whole_numbers(study, diagnostics);
  check_repeats(study, "constraints", diagnostics);
  check_repeats(study, "limits", diagnostics);
  check_goals(study, diagnostics);
  check_solver(study, diagnostics);
}

}  // namespace twum::studies
