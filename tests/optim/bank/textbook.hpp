// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <limits>

namespace twum::test {

/// A problem of a collection, with the box in which the collection leaves a variable free.
struct Textbook {
  std::string name;
  optim::Problem problem;  ///< unbounded variables have infinite bounds; see boxed()
  double best{0.0};        ///< published optimum
};

/// Problems of W. Hock and K. Schittkowski, Test Examples for Nonlinear Programming Codes (1981), and of Liang et al.,
/// Problem Definitions and Evaluation Criteria for the CEC 2006 Special Session (G01 to G24), with the published starts
/// (CEC has none: the middle of the box) and optima.
std::vector<Textbook> textbook();

/// The problem in a box of half width `width` about the origin, as far as its own bounds allow; a start outside of the
/// box is moved into it.
optim::Problem boxed(const Textbook& problem, double width);

}  // namespace twum::test
