// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nlp.hpp"

#include <algorithm>

namespace twum::optim {

/// What one run of a solver may still ask for: distinct points, and requests in a row that need no
/// evaluation. A solver in a loop comes back to points that are remembered, or to no points at all
/// (coordinates that are not finite); no budget of evaluations ends that.
class Allowance {
 public:
  /// Keeps a reference. @param points  distinct points, counted from one request to the next
  Allowance(Nlp& nlp, std::size_t points) : nlp_(nlp), points_(points) {}

  /// Counts a request. False once too much was asked for; then it stays false.
  bool take(std::span<const double> z);

  /// The next request counts as a new point, wherever it is.
  void forget_last() { last_.clear(); }

  /// Takes all that is left from a solver that asks for nothing any more.
  void stall() { word_ = "STALLED"; }

  bool used_up() const { return word_[0] != '\0'; }

  /// Why it is used up, in the words of a solver; empty if it is not.
  const char* word() const { return word_; }

  /// Points that may still be asked for, those that the session allows counted.
  std::size_t points() const { return std::min(points_, nlp_.session().left()); }

 private:
  Nlp& nlp_;
  std::size_t points_;
  std::size_t idle_{0};  // requests since the last evaluation
  std::size_t evaluations_{0};
  std::vector<double> last_;
  const char* word_{""};
};

}  // namespace twum::optim
