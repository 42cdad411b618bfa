// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace twum::inline v0_1::cli {

/// The work of a command; returns an exit status.
using Action = std::function<int()>;

/// Each function adds one command with its options. When the command is chosen, `action` is set to its work.
void add_curve(CLI::App& app, Action& action);
void add_fields(CLI::App& app, Action& action);
void add_explore(CLI::App& app, Action& action);
void add_frequency(CLI::App& app, Action& action);
void add_map(CLI::App& app, Action& action);
void add_heat(CLI::App& app, Action& action);
void add_life(CLI::App& app, Action& action);
void add_move(CLI::App& app, Action& action);
void add_linearize(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_stator(CLI::App& app, Action& action);
void add_evaluate(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_datasheet(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_metrics(CLI::App& app, Action& action);
void add_parameters(CLI::App& app, Action& action);
void add_materials(CLI::App& app, Action& action);
void add_solvers(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_init(CLI::App& app, Action& action);

}  // namespace twum::inline v0_1::cli
