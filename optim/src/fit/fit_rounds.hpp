// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <string>

/// Fits in which parameters and scatter are estimated in turn. Internal.
namespace twum::inline v0_1::optim {

/// Rounds after which such a fit is given up; most settle in ten.
inline constexpr int kMostRounds = 60;

/// The evaluations are used up, or a stop is requested.
inline bool cut_short(const LeastSquaresOptions& options, const Counters& counters) {
  return options.stop.stop_requested() || options.max_evaluations <= counters.evaluations;
}

/// Marks a fit whose parameters and scatter do not belong together yet.
inline void leave_unsettled(const LeastSquaresOptions& options, const Counters& counters,
                            LeastSquaresResult& fit) {
  if (fit.estimates.empty() || fit.outcome == Outcome::budget) return;
  const bool cut = cut_short(options, counters);
  fit.outcome = cut ? Outcome::budget : Outcome::feasible;
  fit.word =
      cut ? "stopped before parameters and scatter had settled"
          : "parameters and scatter did not settle in " + std::to_string(kMostRounds) + " rounds";
}

}  // namespace twum::inline v0_1::optim
