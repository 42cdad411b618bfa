// SPDX-License-Identifier: Apache-2.0
// What a study file is told where entries do not go together.
#include "entries/resolved_study.hpp"
#include "entries_support.hpp"
#include "schema/scalar_checks.hpp"

#include <twum/base/error.hpp>
#include <twum/io/shape.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/yaml_loader.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

// "entry: found; expected" of everything that is wrong with a study.
std::vector<std::string> complaints(const std::string& study) {
  const ScratchFolder folder;
  std::vector<std::string> lines;
  try {
    study_in(folder, study);
  } catch (const FileError& error) {
    for (const Diagnostic& one : error.diagnostics())
      lines.push_back(one.entry + ": " + one.found + "; " + one.expected);
  }
  return lines;
}

using Lines = std::vector<std::string>;

Lines grid(const std::string& variables) {
  return complaints("{kind: sweep, sampling: grid, metrics: [stall_torque], variables: {" +
                    variables + "}}");
}

Lines optimize(const std::string& more) {
  return complaints(
      "{kind: optimize, maximize: peak_power, variables: {preload: {min: 100 N, max: "
      "200 N}}, " +
      more + "}");
}

template <typename T>
struct Holder {
  T x{};
};

// What a shape says of the value of an entry x.
template <typename T>
Lines said_of(const Shape<T>& x, const std::string& text) {
  const Shape<Holder<T>> whole =
      mapping<Holder<T>>("whole", {required<Holder<T>>("x", x, &Holder<T>::x)});
  const Source source("text", text);
  Diagnostics diagnostics(source);
  Holder<T> read;
  const bool right = whole.read(read, load_yaml(diagnostics), {{}, {1, 1}}, diagnostics);
  CHECK(right == diagnostics.empty());
  Lines lines;
  try {
    diagnostics.throw_if_any();
  } catch (const FileError& error) {
    for (const Diagnostic& one : error.diagnostics())
      lines.push_back(one.entry + ": " + one.found + "; " + one.expected);
  }
  return lines;
}

Schema number(double min, double max) {
  Schema schema;
  schema.kind = ValueKind::quantity;
  schema.min = min;
  schema.max = max;
  return schema;
}

}  // namespace

TEST_CASE("a grid over whole numbers has to hit them", "[studies][study][error]") {
  const std::string remedy = "; must be whole numbers; give a list of values, or other 'points'";
  CHECK(grid("wavelengths: {min: 8, max: 12}").empty());  // five points: 8, 9, 10, 11, 12
  CHECK(grid("wavelengths: {min: 8, max: 10, points: 3}").empty());
  CHECK(grid("wavelengths: {min: 8, max: 9, points: 3}") ==
        Lines{"study.variables.wavelengths: a grid point at 8.5" + remedy});
  CHECK(grid("n: {min: 8, max: 10}") == Lines{"study.variables.n: a grid point at 8.5" + remedy});
  CHECK(grid("wavelengths: {min: 2, max: 8, points: 3, scale: log}").empty());  // 2, 4, 8
  CHECK(grid("wavelengths: {min: 2, max: 8, points: 3, scale: linear}").empty());
  CHECK(grid("wavelengths: {min: 2, max: 9, points: 3, scale: log}") ==
        Lines{"study.variables.wavelengths: a grid point at 4.24264" + remedy});  // the root of 18
  CHECK(grid("wavelengths: [8, 10]").empty());
  CHECK(grid("preload: {min: 1 N, max: 2 N}").empty());  // not whole numbers
  // What is wrong by itself is said once, and no grid is looked for in it.
  CHECK(grid("wavelengths: {min: 8, max: ten}").size() == 1);
  CHECK(grid("wavelengths: {min: eight, max: 10}").size() == 1);
  CHECK(grid("wavelengths: {min: 10, max: 8}") ==
        Lines{"study.variables.wavelengths.max: '8' is not above min; must be more than 10"});
  CHECK(grid("wavelengths: {min: 8, max: 9, points: 1}").size() == 1);
  CHECK(grid("wavelengths: {min: 8, max: 9, points: 2000000}").size() == 1);
  CHECK(grid("wavelengths: {max: 9}").size() == 1);
  CHECK(grid("wavelengths: {min: 8}").size() == 1);
}

TEST_CASE("a grid that says nothing of its points has five of each range", "[studies][run]") {
  const ScratchFolder folder;
  const ResolvedStudy resolved = resolve(study_in(
      folder,
      "{kind: sweep, sampling: grid, metrics: [stall_torque], variables: {preload: {min: 1 N, max: "
      "2 N}, thickness: {min: 1 mm, max: 2 mm, points: 3}, frequency: [30 kHz, 40 kHz]}}"));
  const YamlNode& variables = *resolved.study.find("variables");
  CHECK(variables.find("preload")->find("points")->scalar == "5");
  CHECK(variables.find("thickness")->find("points")->scalar == "3");
  CHECK(variables.find("frequency")->find("points") == nullptr);
  CHECK(resolved.study.find("samples") == nullptr);
  const ResolvedStudy drawn = resolve(study_in(
      folder,
      "{kind: sweep, sampling: lhs, seed: 7, metrics: [stall_torque], variables: {preload: "
      "{min: 1 N, max: 2 N}}}"));
  CHECK(drawn.study.find("variables")->find("preload")->find("points") == nullptr);
  CHECK(drawn.study.find("samples")->scalar == "1000");
  CHECK(drawn.study.find("seed")->scalar == "7");
}

TEST_CASE("rounds of samples end above where they begin", "[studies][study][error]") {
  const auto sobol = [](const std::string& more) {
    return complaints(
        "{kind: sensitivity, method: sobol, metrics: [stall_torque], variables: "
        "{preload: {min: 1 N, max: 2 N}}" +
        more + "}");
  };
  CHECK(sobol(", samples: 1000, width: 0.1, max_samples: 999") ==
        Lines{"study.max_samples: less than samples; must be at least samples"});
  CHECK(sobol(", samples: 1000, width: 0.1, max_samples: 1000").empty());
  CHECK(sobol(", width: 0.1, max_samples: 2").empty());  // of samples nothing is said
  CHECK(sobol(", samples: 1000, width: 0.1").empty());
  CHECK(sobol(", samples: 1000, max_samples: 999") ==
        Lines{"study.max_samples: given without a width; used with 'width' only; leave it out"});
  CHECK(sobol(", samples: [1], width: 0.1, max_samples: 999").size() == 1);
}

TEST_CASE("a probability is there once, however it is written", "[studies][study][error]") {
  const auto quantiles = [](const std::string& list) {
    return complaints(
        "{kind: uncertainty, metrics: [stall_torque], variables: {preload: "
        "{distribution: uniform, min: 1 N, max: 2 N}}, quantiles: " +
        list + "}");
  };
  CHECK(quantiles("[0.05, 0.5]").empty());
  CHECK(quantiles("[0.05, 5 %]") ==
        Lines{"study.quantiles: '5 %' is given twice; leave one of them out"});
  CHECK(quantiles("[0.50, 0.5]").size() == 1);
  CHECK(quantiles("[half, half]").size() == 2);  // no numbers, and that alone is said
  CHECK(quantiles("[[0.5], [0.5]]").size() == 2);
}

TEST_CASE("the entries of a distribution are in order", "[studies][study][error]") {
  const auto preload = [](const std::string& entries) {
    return complaints(
        "{kind: uncertainty, metrics: [stall_torque], variables: {preload: "
        "{distribution: " +
        entries + "}}}");
  };
  const std::string place = "study.variables.preload.";
  CHECK(preload("uniform, min: 2 N, max: 1 N") ==
        Lines{place + "max: '1 N' is not above min; must be more than 2 N"});
  CHECK(preload("triangular, min: 1 N, mode: 1 N, max: 2 N").empty());
  CHECK(preload("triangular, min: 1 N, mode: 2 N, max: 2 N").empty());
  CHECK(preload("triangular, min: 1 N, mode: 3 N, max: 2 N") ==
        Lines{place + "max: '2 N' is not above mode; must be more than 3 N"});
  CHECK(preload("triangular, min: 2 N, mode: 1 N, max: 3 N") ==
        Lines{place + "mode: '1 N' is not above min; must be more than 2 N"});
}

TEST_CASE("a start lies in its range, ends included", "[studies][study][error]") {
  const auto start = [](const std::string& range) {
    return complaints("{kind: optimize, maximize: peak_power, variables: {preload: {" + range +
                      "}}}");
  };
  CHECK(start("min: 1 N, max: 3 N, start: 1 N").empty());
  CHECK(start("min: 1 N, max: 3 N, start: 3 N").empty());
  const std::string outside = "' is outside the range; must lie between min and max";
  CHECK(start("min: 1 N, max: 3 N, start: 4 N") ==
        Lines{"study.variables.preload.start: '4 N" + outside});
  CHECK(start("min: 1 N, max: 3 N, start: 0 N") ==
        Lines{"study.variables.preload.start: '0 N" + outside});
  CHECK(start("max: 3 N, start: 4 N").size() == 2);  // and there is no min
}

TEST_CASE("a study varies something, and a family one thing", "[studies][study][error]") {
  CHECK(complaints("{kind: optimize, maximize: peak_power, variables: {}}") ==
        Lines{"study.variables: no variable; name at least one parameter"});
  CHECK(complaints("{kind: optimize, maximize: peak_power, variables: preload}").size() == 1);
  CHECK(
      complaints("{kind: curve, family: {}}") ==
      Lines{"study.family: found 0 parameters; expected one: a family varies a single parameter"});
  CHECK(complaints("{kind: curve, family: preload}").size() == 1);
  CHECK(complaints("{kind: curve, family: {preload: [1 N]}}").empty());
}

TEST_CASE("a solver has to be one that can be used, with options of its own",
          "[studies][study][error]") {
  CHECK(optimize("solver: nlopt:slsqp").empty());
  CHECK(optimize("solver: {name: auto}").empty());
  CHECK(optimize("solver: nlopt:newuoa") ==
        Lines{"study.solver: 'nlopt:newuoa' cannot be used here; it does not support bounds; use "
              "nlopt:bobyqa"});
  CHECK(optimize("solver: {name: nlopt:newuoa}").at(0).starts_with("study.solver.name: "));
  CHECK(optimize("solver: magic") ==
        Lines{"study.solver: unknown solver 'magic'; 'twum solvers' lists them; 'auto' chooses"});
  // Without a name the options are those of none.
  CHECK(optimize("solver: {options: {mu_init: 0.1}}") ==
        Lines{"study.solver.options.mu_init: no option of 'auto'; 'twum solvers' lists them by "
              "solver"});
  CHECK(optimize("solver: {name: ipopt, options: {mu_init: 0.1}}").empty());
  CHECK(optimize("solver: {name: [ipopt]}").size() == 1);
  CHECK(complaints("{kind: curve, solver: magic}").size() ==
        1);  // an entry that curves do not have
}

TEST_CASE("a front over many whole numbers needs the search that finds such",
          "[studies][study][error]") {
  const auto pareto = [](const std::string& variables, const std::string& solver) {
    return complaints(
        "{kind: pareto, objectives: [{maximize: peak_power}, {minimize: "
        "max_pressure}], variables: {" +
        variables + "}" + solver + "}");
  };
  const std::string waves = "preload: {min: 1 N, max: 2 N}, wavelengths: {min: 8, max: 72}";
  const Lines refused{
      "study.variables: 65 combinations of whole numbers; at most 64, since a front is found for "
      "each; narrow the ranges, or choose 'solver: nsga2'"};
  CHECK(pareto("wavelengths: {min: 9, max: 72}", "").empty());  // 64
  CHECK(pareto(waves, "") == refused);
  CHECK(pareto(waves, ", solver: auto") == refused);
  CHECK(pareto(waves, ", solver: {name: auto}") == refused);
  CHECK(pareto(waves, ", solver: {seed: 3}") == refused);
  CHECK(pareto(waves, ", solver: nsga2").empty());
  CHECK(pareto(waves, ", solver: {name: nsga2}").empty());
  CHECK(pareto("preload: {min: 1 N, max: 2 N}", "").empty());
  CHECK(pareto("preload: {min: 1 N, max: 2 N}", ", solver: nlopt:slsqp") ==
        Lines{"study.solver: solver 'nlopt:slsqp' does not compute fronts; expected one of auto, "
              "nsga2"});
  CHECK(complaints("{kind: optimize, maximize: peak_power, variables: {" + waves + "}}").empty());
  CHECK(
      complaints("{kind: calibrate, data: x.csv, variables: {wavelengths: {min: 8, max: 10}}}") ==
      Lines{"study.variables.wavelengths: only whole numbers, which a fit cannot estimate; set it "
            "in the motor, and make one study for each value"});
}

TEST_CASE("options of a solver are read as the study says, and as the solver reads them",
          "[studies][study]") {
  const ScratchFolder folder;
  const auto options = [&](const std::string& more) {
    const StudyFile file = study_in(folder,
                                    "{kind: optimize, maximize: peak_power, variables: {preload: "
                                    "{min: 1 N, max: 2 N}}" +
                                        more + "}");
    return std::get<OptimizeStudy>(file.asked).solver;
  };
  const optim::SolveOptions own = options("");
  CHECK(own.solver == "auto");
  CHECK(ParetoStudy{}.solver.budget.evaluations == 200000);
  CHECK(own.budget.evaluations == optim::SolveOptions{}.budget.evaluations);
  CHECK(options(", solver: ipopt").solver == "ipopt");
  const optim::SolveOptions given = options(
      ", solver: {starts: 3, tolerance: 1e-9, max_evaluations: 77, seed: 5, name: ipopt, options: "
      "{mu_init: 1.0e-1, mu_strategy: adaptive, max_iter: 7.0}}");
  CHECK(given.solver == "ipopt");
  CHECK(given.starts == 3);
  CHECK(given.tolerance == 1e-9);
  CHECK(given.budget.evaluations == 77);
  CHECK(given.seed == 5);
  CHECK(given.solver_options.at("mu_init") == "0.1");
  CHECK(given.solver_options.at("mu_strategy") == "adaptive");
  CHECK(given.solver_options.at("max_iter") == "7");
  CHECK(options(", solver: {}").starts == own.starts);
}

TEST_CASE("a list says how many items it wants", "[studies][schema]") {
  const auto numbers = [](std::size_t least, std::size_t most) {
    return list("numbers", studies::number(number(0, 1)), least, most);
  };
  CHECK(said_of(numbers(2, 9), "x: [0, 1]\n").empty());
  CHECK(said_of(numbers(2, static_cast<std::size_t>(-1)), "x: [0]\n") ==
        Lines{"x: found 1 item; expected at least 2"});
  CHECK(said_of(numbers(2, 2), "x: [0, 1, 1]\n") == Lines{"x: found 3 items; expected 2"});
  CHECK(said_of(numbers(2, 3), "x: [0, 1, 1, 1]\n") == Lines{"x: found 4 items; expected 2 to 3"});
  CHECK(said_of(numbers(2, 3), "x: []\n") ==
        Lines{"x: found an empty list; expected a number without unit"});
  CHECK(said_of(numbers(2, 3), "x: 3\n") ==
        Lines{"x: found '3'; expected a list, each item a number without unit"});
  CHECK(said_of(numbers(2, 3), "x: {a: 1}\n") ==
        Lines{"x: found a mapping; expected a list, each item a number without unit"});
  CHECK(said_of(numbers(2, 3), "x:\n") ==
        Lines{"x: empty; expected a list, each item a number without unit"});
}

TEST_CASE("a number out of its range is told the limit, and an example if there is one",
          "[studies][schema]") {
  Schema schema = number(2, 5);
  CHECK(said_of(studies::number(schema), "x: 1\n") ==
        Lines{"x: '1' is too small; must be at least 2"});
  CHECK(said_of(studies::number(schema), "x: 6\n") ==
        Lines{"x: '6' is too large; must be at most 5"});
  schema.example = "3";
  CHECK(said_of(studies::number(schema), "x: 6\n") ==
        Lines{"x: '6' is too large; must be at most 5, such as '3'"});
  schema.min_excluded = true;
  CHECK(said_of(studies::number(schema), "x: 2\n") ==
        Lines{"x: '2' is too small; must be more than 2, such as '3'"});
  schema.whole = true;
  CHECK(said_of(studies::number(schema), "x: 2.5\n") ==
        Lines{"x: '2.5' is not a whole number; expected a whole number such as '3'"});
  Schema force = number(0, 10);
  force.unit = "N";
  CHECK(said_of(studies::number(force), "x: -1 N\n") ==
        Lines{"x: '-1 N' is too small; must be at least 0 N"});
}

TEST_CASE("every kind of schema says what it expects", "[studies][schema]") {
  Schema word;
  word.kind = ValueKind::word;
  word.words = {"one"};
  CHECK(expectation(word) == "expected one");
  CHECK(said_of(choice("a word", {"one"}), "x: two\n") ==
        Lines{"x: 'two' is not known here; expected one"});
  word.words = {"linear", "log"};
  CHECK(expectation(word) == "expected one of linear, log");
  CHECK(said_of(choice("a word", {"linear", "log"}), "x: logs\n") ==
        Lines{"x: 'logs' is not known here; did you mean 'log'?"});
  Schema any;
  any.kind = ValueKind::any_of;
  any.alternatives = {word, number(0, 1)};
  CHECK(expectation(any) == "expected one of linear, log or a number without unit");
  const Shape<int> kind = mapping<int>("one", {selector<int>("kind", "what it is", "curve")});
  const Shape<int> other = mapping<int>("other", {selector<int>("kind", "what it is", "sweep")});
  const Shape<int> variant =
      one_of<int>("either", {kind, other}, [](int) { return 0U; }, "kind", {"curve", "sweep"});
  CHECK(expectation(variant.schema) == "expected a mapping with kind: curve, sweep");
  CHECK(said_of(variant, "x: {kind: sweep}\n").empty());
  CHECK(said_of(variant, "x: {kind: [sweep]}\n") ==
        Lines{"x.kind: found a list; expected one of curve, sweep"});
  CHECK(said_of(variant, "x: {kind: sweeps}\n") ==
        Lines{"x.kind: 'sweeps' is not known here; did you mean 'sweep'?"});
  CHECK(said_of(variant, "x: {}\n") == Lines{"x.kind: missing; expected one of curve, sweep"});
  CHECK(expectation(kind.schema) == "expected a mapping with kind");
  Schema text;
  CHECK(expectation(text) == "expected a text");
  CHECK(said_of(path("", ""), "x: ''\n") == Lines{"x: empty; expected a text"});
  text.example = "points.csv";
  CHECK(expectation(text) == "expected a text such as 'points.csv'");
}

TEST_CASE("names that other kinds of study have are known", "[studies][study][error]") {
  const Lines lines = complaints(
      "{kind: optimize, maximize: peak_power, parameters: {preload: {min: 1 N, max: 2 N}}}");
  CHECK(lines == Lines{"study.parameters: unknown entry; did you mean 'variables'?"});
  CHECK(complaints("{kind: curve, parameters: 3}").at(0).find("did you mean") == std::string::npos);
}

TEST_CASE("a path through a schema leads to its entry, or nowhere", "[studies][schema]") {
  const Schema& file = study_file_schema();
  CHECK(find_path(file, "motor")->name == "motor");
  CHECK(find_path(file, "set.preload")->name == "preload");
  for (const char* none : {"x", "set.x", "set.preload.x"}) CHECK(find_path(file, none) == nullptr);
}
