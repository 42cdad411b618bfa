// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace twum::performance {

/// Gauss-Legendre rule on 0 .. 1.
struct GaussRule {
  struct Node {
    double place, weight;
  };
  std::vector<Node> nodes;  ///< in rising order
};

/// The rule of a number of nodes, made once in each thread; it lives as long as the thread.
const GaussRule& gauss_rule(int nodes);

}  // namespace twum::performance
