// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>
#include <twum/studies/statistics/estimate.hpp>
#include <twum/studies/store/column.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twum::studies {

/// A share of the motors that was asked for, and what new random motors say.
struct RobustYield {
  std::string text;          ///< "yield", or the probability as typed
  double target{0};          ///< wanted share; NaN where it is the goal
  Estimate share;            ///< of new random motors, 95 % interval
  std::uint64_t samples{0};  ///< new random motors
  bool weighted{false};      ///< drawn about the worst points and weighted: of yields above 99.99 %
  std::string verdict;  ///< "holds", "not-distinguishable" or "broken"; empty where it is the goal
};

/// A statistic that was limited or wanted, as new random motors have it.
struct RobustStatistic {
  std::string text;  ///< as typed, such as "mean(peak_power)"
  std::string unit;  ///< SI
  double lower{0};   ///< limits, SI; infinite: none
  double upper{0};   ///< likewise
  Estimate value{};  ///< of the motors with an answer, 95 % interval
};

/// What one limit has to do with the risk.
struct RobustLimit {
  std::string text;                      ///< as typed
  bool at_least{true};                   ///< its lower end
  std::string target;                    ///< the yield or probability that it counts in
  double beta{0};                        ///< reliability index
  double delta{0};                       ///< correction of its margin in the last round, SI
  double probability{0};                 ///< share of the new random motors that break it
  double share{0};                       ///< of those that break any limit of the target
  std::vector<NamedValue> importance{};  ///< share of each tolerance in its failures, sum 1
  bool converged{true};                  ///< its worst point was found exactly
};

/// What one tolerance costs.
struct RobustTolerance {
  std::string name;      ///< of the parameter
  std::string unit;      ///< of the spread: "%" of the design's value, or SI
  double spread{0};      ///< in that unit: standard deviation, half range, or width below the mode
  double gain{0};        ///< of the goal if it is 1 % tighter, first order; NaN: not reached
  double yield_gain{0};  ///< of the yield then, at the same design
  Estimate
      sampled_gain{};  ///< the same from the failing motors alone, 95 % interval; NaN where the law is not normal
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
  std::vector<double> nominal{};  ///< the same of the optimum without tolerances
};

/// What `optimize` and `size` say about built motors.
struct RobustReport {
  std::vector<RobustYield> yields;  ///< each that was asked for
  std::vector<RobustStatistic>
      statistics;       ///< means, standard deviations and quantiles that are limited or wanted
  double objective{0};  ///< the goal at the robust optimum, SI
  double nominal_objective{
      0};  ///< of the optimum without tolerances, SI; NaN: the goal has no value without tolerances, and
           ///< what is nominal below is that of the motor as it was
  std::vector<NamedValue> nominal_design;   ///< its variables
  Estimate nominal_yield;                   ///< share of its motors that would pass
  std::vector<RobustLimit> limits;          ///< where the risk goes
  std::vector<RobustTolerance> tolerances;  ///< what each costs
  double price_of_yield{0};                 ///< loss of the goal per unit of yield, first order
  std::vector<optim::YieldPrice> prices_of_yields;  ///< goal over yield, rising
  double largest_yield{0};  ///< where the wanted one cannot be reached; else NaN
  std::vector<optim::RobustRoundReport> rounds;  ///< of correction
  std::vector<double> aimed;                     ///< yields aimed at, the last one counts
  std::map<std::string, std::uint64_t> lost;     ///< new random motors without an answer, by reason
  std::vector<RobustDensity> densities;          ///< of each metric with a limit
};

}  // namespace twum::studies
