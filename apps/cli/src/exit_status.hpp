// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1::cli {

/// Exit status of the program.
enum ExitStatus : int {
  kDone = 0,
  kNoAnswer = 1,  ///< the study ran but found no feasible or converged answer
  kWrongInput = 2,
  kFailed = 3,  ///< a file could not be written or read back, or an internal error
  kInterrupted = 130
};

}  // namespace twum::inline v0_1::cli
