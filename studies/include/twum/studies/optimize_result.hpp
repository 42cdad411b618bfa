// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/optim/result.hpp>
#include <twum/studies/move.hpp>
#include <twum/studies/robust_result.hpp>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {

/// Objective of a search.
struct Goal {
  std::string metric;    ///< as typed
  std::string unit;      ///< SI
  bool maximize{false};  ///< otherwise minimize
};

/// A limit at a design, SI.
struct LimitState {
  std::string text;      ///< as typed
  std::string metric;    ///< what is limited: one side, or left minus right
  std::string unit;      ///< SI unit of the metric
  bool at_least{false};  ///< a lower limit
  /// value of the metric; NaN if the motor has none, such as a speed at a load that it cannot carry
  double value{0};
  double limit{0};       ///< SI; if there are two ends, the active or nearer one
  double violation{0};   ///< amount by which the limit is violated, >= 0
  bool active{false};    ///< the limit is active at the design
  double multiplier{0};  ///< improvement of the goal per unit of relaxation, >= 0
  /// change of the goal if the limit is relaxed by 1 %, to first order
  double gain_per_percent{0};
  double lower{0};  ///< lower end of the metric, SI; -infinity: none
  double upper{0};  ///< upper end of the metric, SI; infinity: none
  /// violation up to which the limit counts as kept (O2.1), SI; NaN: the design was not certified
  double tolerance{std::numeric_limits<double>::quiet_NaN()};
  bool implied{false};  ///< it follows from the metrics that were asked for
};

/// A variable at the end of its range, SI.
struct BoundState {
  StoredColumn variable;  ///< which one
  bool upper{false};      ///< the upper end
  double limit{0};        ///< SI
  double multiplier{0};   ///< improvement of the goal per unit by which the range is extended, >= 0
  /// change of the goal if the end is moved outwards by 1 %, to first order
  double gain_per_percent{0};
};

/// The set that a design has of a choice.
struct ChosenSet {
  std::string choice;  ///< its name, such as "lining"
  std::string set;     ///< name of the set, such as the path of its file
};

/// A design as a search reports it.
struct DesignReport {
  /// variables, derived parameters, parameters from sets, and parameters changed by `start:`
  std::vector<NamedValue> design;
  std::vector<NamedValue> metrics;      ///< every metric without argument, then the requested ones
  std::vector<LimitState> constraints;  ///< every limit of the study
  std::vector<BoundState> bounds;       ///< active ends of ranges
  optim::Certificate certificate;       ///< evidence that it is a local optimum
  std::vector<ChosenSet> choice{};      ///< one for each choice of the study
  /// goals that are statistics, from a new random sample of motors
  std::vector<NamedValue> statistics{};
};

/// Whether a limit is violated by more than its tolerance; without one, by more than 1e-8 of the limit. True where there
/// is no value.
bool broken(const LimitState& limit);

/// Whether no limit of the design is broken().
bool keeps_limits(const DesignReport& report);

/// Improvement of each goal per unit of relaxation of a limit with this multiplier, while the other goals stay as
/// they are. NaN for a goal that does not trade to first order.
std::vector<double> gains(double multiplier, const optim::Certificate& certificate);

/// How far one limit has to be relaxed, SI.
struct RelaxationState {
  std::string text;        ///< as typed
  std::string metric;      ///< what is limited
  std::string unit;        ///< SI
  bool at_least{false};    ///< a lower limit
  double limit{0};         ///< as asked, SI
  double amount{0};        ///< relaxation if all limits with an amount are relaxed together, >= 0
  double amount_alone{0};  ///< relaxation if only this limit is relaxed; NaN: that does not help
  /// Both sides depend on the motor: `limit` is 0, the limit of the left one minus the right one.
  bool of_two_sides{false};
};

/// A limit for which no design within the ranges was found, even without all other limits. SI.
struct ImpossibleState {
  std::string text;       ///< as typed
  std::string unit;       ///< SI
  bool at_least{false};   ///< a lower limit
  double limit{0};        ///< as asked, SI
  double best{0};         ///< nearest value found within the ranges, SI
  bool certified{false};  ///< the best value is a certified local optimum
  /// range ends that prevent a better value: positions in Explanation::ranges
  std::vector<std::size_t> ends;
  std::vector<ChosenSet> choice{};  ///< of the design with the best value
  bool of_two_sides{false};         ///< both sides depend on the motor: `best` is left minus right
};

/// An end of a variable's range that contributes to the infeasibility. SI.
struct RangeState {
  StoredColumn variable;  ///< which one
  bool upper{false};      ///< the upper end
  double limit{0};        ///< as asked
  /// where this end has to be if nothing else changes; NaN: no such value was found
  double limit_alone{0};
};

/// Why no design meets all limits; empty() if one does.
struct Explanation {
  /// limits that cause it: first those impossible on their own, then those that exclude each other
  std::vector<std::string> conflict;
  std::vector<ImpossibleState> impossible;  ///< limits that cannot be met even without the others
  std::vector<RangeState> ranges;           ///< range ends that contribute
  std::vector<RelaxationState> limits;      ///< limits to relax together, or one of them alone
  std::vector<ChosenSet> choice{};  ///< of the least infeasible design, to which `limits` refer

  /// Nothing to explain.
  bool empty() const { return conflict.empty() && limits.empty(); }
};

/// Answer of `optimize` and `size`.
struct OptimizeResult {
  Goal goal;          ///< objective of the search
  bool found{false};  ///< false: no design could be evaluated, and `best` is empty
  DesignReport best;  ///< the best design, or the least infeasible one
  std::vector<NamedValue> before_design;  ///< variables of the motor before the search
  /// metrics of the motor before the search, the same as those of the best design
  std::vector<NamedValue> before_metrics;
  std::vector<NamedValue> before_statistics;  ///< its statistics, likewise
  std::vector<std::string>
      without_influence;  ///< variables without influence on the goal or an active limit
  /// integer variables of the best design at an end of their range
  std::vector<BoundState> whole_ends;
  Explanation explanation;  ///< why no design meets all limits
  optim::Scan scan;         ///< result of sampling the whole range for a better optimum
  std::string solver;       ///< name of the solver that found the answer
  std::vector<optim::StageReport> stages;  ///< report of each solver run
  /// radial_slices of each run, where the search chooses them; empty otherwise. Values of runs with different numbers differ by
  /// the error of the coarser contact
  std::vector<int> slices_of_stages;
  /// numbers whose derivatives follow: the variables that are free, then the goal
  std::vector<NamedValue> moving;
  std::vector<Move> moves;  ///< their derivatives by each fixed parameter that has an influence
  /// why there are no derivatives; empty if there are, or if none were requested
  std::string unmoved;
  /// fixed parameters that have no such derivatives, each a radius with another one that is equal to it
  std::vector<std::pair<std::string, std::string>> touching;
  std::optional<RobustReport> robust;  ///< under tolerances; `best` is then the robust optimum
};

}  // namespace twum::inline v0_1::studies
