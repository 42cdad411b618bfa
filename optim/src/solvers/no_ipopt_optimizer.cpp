// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include "solvers/optimizer.hpp"

namespace twum::inline v0_1::optim {

std::vector<Optimizer> ipopt_optimizers() {
  SolverInfo info;
  info.name = "ipopt";
  info.description = "this build was made without Ipopt (TWUM_WITH_IPOPT=OFF)";
  info.gradient = true;
  info.inequality = true;
  info.equality = true;
  info.available = false;
  return {{info,
           [](const SolverInfo& i, Nlp&, std::span<const double>, const RunSettings&) -> RunReport {
             throw InputError("solver '" + i.name + "' cannot be used: " + i.description);
           }}};
}

std::vector<SolverOption> ipopt_options() { return {}; }

}  // namespace twum::inline v0_1::optim
