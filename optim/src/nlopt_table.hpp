// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlopt.h>
#include <span>

namespace twum::optim {

/// One NLopt algorithm: what the library calls it and what it can take by itself.
struct NloptAlgorithm {
  const char* name;
  nlopt_algorithm id;
  const char* description;
  bool gradient;
  bool inequality;
  bool equality;
  bool global;
  bool stochastic;
  bool compares_only;          ///< ranks designs, so that a failed one can be ranked last
  nlopt_algorithm subsidiary;  ///< that it cannot do without, or NLOPT_NUM_ALGORITHMS
  const char* refusal;         ///< why it is not offered; empty: it is
};

/// Every algorithm of the library.
std::span<const NloptAlgorithm> nlopt_algorithms();

/// Whether nothing proves that it comes back between two requests, see docs/optimization.md.
bool may_turn_for_ever(const NloptAlgorithm& algorithm);

}  // namespace twum::optim
