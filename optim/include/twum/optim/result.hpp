// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>

namespace twum::optim {

/// What was found, in our words. A solver's own word is never taken for it.
enum class Outcome : std::uint8_t {
  optimal,     ///< feasible, and the certificate passes
  feasible,    ///< feasible, but the search stopped short of a certified optimum
  infeasible,  ///< the search ended without a feasible design
  budget,      ///< evaluations, time or patience (a stop request) ran out first
  failed       ///< no design could be evaluated
};

/// "optimal", "feasible", "infeasible", "budget" or "failed"; static lifetime.
const char* to_string(Outcome outcome);

/// Why the last solver stopped.
enum class StopReason : std::uint8_t { finished, evaluations, seconds, requested };

/// What a search cost.
struct Counters {
  std::size_t evaluations{0};                   ///< calls of the evaluator
  std::size_t gradients{0};                     ///< of these, with a Jacobian
  std::size_t reused{0};                        ///< requests answered without a call
  std::map<std::string, std::size_t> failures;  ///< failed calls by reason

  /// Failed calls, of whatever reason.
  std::size_t failed() const;
  /// Designs were tried, and none could be evaluated.
  bool all_failed() const { return evaluations > 0 && failed() == evaluations; }
  /// Adds the counts of another search.
  void add(const Counters& other);
  /// Takes away counts that were added before.
  void subtract(const Counters& other);
};

/// How much one limit has to give way.
struct Relaxation {
  std::string name;        ///< of the constraint
  Side side{Side::upper};  ///< which of its limits
  double limit{0.0};       ///< as asked
  double amount{0.0};      ///< >= 0, at the least infeasible design [unit of the constraint]
  double alone{0.0};  ///< smallest relaxation of this limit alone that would do; NaN: none found
};

/// An end of a variable's range that takes part in what no design can keep.
struct RangeEnd {
  std::string variable;    ///< whose range
  Side side{Side::upper};  ///< which end
  double limit{0.0};       ///< as asked, user units
  /// The nearest place found for this end at which a design keeps every limit, all other ends and limits as
  /// asked. NaN: none was found, or the variable does not allow the move (Variable::lowest, highest).
  double alone{std::numeric_limits<double>::quiet_NaN()};
};

/// A limit that no design within the ranges was found to keep, even without every other limit.
struct Impossible {
  std::string name;               ///< of the constraint
  Side side{Side::upper};         ///< which of its limits: lower or upper
  double limit{0.0};              ///< as asked, user units
  double best{0.0};               ///< value nearest to it within the ranges, user units
  bool certified{false};          ///< that value passed the certificate of a local optimum
  std::vector<std::size_t> ends;  ///< ends that prevent more, positions in Infeasibility::ranges
  std::vector<double> design{};   ///< with that value, user units
};

/// Why a problem has no feasible design. An elastic solve finds the design with the smallest sum of the
/// scaled violations; limits broken there are then tried by themselves. Every statement is a local one, from
/// several starts.
struct Infeasibility {
  std::vector<double> design;           ///< the least infeasible one, user units
  std::vector<Relaxation> relaxations;  ///< limits that must give way, or would help alone
  std::vector<Impossible> impossible;   ///< limits that cannot be kept even alone
  /// Constraints at fault: those impossible alone, then those of the others that exclude each other.
  std::vector<std::string> conflict;
  std::vector<RangeEnd> ranges;  ///< ends of ranges with a part in it
  bool certified{false};         ///< the design is a stationary point of the violation
};

/// One solver run, for the report.
struct StageReport {
  std::uint64_t stage{0};      ///< its number
  std::string solver;          ///< its name
  std::string word;            ///< the solver's own word
  int code{0};                 ///< and code
  bool feasible{false};        ///< it has found a feasible design
  double objective{0.0};       ///< best found by this stage, user units; NaN without a success
  std::size_t evaluations{0};  ///< calls of the evaluator
};

/// What a sample of the whole range said of an optimum; see look_further().
struct Scan {
  std::size_t designs{0};   ///< evaluated
  std::size_t feasible{0};  ///< of these, within every limit
  std::size_t better{0};    ///< of these, better than the optimum that the local searches had found
  bool replaced{false};     ///< a search from the best of these found the answer
  double before{std::numeric_limits<
      double>::quiet_NaN()};  ///< objective of the local searches' optimum, user units
};

/// What a solve has found, and the evidence for it.
struct Result {
  Outcome outcome{Outcome::failed};       ///< in our words
  StopReason stop{StopReason::finished};  ///< why it ended
  std::vector<double>
      design;               ///< best feasible design, or the least infeasible one; empty if failed
  Evaluation evaluation;    ///< of that design, with its Jacobian where it has one
  Certificate certificate;  ///< of that design
  Infeasibility infeasibility;      ///< filled when the outcome is infeasible
  Scan scan;                        ///< what look_further() saw, if it was asked
  Counters counters;                ///< of all stages
  std::vector<StageReport> stages;  ///< every solver run
  std::string solver;               ///< whose answer it is
  double seconds{0.0};              ///< wall time
  std::uint64_t stages_used{0};     ///< first_stage + stages_used is free for the next solve
};

}  // namespace twum::optim
