// SPDX-License-Identifier: Apache-2.0
#include "solid/calculix.hpp"

#include "interrupt.hpp"
#include "output.hpp"
#include "running_program.hpp"

#include <twum/io/result_store.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Thirty times what the default mesh takes: then a finer one is hopeless.
constexpr std::chrono::minutes kTimeLimit{30};
// Short against the second within which a stop request is honoured.
constexpr std::chrono::milliseconds kPause{20};

struct Run {
  std::string name;
  RunningProgram program;
};

Run started(const std::string& folder, const std::string& name) {
  auto program = RunningProgram::start({"ccx", "-i", name}, folder, name + ".log");
  if (!program)
    throw OutputError(
        "CalculiX, which solves the stator as a solid, is not installed: no program 'ccx' was "
        "found; install the Debian package calculix-ccx");
  return {name, std::move(*program)};
}

// The first error that CalculiX printed, or how its output ends.
std::string reason_of(const std::string& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    const std::string words(studies::trimmed(line));
    if (words.find("*ERROR") != std::string::npos) return studies::printable(words, 200);
    if (!words.empty()) last = words;
  }
  return last.empty() ? "it printed nothing"
                      : "the last that it printed is '" + studies::printable(last, 200) + "'";
}

void check_success(const std::string& folder, const Run& run) {
  if (run.program.succeeded()) return;
  throw OutputError("CalculiX failed at " + run.name +
                    ".inp: " + reason_of(folder + "/" + run.name + ".log"));
}

// Those that still run; the others are checked.
std::vector<Run> still_running(const std::string& folder, std::vector<Run> runs) {
  std::vector<Run> left;
  for (Run& run : runs) {
    if (run.program.ended())
      check_success(folder, run);
    else
      left.push_back(std::move(run));
  }
  return left;
}

}  // namespace

void run_calculix(const std::string& folder, const std::vector<std::string>& names) {
  const auto end = Clock::now() + kTimeLimit;
  const std::size_t at_once = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Run> runs;
  for (auto next = names.begin(); next != names.end() || !runs.empty();) {
    if (interrupted()) throw studies::Interrupted();
    if (Clock::now() > end)
      throw OutputError("CalculiX was stopped after 30 min; use a smaller --mesh");
    while (next != names.end() && runs.size() < at_once) runs.push_back(started(folder, *next++));
    std::this_thread::sleep_for(kPause);
    runs = still_running(folder, std::move(runs));
  }
}

}  // namespace twum::inline v0_1::cli
