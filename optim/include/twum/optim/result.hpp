// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/optim/options.hpp>

namespace twum::inline v0_1::optim {

/// Outcome of a search as twum has checked it. It does not depend on a solver's return code.
enum class Outcome : std::uint8_t {
  optimal,     ///< feasible, and the certificate passes
  feasible,    ///< feasible, but the search stopped short of a certified optimum
  infeasible,  ///< the search ended without a feasible design
  budget,      ///< evaluations or time ran out, or a stop was requested
  failed       ///< no design could be evaluated
};

/// "optimal", "feasible", "infeasible", "budget" or "failed"; static lifetime.
const char* to_string(Outcome outcome);

/// Why the last solver stopped.
enum class StopReason : std::uint8_t { finished, evaluations, seconds, requested };
/// Its name; static lifetime.
const char* to_string(StopReason value) noexcept;

/// Evaluations of a search.
struct Counters {
  std::size_t evaluations{0};                   ///< calls of the evaluator
  std::size_t gradients{0};                     ///< of these, with a Jacobian
  std::size_t reused{0};                        ///< requests that were answered from earlier calls
  std::map<std::string, std::size_t> failures;  ///< failed calls by reason

  /// All failed calls.
  std::size_t failed() const;
  /// True if designs were tried and none could be evaluated.
  bool all_failed() const { return evaluations > 0 && failed() == evaluations; }
  /// Adds the counts of another search.
  void add(const Counters& other);
  /// Subtracts counts that were added before.
  void subtract(const Counters& other);
};

/// How much one limit has to be relaxed.
struct Relaxation {
  std::string name;        ///< of the constraint
  Side side{Side::upper};  ///< which of its limits
  double limit{0.0};       ///< as asked
  /// relaxation that the least infeasible design needs, >= 0 [unit of the constraint]
  double amount{0.0};
  /// smallest relaxation that makes the problem feasible if only this limit is relaxed; NaN: none found
  double amount_alone{0.0};
};

/// An end of a variable's range that contributes to the infeasibility.
struct RangeEnd {
  std::string variable;    ///< whose range
  Side side{Side::upper};  ///< which end
  double limit{0.0};       ///< as asked, user units
  /// The value of this end nearest to `limit` for which a feasible design was found, with all other ends and limits
  /// as asked. NaN: none was found, or the variable does not allow it (Variable::lowest, highest).
  double limit_alone{std::numeric_limits<double>::quiet_NaN()};
};

/// A limit for which no design within the ranges was found, even without all other limits.
struct Impossible {
  std::string name;        ///< of the constraint
  Side side{Side::upper};  ///< which of its limits: lower or upper
  double limit{0.0};       ///< as asked, user units
  double best{0.0};        ///< nearest value found within the ranges, user units
  bool certified{false};   ///< the certificate of a local optimum passed for that value
  /// range ends that prevent a better value: positions in Infeasibility::ranges
  std::vector<std::size_t> ends;
  std::vector<double> design{};  ///< the design with that value, user units
};

/// Why a problem has no feasible design. An elastic solve finds the design with the smallest sum of scaled
/// violations. Each limit violated there is then tested on its own. All statements are local ones, found from several
/// starts.
struct Infeasibility {
  std::vector<double> design;           ///< the least infeasible one, user units
  std::vector<Relaxation> relaxations;  ///< limits to relax together, or one of them alone
  std::vector<Impossible> impossible;   ///< limits that cannot be met even without the others
  /// Constraints that cause the infeasibility: first those impossible on their own, then others that exclude each
  /// other.
  std::vector<std::string> conflict;
  std::vector<RangeEnd> ranges;  ///< range ends that contribute
  bool certified{false};  ///< the design is a certified stationary point of the sum of violations
};

/// One solver run, for the report.
struct StageReport {
  std::uint64_t stage{0};      ///< number of the stage
  std::string solver;          ///< its name
  std::string word;            ///< the solver's message
  int code{0};                 ///< the solver's return code
  bool feasible{false};        ///< whether it has found a feasible design
  double objective{0.0};       ///< best objective found by this stage, user units; NaN if none
  std::size_t evaluations{0};  ///< calls of the evaluator
};

/// Result of sampling the whole range for a better optimum; see look_further().
struct Scan {
  std::size_t designs{0};   ///< designs evaluated
  std::size_t feasible{0};  ///< of these, designs that meet every limit
  std::size_t better{0};    ///< of these, designs better than the optimum of the local searches
  bool replaced{false};     ///< the answer was found by a search from the best of these
  double before{std::numeric_limits<
      double>::quiet_NaN()};  ///< objective of the local searches' optimum, user units
};

/// The answer of a solve, with its certificate.
struct Result {
  Outcome outcome{Outcome::failed};       ///< outcome as twum has checked it
  StopReason stop{StopReason::finished};  ///< why it ended
  std::vector<double>
      design;               ///< best feasible design, or the least infeasible one; empty if failed
  Evaluation evaluation;    ///< of that design, with its Jacobian where it has one
  Certificate certificate;  ///< of that design
  Infeasibility infeasibility;      ///< filled when the outcome is infeasible
  Scan scan;                        ///< filled by look_further()
  Counters counters;                ///< of all stages
  std::vector<StageReport> stages;  ///< every solver run
  std::string solver;               ///< name of the solver that found the answer
  double seconds{0.0};              ///< wall time
  std::uint64_t stages_used{0};  ///< the next solve may begin with stage first_stage + stages_used
};

}  // namespace twum::inline v0_1::optim
