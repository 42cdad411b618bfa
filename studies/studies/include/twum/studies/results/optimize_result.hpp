// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/studies/results/move.hpp>
#include <twum/studies/results/robust_result.hpp>
#include <twum/studies/store/column.hpp>

#include <optional>
#include <string>
#include <vector>

namespace twum::studies {

/// What was wanted.
struct Goal {
  std::string metric;    ///< as typed
  std::string unit;      ///< SI
  bool maximize{false};  ///< otherwise it should be small
};

/// A limit at a design, SI.
struct LimitState {
  std::string text;      ///< as typed
  std::string metric;    ///< what is limited: one side, or left minus right
  std::string unit;      ///< SI unit of the metric
  bool at_least{false};  ///< a lower limit
  double value{0};      ///< NaN: the motor has none, such as a speed at a load that it cannot carry
  double limit{0};      ///< SI; of two ends the one that is active, or nearer
  double violation{0};  ///< by how much the limit is broken, >= 0
  bool active{false};   ///< it holds the design back
  double multiplier{
      0};  ///< improvement of the goal for each unit by which the limit gives way, >= 0
  double gain_per_percent{0};  ///< change of the goal when the limit gives way by 1 %, first order
  double lower{0};             ///< lower end of the metric, SI; -infinity: none
  double upper{0};             ///< upper end of the metric, SI; infinity: none
};

/// A variable at the end of its range, SI.
struct BoundState {
  StoredColumn variable;  ///< which one
  bool upper{false};      ///< the upper end
  double limit{0};        ///< SI
  double multiplier{0};  ///< improvement of the goal for each unit by which the end gives way, >= 0
  double gain_per_percent{0};  ///< change of the goal when it gives way by 1 %, first order
};

/// What a design has of a choice.
struct ChosenSet {
  std::string choice;  ///< its name, such as "lining"
  std::string set;     ///< name of the set, such as the path of its file
};

/// A design as a search reports it.
struct DesignReport {
  std::vector<NamedValue>
      design;  ///< the variables, what follows, what sets give, what a `start:` changed
  std::vector<NamedValue> metrics;       ///< every metric without argument, then those asked for
  std::vector<LimitState> constraints;   ///< every limit of the study
  std::vector<BoundState> bounds;        ///< only those that hold the design back
  optim::Certificate certificate;        ///< the evidence
  std::vector<ChosenSet> choice{};       ///< of each choice of the study
  std::vector<NamedValue> statistics{};  ///< goals that are statistics, by new random motors
};

/// Whether a limit of this design is broken by more than an active limit may be: by a millionth of itself,
/// or, where the certificate measured it (a limit of 0 has no millionth), by the tolerance of the
/// search. True where there is no value.
bool broken(const LimitState& limit, const DesignReport& report);

/// Whether none of its limits is broken().
bool keeps_limits(const DesignReport& report);

/// What a unit by which a limit gives way improves each goal while the other goals stay as they are,
/// by the multiplier of the limit; NaN for a goal that does not trade to first order.
std::vector<double> gains(double multiplier, const optim::Certificate& certificate);

/// How far one limit would have to give way, SI.
struct RelaxationState {
  std::string text;      ///< as typed
  std::string metric;    ///< what is limited
  std::string unit;      ///< SI
  bool at_least{false};  ///< a lower limit
  double limit{0};       ///< as asked, SI
  double amount{0};      ///< of all that give way together, >= 0
  double alone{0};       ///< if only this one does; NaN: it does not help alone
};

/// A limit that no design within the ranges was found to keep, even without every other limit. SI.
struct ImpossibleState {
  std::string text;                 ///< as typed
  std::string unit;                 ///< SI
  bool at_least{false};             ///< a lower limit
  double limit{0};                  ///< as asked, SI
  double best{0};                   ///< value nearest to it within the ranges, SI
  bool certified{false};            ///< the best value is a certified local optimum
  std::vector<std::size_t> ends;    ///< ends that prevent more, positions in Explanation::ranges
  std::vector<ChosenSet> choice{};  ///< of the design with the best value
};

/// An end of a variable's range with a part in what no design keeps. SI.
struct RangeState {
  StoredColumn variable;  ///< which one
  bool upper{false};      ///< the upper end
  double limit{0};        ///< as asked
  double alone{0};  ///< where it has to be if nothing else changes; NaN: no such place was found
};

/// Why no design satisfies all limits; empty() where one does.
struct Explanation {
  std::vector<std::string>
      conflict;  ///< limits at fault: impossible alone, then those that exclude each other
  std::vector<ImpossibleState> impossible;  ///< limits that cannot be kept even alone
  std::vector<RangeState> ranges;           ///< ends of ranges with a part in it
  std::vector<RelaxationState> limits;      ///< limits that must give way, or would help alone
  std::vector<ChosenSet> choice{};  ///< of the least infeasible design, to which `limits` refer

  /// Nothing to explain.
  bool empty() const { return conflict.empty() && limits.empty(); }
};

/// Answer of `optimize` and `size`.
struct OptimizeResult {
  Goal goal;          ///< what was wanted
  bool found{false};  ///< false: no design could be evaluated, and `best` is empty
  DesignReport best;  ///< of an infeasible question the least infeasible design
  std::vector<NamedValue> before_design;      ///< the motor as it was: its variables
  std::vector<NamedValue> before_metrics;     ///< the same metrics as those of the best
  std::vector<NamedValue> before_statistics;  ///< the same statistics
  std::vector<std::string>
      without_influence;  ///< variables without influence on the goal or an active limit
  std::vector<BoundState> whole_ends;      ///< whole numbers of the best at an end of their range
  Explanation explanation;                 ///< why no design satisfies all limits
  optim::Scan scan;                        ///< what a sample of the whole range said of it
  std::string solver;                      ///< whose answer it is
  std::vector<optim::StageReport> stages;  ///< what each solver run said of itself
  std::vector<NamedValue> moving;          ///< what moves: the variables that may, then the goal
  std::vector<Move> moves;                 ///< of these, by each held parameter that counts
  std::string unmoved;  ///< why there are no moves; empty: there are, or none were looked for
  std::optional<RobustReport> robust;  ///< under tolerances; `best` is then the robust optimum
};

}  // namespace twum::studies
