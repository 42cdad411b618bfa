// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/solver_process.hpp>

namespace {

[[maybe_unused]] const bool named = [] {
  twum::optim::use_solver_process({TWUM_SOLVER_PROCESS});
  return true;
}();

}  // namespace
