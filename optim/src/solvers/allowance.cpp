// SPDX-License-Identifier: Apache-2.0
#include "solvers/allowance.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

// The best design counts as better if its objective falls by a hundred thousandth or, as long as it breaks limits, what they are
// broken by falls by a tenth: a search that converges does more within some tens of points.
bool Allowance::gains() {
  constexpr double kOfObjective = 1e-5, kOfExcess = 0.1;
  if (!nlp_.best()) return false;
  const Candidate& best = *nlp_.best();
  const Gain now{best.f, best.excess,
                 best.violation <= nlp_.session().options().feasibility_tolerance};
  if (last_gain_ && last_gain_->feasible == now.feasible) {
    const auto& [objective, excess, feasible] = *last_gain_;
    const double least = kOfObjective * std::max(1.0, std::abs(objective));
    const bool less = now.objective < objective - least;
    const bool nearer = now.excess < (1 - kOfExcess) * excess;
    if (!(feasible ? less : nearer)) return false;
  }
  last_gain_ = now;
  return true;
}

bool Allowance::take(std::span<const double> z) {
  // A point is asked for by the objective and by two lists of limits, and a search that begins or
  // ends asks for a few points again: some ten requests in a row, far below this.
  constexpr std::size_t kMostRequestsWithoutEvaluation = 1000;
  // A search that converges gains far more often.
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

}  // namespace twum::inline v0_1::optim
