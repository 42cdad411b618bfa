// SPDX-License-Identifier: Apache-2.0
#include "drive/branch_piece.hpp"

#include <algorithm>
#include <cstdint>

namespace twum::inline v0_1::core {

std::pair<const CurveNode*, const CurveNode*> BranchPiece::around(double speed) const {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, speed,
                                      [](double s, const CurveNode& n) { return s < n.parameter; });
  return {&*(above - 1), &*above};
}

std::array<const CurveNode*, 2> BranchPiece::outer_neighbours(const CurveNode& a,
                                                              const CurveNode& b) const {
  const std::uint64_t zones = a.solved.signature();
  if (b.solved.signature() != zones) return {};
  const auto if_like = [&](const CurveNode& n) {
    return n.solved.signature() == zones && same_slices(n, a) ? &n : nullptr;
  };
  return {&a > &nodes.front() ? if_like(*(&a - 1)) : nullptr,
          &b < &nodes.back() ? if_like(*(&b + 1)) : nullptr};
}

}  // namespace twum::inline v0_1::core
