// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include "solvers/optimizer.hpp"
#include "solvers/solver_process.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <deque>
#include <mutex>

namespace twum::inline v0_1::optim {
namespace {

const std::vector<Optimizer>& registry() {
  static const std::vector<Optimizer> all = [] {
    std::vector<Optimizer> list = nlopt_optimizers();
    for (auto& o : ipopt_optimizers()) list.push_back(std::move(o));
    return list;
  }();
  return all;
}

// Solvers of the program: their addresses stay.
struct OwnSolvers {
  std::mutex lock;
  std::deque<Optimizer> list;
};

OwnSolvers& own_solvers() {
  static OwnSolvers own;
  return own;
}

const Optimizer* find_in(const auto& list, const std::string& name) {
  const auto found = std::ranges::find_if(list, [&](const auto& o) { return o.info.name == name; });
  return found == list.end() ? nullptr : &*found;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

std::string unknown_solver(const std::string& name) {
  std::vector<std::string> names{"auto"};
  for (const auto& o : registry()) names.push_back(o.info.name);
  std::string text = "unknown solver '" + name + "'";
  const std::string near = nearest_name(name, names);
  if (!near.empty()) text += " (did you mean '" + near + "'?)";
  text += "; there are";
  for (const auto& n : names) text += " " + n;
  return text;
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = 4;
  for (const auto& c : candidates) {
    // "slsqp" for "nlopt:slsqp" is a slip of the prefix, not of the name
    const bool suffix = c.size() > name.size() && c.ends_with(":" + name);
    const std::size_t d = suffix ? 0 : edit_distance(name, c);
    if (d < least) {
      least = d;
      best = c;
    }
  }
  return best;
}

const char* to_string(FailurePolicy policy) {
  switch (policy) {
    case FailurePolicy::shorter_step: return "shorter-step";
    case FailurePolicy::restart: return "restart";
    case FailurePolicy::rank_last: return "rank-last";
  }
  return "unknown";
}

const std::vector<SolverInfo>& solvers() {
  static const std::vector<SolverInfo> list = [] {
    std::vector<SolverInfo> infos;
    for (const auto& o : registry()) infos.push_back(o.info);
    return infos;
  }();
  return list;
}

const Optimizer& find_optimizer(const std::string& name) {
  if (const Optimizer* ours = find_in(registry(), name)) return *ours;
  OwnSolvers& own = own_solvers();
  const std::lock_guard<std::mutex> guard(own.lock);
  if (const Optimizer* one = find_in(own.list, name)) return *one;
  throw InputError(unknown_solver(name));
}

void add_solver(SolverInfo info, OwnSolver solver) {
  if (!solver) throw InputError("add_solver: '" + info.name + "' has no function");
  OwnSolvers& own = own_solvers();
  const std::lock_guard<std::mutex> guard(own.lock);
  if (info.name.empty() || info.name == "auto" || find_in(registry(), info.name) ||
      find_in(own.list, info.name))
    throw InputError("add_solver: the name '" + info.name + "' is taken");
  own.list.push_back(own_optimizer(std::move(info), std::move(solver)));
}

const SolverInfo& find_solver(const std::string& name) { return find_optimizer(name).info; }

std::string SolverOption::range() const {
  std::string choices;
  for (const std::string& word : words) choices += (choices.empty() ? "" : "|") + word;
  if (!choices.empty()) return choices;
  std::array<char, 64> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "%g to %g", least, most);
  std::string range = numbers.data();
  const std::size_t exponent = range.find("e+0");  // 1e6, as people type it
  return exponent == std::string::npos ? range : range.erase(exponent + 1, 2);
}

const std::vector<SolverOption>& solver_options() {
  static const std::vector<SolverOption> list = [] {
    std::vector<SolverOption> all = nlopt_options();
    for (auto& o : ipopt_options()) all.push_back(std::move(o));
    return all;
  }();
  return list;
}

void require_available(const SolverInfo& solver) {
  if (!solver.available)
    throw InputError("solver '" + solver.name + "' cannot be used: " + solver.description);
  if (solver.own_process && solver_process().empty())
    throw InputError("solver '" + solver.name +
                     "' may compute for ever, so it needs a process of its own that can be ended: "
                     "the command twum "
                     "gives it one, another program names one with use_solver_process()");
}

double number_option(const RunSettings& settings, const std::string& name, double standard,
                     double least, double most) {
  if (settings.options == nullptr) return standard;
  const auto it = settings.options->find(name);
  if (it == settings.options->end()) return standard;
  const std::string& text = it->second;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() ||
      !(value >= least && value <= most))
    throw InputError("solver option '" + name + "': '" + text + "' is not a number from " +
                     std::to_string(least) + " to " + std::to_string(most));
  return value;
}

int whole_option(const RunSettings& settings, const std::string& name, double standard,
                 double least, double most) {
  const double value = number_option(settings, name, standard, least, most);
  if (value != std::floor(value))
    throw InputError("solver option '" + name + "': '" + settings.options->at(name) +
                     "' is not a whole number");
  return static_cast<int>(value);
}

void require_known_options(const RunSettings& settings, const std::vector<SolverOption>& known) {
  if (settings.options == nullptr) return;
  std::vector<std::string> names;
  for (const auto& k : known) names.push_back(k.name);
  for (const auto& [name, value] : *settings.options) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = nearest_name(name, names);
    std::string text = "unknown solver option '" + name + "'";
    if (!near.empty()) text += " (did you mean '" + near + "'?)";
    throw InputError(text);
  }
}

}  // namespace twum::inline v0_1::optim
