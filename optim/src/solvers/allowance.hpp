// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/nlp.hpp"

#include <algorithm>
#include <optional>

namespace twum::inline v0_1::optim {

/// Word of a run that was ended because it came to an optimum that is known already.
inline constexpr const char* kKnownOptimum = "KNOWN_OPTIMUM";

/// Limits the requests of one solver run: the number of distinct points, and the number of requests in a row that
/// need no evaluation. A solver in an endless loop returns to stored points, or asks for points that are not finite;
/// a budget of evaluations does not end that. A run that has come to the known optimum of its Nlp gets no more points. Nor does a
/// local search whose best design no longer gets better: where values end, a solver may step across the end and back for ever.
class Allowance {
 public:
  enum class Search : unsigned char { local, global };
  /// Keeps a reference. @param points  distinct points; a request counts if its point differs from that of the
  /// request before
  Allowance(Nlp& nlp, std::size_t points, Search search)
      : nlp_(nlp), points_(points), search_(search) {}

  /// Counts a request. False once a limit is exceeded; it then stays false.
  bool take(std::span<const double> z);

  /// The next request counts as a new point, wherever it is.
  void forget_last() { last_.clear(); }

  /// Uses up the allowance of a solver that no longer sends requests.
  void stall() { word_ = "STALLED"; }

  bool used_up() const { return word_[0] != '\0'; }

  /// Why it is used up, as a return code such as "STALLED"; empty if it is not.
  const char* word() const { return word_; }

  /// Points that may still be requested, within the limit of the session.
  std::size_t points() const { return std::min(points_, nlp_.session().left()); }

 private:
  // The best design when it last became better.
  struct Gain {
    double objective, excess;
    bool feasible;
  };
  bool gains();

  Nlp& nlp_;
  std::size_t points_;
  Search search_;
  std::size_t without_gain_{0};  // points in a row
  std::optional<Gain> last_gain_;
  std::size_t requests_without_evaluation_{0};  // in a row
  std::size_t evaluations_{0};
  std::vector<double> last_;
  const char* word_{""};
};

}  // namespace twum::inline v0_1::optim
