// SPDX-License-Identifier: Apache-2.0
#include "app.hpp"

#include "command.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "licence.hpp"
#include "message.hpp"
#include "output.hpp"
#include "progress.hpp"

#include <twum/base/error.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/result_store.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/processes.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <thread>
#include <typeinfo>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  twum init motor -o ring.yaml                        a commented motor file to start from
  twum curve ring.yaml                                torque-speed curve and metrics
  twum curve ring.yaml --set "preload=140 N" --format csv -o curve.csv
  twum evaluate ring.yaml --designs designs.csv --metrics "stall_torque, speed_at(0.5 N.m)"
  twum init optimize -o study.yaml                    a commented study file to start from
  twum run study.yaml                                 runs it, or resumes it

Exit status: 0 done: of a search, its design or front keeps all limits; 1 there is no such design, the
motor of a calibration does not fit the points, or nothing has a value; 2 the input is wrong;
3 a file could not be written or read, or an internal error; 130 interrupted.)text";

// Of several processes started together, only the first reports errors in the input.
int complain(const std::string& text, int status) {
  if (status == kWrongInput && studies::launched_number() > 0) {
    // mpirun ends all processes as soon as one fails: the first one, which tells why, may still have to begin.
    std::this_thread::sleep_for(std::chrono::seconds(2));
    return status;
  }
  may_colour_errors() ? say_with_red_carets(text) : say(text);
  return status;
}

std::vector<std::string_view> command_names(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

int unknown_command(const CLI::App& app, const std::string& word) {
  const std::vector<std::string_view> names = command_names(app);
  return complain("twum: unknown command " + studies::quoted(word) + "; " +
                      studies::did_you_mean(word, names) + " ('twum --help' lists the commands)",
                  kWrongInput);
}

// Arguments that no option and no position accepts. The first option among them is the most likely mistake.
int unexpected_words(const CLI::App& command, const std::vector<std::string>& rest) {
  std::string word = rest.empty() ? "" : rest.front();
  for (const std::string& one : rest) {
    if (one.starts_with('-') && !word.starts_with('-')) word = one;
  }
  word = word.substr(0, word.find('='));
  const std::vector<std::string> names = option_names(command);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const bool near = word.starts_with('-') && !studies::nearest(word, views).empty();
  return complain("twum " + command.get_name() + ": unexpected " + studies::quoted(word) + "; " +
                      (near ? studies::did_you_mean(word, views)
                            : "see 'twum " + command.get_name() + " --help'"),
                  kWrongInput);
}

int explain(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0)
    return app.exit(error) == 0 ? kDone : kWrongInput;  // --help, --version
  if (app.get_subcommands().empty()) {
    const std::vector<std::string> rest = app.remaining(true);
    if (!rest.empty()) return unknown_command(app, rest.front());
    return complain("twum: no command given\n\n" + app.help(), kWrongInput);
  }
  const CLI::App& command = *app.get_subcommands().front();
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    return unexpected_words(command, app.remaining(true));
  }
  return complain("twum " + command.get_name() + ": " + error.what() + "; see 'twum " +
                      command.get_name() + " --help'",
                  kWrongInput);
}

// Refuses an option with an empty value, as from a script with an empty variable; it does not mean that the option is
// missing.
void refuse_empty_options(const CLI::App& app) {
  const CLI::App& command = *app.get_subcommands().front();
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& given = option->results();
    if (std::find(given.begin(), given.end(), "") == given.end()) continue;
    throw InputError(command.get_name() + ": " + option->get_name() +
                     " is given as an empty text; give a value, or leave it out");
  }
}

// Any other command would run in each process, and all would write the same files.
void refuse_several_processes(const CLI::App& app) {
  const std::string& name = app.get_subcommands().front()->get_name();
  const unsigned processes = studies::launched_processes();
  if (name == "run" || processes < 2) return;
  throw InputError(name + ": started " + std::to_string(processes) +
                   " times at once; only 'twum run' shares its work among processes: start "
                   "'twum " +
                   name + "' without mpirun");
}

int perform(const Action& action) {
  try {
    return action();
  } catch (const ClosedPipe&) {
    return kDone;  // the reader of the pipe has stopped reading
  } catch (const studies::Interrupted&) {
    return complain("twum: interrupted", kInterrupted);
  } catch (const OutputError& error) {
    return complain(std::string("twum: ") + error.what(), kFailed);
  } catch (const studies::FileError& error) {
    return complain(error.what(), kWrongInput);
  } catch (const InputError& error) {
    return complain(std::string("twum: ") + error.what(), kWrongInput);
  } catch (const std::bad_alloc&) {
    return complain("twum: not enough memory", kFailed);
  } catch (const Error& error) {
    return complain(std::string("twum: ") + error.what(), kFailed);
  } catch (const BugError& error) {
    return complain(std::string("twum: ") + error.what(), kFailed);
  } catch (const std::exception& error) {
    return complain(
        std::string("twum: internal error, please report it with this command and its files: ") +
            typeid(error).name(),
        kFailed);
  }
}

}  // namespace

int run(int argc, char** argv) {
  install_interrupt_handler();
  CLI::App app("twum - design of travelling wave ultrasonic motors", "twum");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(kExamples);
  Action action;
  for (const auto add : {add_curve,      add_fields,    add_explore,  add_frequency, add_map,
                         add_heat,       add_life,      add_move,     add_linearize, add_export,
                         add_stator,     add_datasheet, add_evaluate, add_run,       add_check,
                         add_report,     add_plot,      add_compare,  add_verify,    add_metrics,
                         add_parameters, add_materials, add_solvers,  add_schema,    add_init}) {
    add(app, action);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explain(app, error);
  } catch (const InputError& error) {
    return complain(std::string("twum: ") + error.what(), kWrongInput);
  }
  return perform([&] {
    refuse_empty_options(app);
    refuse_several_processes(app);
    return action();
  });
}

}  // namespace twum::inline v0_1::cli
