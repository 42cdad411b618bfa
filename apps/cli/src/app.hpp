// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1::cli {

/// The whole program: reads the arguments, runs the command, and returns the exit status. Results go to standard
/// output or files, everything else to standard error.
int run(int argc, char** argv);

}  // namespace twum::inline v0_1::cli
