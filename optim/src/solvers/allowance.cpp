// SPDX-License-Identifier: Apache-2.0
#include "solvers/allowance.hpp"

#include <algorithm>

namespace twum::optim {

bool Allowance::take(std::span<const double> z) {
  // A point is asked for by the objective and by two lists of limits, and a search that begins or
  // ends asks for a few points again: some ten requests in a row, far below this.
  constexpr std::size_t kMostRequestsWithoutEvaluation = 1000;
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
  --points_;
  last_.assign(z.begin(), z.end());
  return true;
}

}  // namespace twum::optim
