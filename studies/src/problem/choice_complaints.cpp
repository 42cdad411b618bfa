// SPDX-License-Identifier: Apache-2.0
#include "problem/combinations.hpp"

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace twum::inline v0_1::studies {
namespace {

// A name becomes a column of results.csv, beside parameters, metrics, stage and status.
bool is_plain(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
         });
}

bool is_taken(const std::string& name) {
  const bool metric = std::any_of(metric_table().begin(), metric_table().end(),
                                  [&](const MetricInfo& row) { return row.name == name; });
  return metric || find_parameter(name) || name == "stage" || name == "status";
}

class ChoiceCheck {
 public:
  explicit ChoiceCheck(const DesignProblem& problem) : problem_(problem) {}

  std::vector<ChoiceComplaint> run() {
    for (std::size_t i = 0; i < problem_.choices.size(); ++i) {
      check_names(i);
      check_others(i);
    }
    check_count();
    if (complaints_.empty()) check_motors();
    return std::move(complaints_);
  }

 private:
  void complain(std::size_t choice, std::optional<std::size_t> set, std::string found,
                std::string expected, std::optional<Parameter> other = {}) {
    complaints_.push_back({choice, set, other, std::move(found), std::move(expected)});
  }

  void check_names(std::size_t i) {
    const DesignChoice& choice = problem_.choices[i];
    if (!is_plain(choice.name))
      complain(i, {}, quoted(choice.name) + " cannot be the name of a choice",
               "expected letters, digits, '_' and '-', a letter first, such as 'lining'");
    else if (is_taken(choice.name))
      complain(i, {}, quoted(choice.name) + " is the name of a parameter, metric or column",
               "expected a name of its own, such as 'lining'");
    for (std::size_t k = 0; k < i; ++k)
      if (problem_.choices[k].name == choice.name)
        complain(i, {}, quoted(choice.name) + " is the name of two choices", "rename one of them");
    if (choice.sets.empty())
      complain(i, {}, quoted(choice.name) + " has no set", "give at least one");
    for (std::size_t s = 0; s < choice.sets.size(); ++s)
      for (std::size_t k = 0; k < s; ++k)
        if (choice.sets[k].name == choice.sets[s].name)
          complain(i, s, quoted(choice.sets[s].name) + " is given twice",
                   "leave one of them out, or give it a name of its own");
  }

  static std::string name_of(const ParameterSet& set, const DesignChoice& choice) {
    return quoted(set.name) + " of " + quoted(choice.name);
  }

  // "gives it too", or that it gives its alternative.
  static std::string gives_too(const ParameterSet& set, Parameter parameter) {
    for (const auto& [given, ignored] : set.values)
      if (given == parameter) return " gives it too";
    return " gives " + std::string(info(*info(parameter).alternative).name) +
           ", which cannot be given together with it";
  }

  // A parameter given by a set must not be set elsewhere.
  void check_others(std::size_t i) {
    const DesignChoice& choice = problem_.choices[i];
    const auto refuse = [&](Parameter parameter, const char* how) {
      const auto set = std::find_if(choice.sets.begin(), choice.sets.end(),
                                    [&](const ParameterSet& one) { return one.gives(parameter); });
      if (set == choice.sets.end()) return;
      complain(i, static_cast<std::size_t>(set - choice.sets.begin()),
               std::string(info(parameter).name) + " is " + how + ", and " + name_of(*set, choice) +
                   gives_too(*set, parameter),
               "leave it out here, or in the files of " + quoted(choice.name), parameter);
    };
    for (const DesignVariable& variable : problem_.variables) refuse(variable.parameter, "varied");
    for (const DerivedParameter& rule : problem_.derived) refuse(rule.parameter, "derived");
    for (std::size_t k = 0; k < i; ++k) check_two(k, i);
  }

  // The first parameter that sets of two choices give.
  void check_two(std::size_t first, std::size_t second) {
    const DesignChoice& a = problem_.choices[first];
    const DesignChoice& b = problem_.choices[second];
    for (const ParameterSet& one : a.sets) {
      for (const auto& [parameter, ignored] : one.values) {
        for (std::size_t s = 0; s < b.sets.size(); ++s) {
          if (!b.sets[s].gives(parameter)) continue;
          complain(second, s,
                   std::string(info(parameter).name) + " is given by " + name_of(one, a) +
                       ", and " + name_of(b.sets[s], b) + gives_too(b.sets[s], parameter),
                   "a parameter belongs to one choice");
          return;
        }
      }
    }
  }

  void check_count() {
    std::size_t count = 1;
    for (std::size_t i = 0; i < problem_.choices.size(); ++i) {
      count *= std::max<std::size_t>(1, problem_.choices[i].sets.size());
      if (count <= kMostCombinations) continue;
      complain(i, {}, std::to_string(count) + " combinations of sets",
               "each is solved by itself, at most " + std::to_string(kMostCombinations) +
                   "; split the study");
      return;
    }
  }

  // A set may need another one, such as a voltage the modal data, so combinations count.
  void check_motors() {
    for (std::size_t i = 0; i < problem_.choices.size(); ++i) {
      for (std::size_t s = 0; s < problem_.choices[i].sets.size(); ++s) {
        DesignProblem one = problem_;
        one.choices[i].sets = {problem_.choices[i].sets[s]};
        try {
          combinations(one);
        } catch (const InputError& error) {
          complain(
              i, s,
              quoted(problem_.choices[i].sets[s].name) + " gives an invalid motor: " + error.what(),
              "change it, or the motor");
        }
      }
      if (!complaints_.empty()) return;
    }
  }

  const DesignProblem& problem_;
  std::vector<ChoiceComplaint> complaints_;
};

}  // namespace

std::vector<ChoiceComplaint> choice_complaints(const DesignProblem& problem) {
  return ChoiceCheck(problem).run();
}

}  // namespace twum::inline v0_1::studies
