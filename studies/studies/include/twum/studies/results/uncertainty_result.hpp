// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/statistics/estimate.hpp>
#include <twum/studies/store/column.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twum::studies {

/// Answer of an uncertainty study: how metrics spread over motors drawn by their tolerances.
struct UncertaintyResult {
  /// Value that a share of the motors stays below.
  struct Quantile {
    double probability;  ///< in (0, 1)
    Estimate value;      ///< SI
  };
  /// How one metric spreads.
  struct Metric {
    StoredColumn column;              ///< its name and unit
    std::uint64_t count{0};           ///< motors that have a value; the rest enters nothing below
    Estimate mean;                    ///< SI
    Estimate sd;                      ///< standard deviation, SI
    std::vector<Quantile> quantiles;  ///< in the order asked
  };
  /// How many motors keep one limit.
  struct Limit {
    std::string text;    ///< as typed
    std::string metric;  ///< what is limited
    double lower;        ///< SI; -infinity: none
    double upper;        ///< SI; infinity: none
    Estimate kept;       ///< fraction of motors
  };
  /// A variable whose distribution reaches beyond what is admissible.
  struct CutOff {
    std::string variable;  ///< its name
    double share;          ///< of the distribution, cut off
  };

  double confidence{0.95};    ///< level of all intervals
  std::uint64_t samples{0};   ///< motors drawn
  std::uint64_t failed{0};    ///< of these, failed or incomplete
  std::uint64_t no_value{0};  ///< of these, without a value that a limit needs: it is not kept
  std::string start;          ///< the other study whose best design is the motor; empty: none
  std::vector<StoredColumn> variables;  ///< in the order of the study
  std::vector<CutOff> cut_off;          ///< distributions that reach beyond what is admissible
  std::vector<Metric> metrics;          ///< in the order asked
  std::vector<Limit> limits;            ///< in the order of the study
  std::optional<Estimate> yield;  ///< fraction of motors that keep all limits; nothing: no limits
};

}  // namespace twum::studies
