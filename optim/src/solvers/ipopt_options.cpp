// SPDX-License-Identifier: Apache-2.0
#include "solvers/ipopt_options.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <coin/IpOptionsList.hpp>
#include <coin/IpSmartPtr.hpp>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::optim {
namespace {

// An option and our default; none: Ipopt's own.
struct Entry {
  SolverOption option;
  std::string standard;
};

Entry number(const char* name, double least, double most, const char* standard, const char* text) {
  return {{"ipopt", name, "number", text, least, most}, standard};
}

Entry integer(const char* name, double least, double most, const char* standard, const char* text) {
  return {{"ipopt", name, "integer", text, least, most}, standard};
}

Entry choice(const char* name, std::vector<std::string> words, const char* standard,
             const char* text) {
  return {{"ipopt", name, "text", text, 0, 0, std::move(words)}, standard};
}

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries{
      number("tol", 1e-14, 1e-1, "1e-9",
             "relative error of the optimality conditions at which to stop"),
      number("acceptable_tol", 1e-14, 1.0, "1e-7",
             "looser tolerance that is accepted if it holds for several steps"),
      number("constr_viol_tol", 1e-14, 1.0, "1e-9", "largest scaled violation that counts as zero"),
      integer("max_iter", 0, 1e6, "500", "iterations"),
      choice("mu_strategy", {"monotone", "adaptive"}, "adaptive",
             "update strategy of the barrier parameter"),
      number("mu_init", 1e-12, 1e6, "", "first barrier parameter"),
      number("bound_relax_factor", 0, 1e-2, "0", "relative relaxation of bounds inside Ipopt"),
      integer("limited_memory_max_history", 1, 1000, "12", "gradients kept for the Hessian"),
      choice("nlp_scaling_method", {"none", "gradient-based"}, "none",
             "scaling inside Ipopt; twum scales the problem before"),
      integer("print_level", 0, 12, "0", "what Ipopt itself prints to standard output")};
  return entries;
}

std::string text_option(const RunSettings& settings, const Entry& e) {
  const SolverOption& option = e.option;
  if (settings.options == nullptr || !settings.options->contains(option.name)) return e.standard;
  const std::string& value = settings.options->at(option.name);
  if (std::find(option.words.begin(), option.words.end(), value) == option.words.end())
    throw InputError("solver option '" + option.name + "': '" + value + "' is none of " +
                     option.range());
  return value;
}

void require_taken(bool taken, const std::string& name) {
  if (!taken) throw Error("Ipopt does not take its option '" + name + "'");
}

}  // namespace

IpoptSettings check_ipopt_settings(const RunSettings& settings) {
  IpoptSettings checked;
  for (const Entry& e : table()) {
    const SolverOption& option = e.option;
    const std::string& name = option.name;
    const bool given = settings.options != nullptr && settings.options->contains(name);
    if (!given && e.standard.empty()) continue;
    if (option.type == "text") {
      checked.texts.emplace_back(name, text_option(settings, e));
      continue;
    }
    const double standard = given ? 0.0 : std::stod(e.standard);
    if (option.type == "integer")
      checked.integers.emplace_back(
          name, whole_option(settings, name, standard, option.least, option.most));
    else
      checked.numbers.emplace_back(
          name, number_option(settings, name, standard, option.least, option.most));
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
  for (const Entry& e : table()) list.push_back(e.option);
  return list;
}

}  // namespace twum::inline v0_1::optim
