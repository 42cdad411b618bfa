// SPDX-License-Identifier: Apache-2.0
#include "problem/first_design.hpp"

#include <twum/optim/low_discrepancy.hpp>

namespace twum::inline v0_1::optim {

std::optional<FirstDesign> first_design(Session& session, const Scaling& scaling) {
  constexpr std::size_t kTries = 1024;  // find 1 design in 200 all but surely
  std::vector<std::vector<double>> tries{start_design(session.problem())};
  for (std::size_t i = 0; i < tries.size(); ++i) {
    const Evaluation& e = session.at(tries[i], true);
    if (e.ok()) return FirstDesign{tries[i], e};
    if (i > 0 || scaling.size() == 0) continue;
    // Another seed than that of the starts, or the same search would run twice.
    for (const auto& u : sobol_points(scaling.size(), kTries, session.options().seed + 1))
      tries.push_back(scaling.to_design(scaling.from_range(u)));
  }
  return std::nullopt;
}

}  // namespace twum::inline v0_1::optim
