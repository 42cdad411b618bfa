// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "listing.hpp"
#include "output.hpp"

#include <twum/optim/least_squares.hpp>
#include <twum/optim/solvers.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kText =
    R"text(Give one of these names in `solver: {name: ...}` of a study. `auto`, the default, searches from several
starts, certifies the best design, and tries other solvers if that fails (see
[optimization](../optimization.md)). The column "gradient" says whether a solver needs gradients; exact
gradients are always available. Every available solver stays within the bounds of the variables; limits on
metrics are inequalities. The last two are for studies of kind `calibrate`, for example `solver: gsl:lm`. This page
is the output of `twum solvers --format markdown`; `twum solvers --options` lists the options only.)text";

constexpr const char* kOptionsText =
    R"text(Options of single solvers. They are entries of `solver: options:`. The options of `nlopt` apply to every
solver whose name begins with `nlopt:`.)text";

constexpr const char* kSolversExamples = R"text(Examples:
  twum solvers
  twum solvers --options
  twum solvers --format json)text";

struct SolversOptions {
  bool options{false};
  OutputOptions output;
};

std::string mark(bool flag) { return flag ? "yes" : ""; }

void add_rows(Listing& listing, const std::vector<optim::SolverInfo>& solvers) {
  for (const optim::SolverInfo& solver : solvers) {
    listing.rows.push_back(
        {solver.name, solver.gradient ? "needed" : "",
         solver.augmented ? "augmented" : mark(solver.inequality),
         solver.augmented && solver.equality ? "augmented" : mark(solver.equality),
         mark(solver.global), mark(solver.stochastic), solver.available ? "yes" : "no",
         solver.description});
  }
}

Listing solver_list() {
  Listing listing{
      "Solvers",
      kText,
      {"name", "gradient", "inequality", "equality", "global", "stochastic", "available", "text"},
      {}};
  add_rows(listing, optim::solvers());
  add_rows(listing, optim::least_squares_solvers());
  return listing;
}

Listing option_list() {
  Listing listing{"Options", kOptionsText, {"name", "solver", "type", "range", "text"}, {}};
  for (const optim::SolverOption& option : optim::solver_options())
    listing.rows.push_back({option.name, option.solver, option.type, option.range(), option.text});
  return listing;
}

int run_solvers(const SolversOptions& options) {
  Output output(options.output.path);
  const bool page = options.output.format == "markdown";
  std::string text = to_text(options.options ? option_list() : solver_list(), options.output.format,
                             options.output.table_width());
  if (page && !options.options) text += "\n#" + to_text(option_list(), "markdown");
  output.write(text);
  output.finish();
  return kDone;
}

}  // namespace

void add_solvers(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SolversOptions>();
  CLI::App* command =
      app.add_subcommand("solvers", "Lists the solvers, their requirements and their options");
  command->add_flag("--options", options->options, "List the options of the solvers instead");
  add_output_options(*command, options->output, {"table", "csv", "json", "markdown"});
  command->footer(kSolversExamples);
  command->callback([options, &action] { action = [options] { return run_solvers(*options); }; });
}

}  // namespace twum::inline v0_1::cli
