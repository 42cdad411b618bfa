// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/gauss_rule.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace twum::inline v0_1::core {

/// A track that is not worn evenly (V3.1). Nodes are those of Gauss' rule over its whole width: they are points of the material, which
/// no zone splits.
struct WornTrack {
  std::vector<double> deviations;  ///< of the worn depth from its mean, from the inner edge on [m]
  double thickness_share;          ///< s chi, what the layer loses of it [1]

  int nodes() const { return static_cast<int>(deviations.size()); }
  /// Linear between nodes, as that of the last one beyond them.
  /// @param place  0 at the inner edge, 1 at the outer one
  double at(double place) const {
    const auto& rule = gauss_rule(nodes()).nodes;
    const auto after = std::find_if(rule.begin(), rule.end(),
                                    [&](const auto& node) { return node.place >= place; });
    if (after == rule.begin()) return deviations.front();
    if (after == rule.end()) return deviations.back();
    const auto k = static_cast<std::size_t>(after - rule.begin());
    const double share = (place - rule[k - 1].place) / (rule[k].place - rule[k - 1].place);
    return deviations[k - 1] + share * (deviations[k] - deviations[k - 1]);
  }
  /// Distance between the deepest and the highest node [m].
  double spread() const {
    const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
    return *most - *least;
  }
};

}  // namespace twum::inline v0_1::core
