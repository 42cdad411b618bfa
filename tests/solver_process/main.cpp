// SPDX-License-Identifier: Apache-2.0
// The program in which tests run solvers that may compute for ever.
#include <twum/optim/solver_process.hpp>

int main() { return twum::optim::serve_solver(); }
