// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/optim/robust.hpp>
#include <twum/studies/estimate.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A wanted share of motors, and its estimate from a new random sample of motors.
struct RobustYield {
  std::string text;          ///< "yield", or the probability as typed
  double target{0};          ///< wanted share; NaN if the share is the goal
  Estimate share;            ///< estimate from new random motors, 95 % interval
  std::uint64_t samples{0};  ///< new random motors
  /// from an importance sample about the worst points, for yields above 99.99 %
  bool weighted{false};
  /// "holds", "not-distinguishable" or "broken"; empty if the share is the goal
  std::string verdict;
};

/// A statistic with a limit or as a goal, estimated from new random motors.
struct RobustStatistic {
  std::string text;  ///< as typed, such as "mean(peak_power)"
  std::string unit;  ///< SI
  double lower{0};   ///< limits, SI; infinite: none
  double upper{0};   ///< likewise
  Estimate value{};  ///< estimate from the motors with an answer, 95 % interval
};

/// Contribution of one limit to the risk.
struct RobustLimit {
  std::string text;       ///< as typed
  bool at_least{true};    ///< its lower end
  std::string target;     ///< the yield or probability that it counts in
  double beta{0};         ///< reliability index
  double delta{0};        ///< correction of its margin in the last round, SI
  double probability{0};  ///< share of the new random motors that violate it; NaN without motors
  double share{0};  ///< share of it among those that violate any limit of the target; likewise
  std::vector<NamedValue>
      importance{};  ///< share of each tolerance in its failures, sum 1; empty with measured parts
  bool converged{true};  ///< the search for its worst point converged
};

/// Value of tightening one tolerance.
struct RobustTolerance {
  std::string name;  ///< of the parameter
  std::string unit;  ///< of the spread: "%" of the design's value, or SI
  double spread{0};  ///< in that unit: standard deviation, half range, or width below the mode
  /// improvement of the goal if the tolerance is 1 % tighter, to first order; NaN if no design was found, and where it
  /// would follow from failures with measured parts
  double gain{0};
  double yield_gain{0};  ///< improvement of the yield for the same change, at the same design
  /// the same from the failing motors only, 95 % interval; NaN if the distribution is not normal
  Estimate sampled_gain{};
};

/// How a metric with a limit scatters.
struct RobustDensity {
  std::string metric;             ///< as typed
  std::string unit;               ///< SI
  double lower{0};                ///< ends of its limit, SI; infinite: none
  double upper{0};                ///< likewise
  double first{0};                ///< left end of the first bin, SI
  double width{0};                ///< of a bin, SI
  std::vector<double> motors{};   ///< share of the motors in each bin
  std::vector<double> nominal{};  ///< the same for the optimum without tolerances
};

/// Results of `optimize` and `size` for built motors.
struct RobustReport {
  std::string parts{};              ///< name of the table of measured parts; empty: none
  std::uint64_t part_count{0};      ///< how many there are
  std::vector<RobustYield> yields;  ///< one for each wanted yield
  /// means, standard deviations and quantiles with a limit or as a goal
  std::vector<RobustStatistic> statistics;
  double objective{0};  ///< the goal at the robust optimum, SI
  /// Goal at the optimum without tolerances, SI. NaN if the goal has no value without tolerances; the nominal
  /// design below is then the motor before the search.
  double nominal_objective{0};
  std::vector<NamedValue> nominal_design;   ///< its variables
  Estimate nominal_yield;                   ///< yield of its motors
  std::vector<RobustLimit> limits;          ///< contribution of each limit to the risk
  std::vector<RobustTolerance> tolerances;  ///< value of tightening each tolerance
  double price_of_yield{0};                 ///< loss of the goal per unit of yield, first order
  std::vector<optim::YieldPrice> prices_of_yields;  ///< best goal at several yields, rising
  double largest_yield{0};  ///< largest yield if the wanted one cannot be reached; else NaN
  std::vector<optim::RobustRoundReport> rounds;  ///< rounds of correction
  /// yields that the rounds aimed at; the answer is that of the last one
  std::vector<double> aimed;
  std::map<std::string, std::uint64_t> lost;  ///< new random motors without an answer, by reason
  std::vector<RobustDensity> densities;       ///< of each metric with a limit
};

}  // namespace twum::inline v0_1::studies
