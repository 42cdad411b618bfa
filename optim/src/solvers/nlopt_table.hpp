// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlopt.h>
#include <span>

namespace twum::inline v0_1::optim {

/// One NLopt algorithm: its name in the library and its capabilities.
struct NloptAlgorithm {
  const char* name;
  nlopt_algorithm id;
  const char* description;
  bool gradient;
  bool inequality;
  bool equality;
  bool global;
  bool stochastic;
  bool compares_only;          ///< only compares designs, so that a failed one can be ranked last
  nlopt_algorithm subsidiary;  ///< algorithm that it needs, or NLOPT_NUM_ALGORITHMS
  const char* refusal;         ///< why it is not offered; empty if it is
};

/// Every algorithm of the library.
std::span<const NloptAlgorithm> nlopt_algorithms();

/// Whether the algorithm may compute forever between two requests, see docs/optimization.md.
bool may_turn_for_ever(const NloptAlgorithm& algorithm);

}  // namespace twum::inline v0_1::optim
