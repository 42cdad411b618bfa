// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::test {

/// A problem of two objectives (minimized) whose front is known in closed form.
struct KnownFront {
  std::string name;
  optim::Problem problem;
  std::vector<double> reference;
  double exact{0.0};                       ///< hypervolume of the whole front; 0: not in the books
  std::vector<std::vector<double>> front;  ///< dense points on it, in order of the first objective
  bool many_local_fronts{false};           ///< local searches alone miss it
};

/// ZDT1-4 and 6 (Zitzler, Deb, Thiele 2000), BNH (Binh and Korn 1997), SRN (Srinivas and Deb 1994),
/// OSY (Osyczka and Kundu 1995), TNK (Tanaka et al. 1995), with about `density` points each.
std::vector<KnownFront> known_fronts(std::size_t density);

/// DTLZ1 (7 variables) and DTLZ2 (12 variables) with three objectives (Deb et al. 2002).
optim::Problem dtlz1();
optim::Problem dtlz2();

/// The largest hypervolume of `count` points of a front, by dynamic programming over its points.
double best_hypervolume(const std::vector<std::vector<double>>& front, std::size_t count,
                        const std::vector<double>& reference);

}  // namespace twum::test
