// SPDX-License-Identifier: Apache-2.0
#include "ipopt_options.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <coin/IpOptionsList.hpp>
#include <coin/IpSmartPtr.hpp>
#include <cstdio>
#include <iterator>
#include <sstream>

namespace twum::optim {
namespace {

enum class Kind { number, integer, text };

// One option: its name, type, range or choices, our default, and what it does. "" as default: Ipopt's own.
struct Entry {
  const char* name;
  Kind kind;
  double least;
  double most;
  const char* choices;
  const char* standard;
  const char* text;
};

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries{
      {"tol", Kind::number, 1e-14, 1e-1, "", "1e-9",
       "relative error of the optimality conditions at which to stop"},
      {"acceptable_tol", Kind::number, 1e-14, 1.0, "", "1e-7",
       "looser error that will do if it lasts"},
      {"constr_viol_tol", Kind::number, 1e-14, 1.0, "", "1e-9",
       "scaled violation that counts as none"},
      {"max_iter", Kind::integer, 0, 1e6, "", "500", "iterations"},
      {"mu_strategy", Kind::text, 0, 0, "monotone adaptive", "adaptive",
       "how the barrier parameter falls"},
      {"mu_init", Kind::number, 1e-12, 1e6, "", "", "first barrier parameter"},
      {"bound_relax_factor", Kind::number, 0, 1e-2, "", "0",
       "by how much bounds are widened inside"},
      {"limited_memory_max_history", Kind::integer, 1, 1000, "", "12",
       "gradients kept for the Hessian"},
      {"nlp_scaling_method", Kind::text, 0, 0, "none gradient-based", "none",
       "ours is done before"},
      {"print_level", Kind::integer, 0, 12, "", "0",
       "what Ipopt itself prints to standard output"}};
  return entries;
}

std::string choices_of(const Entry& e) {
  std::string text = e.choices;
  std::replace(text.begin(), text.end(), ' ', '|');
  return text;
}

std::string text_option(const RunSettings& settings, const Entry& e) {
  if (settings.options == nullptr || !settings.options->contains(e.name)) return e.standard;
  const std::string& value = settings.options->at(e.name);
  std::istringstream choices(e.choices);
  using Words = std::istream_iterator<std::string>;
  if (std::find(Words(choices), Words(), value) == Words())
    throw InputError("solver option '" + std::string(e.name) + "': '" + value + "' is none of " +
                     choices_of(e));
  return value;
}

std::string range_of(const Entry& e) {
  if (e.kind == Kind::text) return choices_of(e);
  char text[64];
  std::snprintf(text, sizeof text, "%g to %g", e.least, e.most);
  return text;
}

const char* type_of(Kind kind) {
  return kind == Kind::text ? "text" : kind == Kind::integer ? "integer" : "number";
}

void require_taken(bool taken, const std::string& name) {
  if (!taken) throw Error("Ipopt does not take its option '" + name + "'");
}

}  // namespace

IpoptSettings check_ipopt_settings(const RunSettings& settings) {
  IpoptSettings checked;
  for (const Entry& e : table()) {
    const bool given = settings.options != nullptr && settings.options->contains(e.name);
    if (!given && e.standard[0] == '\0') continue;
    if (e.kind == Kind::text) {
      checked.texts.emplace_back(e.name, text_option(settings, e));
      continue;
    }
    const double standard = given ? 0.0 : std::stod(e.standard);
    if (e.kind == Kind::integer)
      checked.integers.emplace_back(e.name,
                                    whole_option(settings, e.name, standard, e.least, e.most));
    else
      checked.numbers.emplace_back(e.name,
                                   number_option(settings, e.name, standard, e.least, e.most));
  }
  checked.texts.emplace_back("hessian_approximation", "limited-memory");
  checked.texts.emplace_back("sb", "yes");  // no banner
  return checked;
}

void apply_ipopt_settings(const IpoptSettings& settings, Ipopt::OptionsList& options) {
  for (const auto& [name, value] : settings.texts)
    require_taken(options.SetStringValue(name, value), name);
  for (const auto& [name, value] : settings.numbers)
    require_taken(options.SetNumericValue(name, value), name);
  for (const auto& [name, value] : settings.integers)
    require_taken(options.SetIntegerValue(name, value), name);
}

std::vector<SolverOption> ipopt_options() {
  std::vector<SolverOption> list;
  for (const Entry& e : table())
    list.push_back({"ipopt", e.name, type_of(e.kind), range_of(e), e.text});
  return list;
}

}  // namespace twum::optim
