// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Result of a sweep: the distribution of each metric, and where it is smallest and largest.
struct SweepResult {
  /// One of the designs.
  struct Design {
    std::uint64_t index{0};         ///< its row
    std::vector<double> variables;  ///< in the order of SweepResult::variables, SI
    std::vector<double> metrics;    ///< in the order of SweepResult::metrics, SI; NaN: none
  };
  /// Distribution of one metric.
  struct Metric {
    StoredColumn column;     ///< its name and unit
    std::uint64_t count{0};  ///< designs that have a value
    double min{0};           ///< SI; NaN without a value, as the next two
    double median{0};        ///< exact; the lower of the two middle ones
    double max{0};           ///< SI
    Design lowest;           ///< where min is reached, the first of several; empty without a value
    Design highest;          ///< where max is reached, likewise
  };
  std::string sampling;                 ///< "grid", "list", "lhs" or "sobol"
  std::uint64_t designs{0};             ///< number of designs of the study
  std::uint64_t stored{0};              ///< evaluated so far
  std::uint64_t failed{0};              ///< of these, failed or incomplete
  std::vector<StoredColumn> variables;  ///< in the order of the study
  std::vector<Metric> metrics;          ///< in the order asked
  /// which of the metrics are derived parameters: with the variables they make up a design
  std::vector<std::size_t> derived;
};

}  // namespace twum::inline v0_1::studies
