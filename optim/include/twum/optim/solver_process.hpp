// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// @file
/// Some solvers may compute for ever between two requests (SolverInfo::own_process). A thread cannot be ended safely,
/// a process can: these solvers run in a process of their own, and are refused in a program that names none.

namespace twum::inline v0_1::optim {

/// Names the command that these processes run, for the whole program; it has to call serve_solver(). To be called
/// before the first solve. The program `twum` names itself.
void use_solver_process(std::vector<std::string> command);

/// The main function of such a process. Searches come through the standard input, which is a socket, until the program
/// at its other end closes it or ends.
/// @return exit code of the process
int serve_solver();

}  // namespace twum::inline v0_1::optim
