// SPDX-License-Identifier: Apache-2.0
#include "solvers/allowance.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {

// Of the best design, by more than a hundred thousandth, or a tenth of what limits are broken by.
bool Allowance::gains() {
  constexpr double kOfObjective = 1e-5, kOfExcess = 0.1;
  if (!nlp_.best()) return false;
  const Candidate& best = *nlp_.best();
  const bool feasible = best.violation <= nlp_.session().options().feasibility_tolerance;
  const bool less = best.f < objective_ - kOfObjective * std::max(1.0, std::abs(objective_));
  const bool nearer = best.excess < (1 - kOfExcess) * excess_;
  if (any_ && feasible == feasible_ && !(feasible ? less : nearer)) return false;
  any_ = true, feasible_ = feasible, objective_ = best.f, excess_ = best.excess;
  return true;
}

bool Allowance::take(std::span<const double> z) {
  // A point is asked for by the objective and by two lists of limits, and a search that begins or
  // ends asks for a few points again: some ten requests in a row, far below this.
  constexpr std::size_t kMostRequestsWithoutEvaluation = 1000;
  // Searches that end by themselves gain at least so often.
  const std::size_t most_without_gain = 60 + 20 * nlp_.size();
  if (used_up()) return false;
  const std::size_t evaluations = nlp_.session().counters().evaluations;
  requests_without_evaluation_ = evaluations == evaluations_ ? requests_without_evaluation_ + 1 : 0;
  evaluations_ = evaluations;
  if (requests_without_evaluation_ > kMostRequestsWithoutEvaluation) {
    stall();
    return false;
  }
  if (last_.size() == z.size() && std::equal(z.begin(), z.end(), last_.begin())) return true;
  if (nlp_.reached_known()) {
    word_ = kKnownOptimum;
    return false;
  }
  if (points_ == 0) {
    word_ = "MAXEVAL_REACHED";
    return false;
  }
  without_gain_ = gains() ? 0 : without_gain_ + 1;
  if (search_ == Search::local && without_gain_ > most_without_gain) {
    stall();
    return false;
  }
  --points_;
  last_.assign(z.begin(), z.end());
  return true;
}

}  // namespace twum::optim
