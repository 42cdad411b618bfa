// SPDX-License-Identifier: Apache-2.0
#include "app.hpp"

#include <twum/optim/solver_process.hpp>

#include <string_view>

namespace {

// As which this program starts itself for solvers that may compute for ever; not a command for people.
constexpr const char* kSolverProcess = "--solver-process";

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == kSolverProcess) return twum::optim::serve_solver();
  twum::optim::use_solver_process({"/proc/self/exe", kSolverProcess});
  return twum::cli::run(argc, argv);
}
