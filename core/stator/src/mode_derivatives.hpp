// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plate_solver.hpp"

#include <twum/stator/geometry.hpp>

#include <vector>

namespace twum::inline v0_1::stator {

/// A solution in numbers of the kind S.
template <typename S>
struct Solution {
  S eigenvalue;                 ///< omega^2 [1/s^2]
  std::vector<S> coefficients;  ///< c' M c = 1
};

/// Derivative of an eigenvalue (P5.1).
Derived derived_eigenvalue(const Mesh& mesh, const std::vector<SegmentOf<Derived>>& segments,
                           const Spectrum& spectrum, std::size_t mode);

/// Derivatives of eigenvalue and eigenvector (P5.1, P5.2, P5.3). The eigenvalue must be simple.
Solution<Derived> derived_solution(const Mesh& mesh, const std::vector<Segment>& segments,
                                   const std::vector<SegmentOf<Derived>>& dual_segments,
                                   const Spectrum& spectrum, std::size_t mode);

}  // namespace twum::inline v0_1::stator
