// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace twum::inline v0_1 {

/// Gauss-Legendre rule on 0 .. 1.
struct GaussRule {
  /// A place and the share of the integral that is taken there.
  struct Node {
    double place;   ///< inside 0 .. 1
    double weight;  ///< all together 1
  };
  std::vector<Node> nodes;  ///< in rising order
};

/// The rule of a number of nodes, made once in each thread; it lives as long as the thread.
const GaussRule& gauss_rule(int nodes);

}  // namespace twum::inline v0_1
