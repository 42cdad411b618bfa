// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/column.hpp>
#include <twum/studies/statistics/estimate.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twum::studies {

/// Answer of an uncertainty study: how metrics spread over motors drawn by their tolerances.
struct UncertaintyResult {
  struct Quantile {
    double probability;
    Estimate value;  ///< SI
  };
  struct Metric {
    Column column;
    std::uint64_t count{0};  ///< motors that have a value; the rest enters nothing below
    Estimate mean;           ///< SI
    Estimate sd;
    std::vector<Quantile> quantiles;
  };
  struct Limit {
    std::string text;
    Estimate kept;  ///< fraction of motors
  };
  /// A variable whose distribution reaches beyond what is admissible.
  struct CutOff {
    std::string variable;
    double share;  ///< of the distribution, cut off
  };

  double confidence{0.95};    ///< level of all intervals
  std::uint64_t samples{0};   ///< motors drawn
  std::uint64_t failed{0};    ///< of these, without a full answer
  std::uint64_t no_value{0};  ///< of these, without a value that a limit needs: it is not kept
  std::string start;          ///< the other study whose best design is the motor; empty: none
  std::vector<Column> variables;
  std::vector<CutOff> cut_off;
  std::vector<Metric> metrics;
  std::vector<Limit> limits;
  std::optional<Estimate> yield;  ///< fraction of motors that keep all limits; nothing: no limits
};

}  // namespace twum::studies
