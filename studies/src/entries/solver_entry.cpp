// SPDX-License-Identifier: Apache-2.0
#include "entries/solver_entry.hpp"

#include "entries/entry_shapes.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>
#include <twum/io/words.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/solvers.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// A number in the notation of solvers, "5e-9", from any notation.
Shape<std::string> option_shape(const optim::SolverOption& option) {
  if (option.type == "text") {
    const std::vector<std::string>& words = option.words;
    return shape_as<std::string, std::size_t>(
        choice(option.text + " (" + option.solver + ")", words),
        [words](std::size_t number) { return words[number]; },
        [words](const std::string& text) {
          return static_cast<std::size_t>(std::find(words.begin(), words.end(), text) -
                                          words.begin());
        });
  }
  const std::string text = option.text + " (" + option.solver + ", " + option.range() + ")";
  Schema value = quantity(text, "1", option.type == "integer" ? "1" : "1e-9").schema;
  if (option.type == "integer") value.kind = ValueKind::count;
  value.min = option.least;
  value.max = option.most;
  auto shape = shape_as<std::string, double>(number(value), number_text,
                                             [](const std::string&) { return 0.0; });
  shape.write = [](const std::string& typed) { return scalar_node(typed); };
  return shape;
}

using Options = std::map<std::string, std::string>;

Shape<Options> options_shape() {
  Fields<Options> fields;
  for (const optim::SolverOption& option : optim::solver_options()) {
    const std::string& name = option.name;
    if (fields.has(name)) continue;
    const Shape<std::string> shape = option_shape(option);
    Field<Options> field;
    field.entry.name = name;
    field.entry.schema = shape.schema;
    field.entry.fallback = "the solver's own";
    field.read = [read = shape.read, name](Options& into, const YamlNode& node, const Spot& spot,
                                           Diagnostics& diagnostics) {
      return read(into[name], node, spot, diagnostics);
    };
    field.write = [write = shape.write, name](const Options& from) {
      const auto found = from.find(name);
      return found == from.end() ? std::nullopt : std::optional<YamlNode>(write(found->second));
    };
    fields.push_back(field);
  }
  return mapping<Options>("options of the named solver itself ('twum solvers' lists them)", fields);
}

// Number of integers in a range; 1 if the range is wrong, which is reported elsewhere.
double values_of(const YamlNode& range) {
  const YamlNode* min = range.find("min");
  const YamlNode* max = range.find("max");
  if (min == nullptr || max == nullptr) return 1;
  const auto low = parse_number(min->scalar);
  const auto high = parse_number(max->scalar);
  return low && high && *low < *high ? std::floor(*high) - std::ceil(*low) + 1 : 1;
}

// Requirements of a study on its solver.
struct Demands {
  bool front;
  bool limits;
  double combinations{1};  // of whole numbers

  explicit Demands(const Given& study) {
    const YamlNode* kind = study.find("kind");
    const YamlNode* variables = study.find("variables");
    front = kind != nullptr && kind->scalar == "pareto";
    limits = study.find("constraints") != nullptr || study.find("limits") != nullptr ||
             study.find("duty") != nullptr;
    if (variables == nullptr) return;
    for (const YamlEntry& entry : variables->entries) {
      const auto parameter = find_parameter(entry.key);
      if (parameter && info(*parameter).integer) combinations *= values_of(entry.value);
    }
  }
};

std::vector<std::string_view> names_for(const Demands& demands) {
  if (demands.front) return {"auto", kNsga2};
  std::vector<std::string_view> names{"auto"};
  for (const optim::SolverInfo& solver : optim::solvers()) names.push_back(solver.name);
  return names;
}

const optim::SolverInfo* info_of(const std::vector<optim::SolverInfo>& solvers,
                                 std::string_view name) {
  for (const optim::SolverInfo& solver : solvers) {
    if (solver.name == name) return &solver;
  }
  return nullptr;
}

class SolverChecker {
 public:
  SolverChecker(const Given& study, Diagnostics& diagnostics)
      : demands_(study), diagnostics_(diagnostics) {}

  void check(const YamlNode& solver) {
    const bool plain = solver.kind == YamlNode::Kind::scalar;
    const YamlNode* name = plain ? &solver : solver.find("name");
    if (name != nullptr && name->kind == YamlNode::Kind::scalar)
      check_name(*name, plain ? "study.solver" : "study.solver.name");
    if (const YamlNode* options = plain ? nullptr : solver.find("options"))
      check_options(*options, name == nullptr ? "auto" : name->scalar);
  }

  // A front by gradients solves every combination of whole numbers.
  void check_whole_numbers(const Given& study) {
    const YamlNode* solver = study.find("solver");
    const YamlNode* name = solver != nullptr ? solver->find("name") : nullptr;
    if (solver != nullptr && solver->kind == YamlNode::Kind::scalar) name = solver;
    if (!demands_.front || (name != nullptr && name->scalar == kNsga2)) return;
    const double count = demands_.combinations;
    constexpr double kMost = 64;  // limit of optim::pareto_front()
    if (count <= kMost) return;
    diagnostics_.add(study.find("variables")->mark, study.path("variables"),
                     rounded_text(count, 6) + " combinations of whole numbers",
                     "at most 64, since a front is found for each; narrow the ranges, or choose "
                     "'solver: nsga2'");
  }

 private:
  void check_name(const YamlNode& name, const std::string& path) {
    const std::vector<std::string_view> names = names_for(demands_);
    const optim::SolverInfo* solver = info_of(optim::solvers(), name.scalar);
    if (std::find(names.begin(), names.end(), name.scalar) == names.end()) {
      diagnostics_.add(name.mark, path, misfit(name.scalar), remedy(name.scalar, names));
      return;
    }
    if (solver == nullptr) return;
    if (!solver->available)
      diagnostics_.add(name.mark, path, quoted(name.scalar) + " cannot be used here",
                       solver->description);
    else if (demands_.limits && !solver->inequality)
      diagnostics_.add(name.mark, path, quoted(name.scalar) + " does not support limits",
                       "nlopt:slsqp, nlopt:mma, nlopt:cobyla and ipopt do");
  }

  // What a name is that no solver for this study has.
  static std::string misfit(const std::string& name) {
    if (info_of(optim::solvers(), name) != nullptr)
      return "solver " + quoted(name) + " does not compute fronts";
    if (info_of(optim::least_squares_solvers(), name) != nullptr)
      return "solver " + quoted(name) + " only fits measurements (kind: calibrate)";
    return "unknown solver " + quoted(name);
  }

  static std::string remedy(std::string_view name, const std::vector<std::string_view>& names) {
    constexpr std::size_t kFew = 4;
    if (names.size() > kFew && nearest(name, names).empty())
      return "'twum solvers' lists them; 'auto' chooses";
    return did_you_mean(name, names);
  }

  void check_options(const YamlNode& options, std::string_view solver) {
    const std::string_view family = solver.substr(0, solver.find(':'));
    for (const YamlEntry& entry : options.entries) {
      const auto& known = optim::solver_options();
      const bool named = std::any_of(known.begin(), known.end(),
                                     [&](const auto& o) { return o.name == entry.key; });
      const bool fits = std::any_of(known.begin(), known.end(), [&](const auto& o) {
        return o.name == entry.key && o.solver == family;
      });
      if (named && !fits)
        diagnostics_.add(entry.key_mark, "study.solver.options." + entry.key,
                         "no option of " + quoted(solver), "'twum solvers' lists them by solver");
    }
  }

  Demands demands_;
  Diagnostics& diagnostics_;
};

}  // namespace

Shape<optim::SolveOptions> solver_shape(const optim::SolveOptions& fresh) {
  using O = optim::SolveOptions;
  const Shape<std::string> name =
      path("a solver ('twum solvers' lists them; for a front: auto or nsga2)", "nlopt:slsqp");
  const auto evaluations = [](auto& options) -> auto& { return options.budget.evaluations; };
  Fields<O> fields{
      standard<O>("name", name, &O::solver),
      standard<O>(
          "starts",
          count("number of local searches from different starts; for `auto` the largest number",
                "8", 1, 1e6),
          &O::starts),
      standard<O>("tolerance", fraction("relative accuracy of the optimum", "1e-8"), &O::tolerance),
      standard<O>("max_evaluations", count("largest number of evaluations", "2000", 1, 1e12),
                  evaluations),
      standard<O>("seed", shapes::seed(), &O::seed),
      hidden(optional<O>("options", options_shape(), &O::solver_options, "the solver's own"))};
  if (fresh.scan > 0)  // fronts have no scan
    fields.insert(2, standard<O>("scan",
                                 count("number of designs sampled over the whole range after the "
                                       "searches, to find a better local optimum; 0: none",
                                       "512", 0, 1e6),
                                 &O::scan));
  const auto options = mapping<O>("a solver and its options", fields, {}, fresh);
  const auto plain = shape_as<O, std::string>(
      name,
      [fresh](std::string typed) {
        O named = fresh;
        named.solver = std::move(typed);
        return named;
      },
      [](const O& value) { return value.solver; });
  auto shape = one_of<O>("solver: a name, or a mapping of options", {plain, options},
                         [](const O&) { return std::size_t{1}; });
  shape.schema.sample = "name: auto\nstarts: 8\nseed: 1";
  return shape;
}

void check_solver(const Given& study, Diagnostics& diagnostics) {
  SolverChecker checker(study, diagnostics);
  if (const YamlNode* solver = study.find("solver")) checker.check(*solver);
  checker.check_whole_numbers(study);
}

}  // namespace twum::inline v0_1::studies
