// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/studies/estimate.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Answer of an uncertainty study: the distribution of metrics over random motors within tolerances.
struct UncertaintyResult {
  /// Value below which a given share of the motors lies.
  struct Quantile {
    double probability;  ///< in (0, 1)
    Estimate value;      ///< SI
  };
  /// Distribution of one metric.
  struct Metric {
    StoredColumn column;              ///< its name and unit
    std::uint64_t count{0};           ///< motors that have a value; the others do not count below
    Estimate mean;                    ///< SI
    Estimate sd;                      ///< standard deviation, SI
    std::vector<Quantile> quantiles;  ///< in the order asked
  };
  /// Share of motors that meet one limit.
  struct Limit {
    std::string text;    ///< as typed
    std::string metric;  ///< what is limited
    double lower;        ///< SI; -infinity: none
    double upper;        ///< SI; infinity: none
    Estimate kept{};     ///< fraction of motors
    Estimate broken{};   ///< the rest, exact where it is small
    /// share of each variable in the motors that break it, the sum is 1; empty: not known
    std::vector<Estimate> causes{};
    /// method `importance`: the distance of the most likely motor that breaks it, in standard deviations of normal numbers; NaN:
    /// none within 8.2
    double index{std::numeric_limits<double>::quiet_NaN()};
    std::vector<double> likeliest{};  ///< values of its variables, SI; empty: not known
  };
  /// A variable whose distribution reaches beyond its admissible range: such motors have no value and keep no limit.
  struct Inadmissible {
    std::string variable;  ///< its name
    double share;          ///< share of the distribution that lies beyond
  };

  double confidence{0.95};   ///< level of all intervals
  std::uint64_t samples{0};  ///< motors drawn
  std::uint64_t failed{0};   ///< of these, failed or incomplete
  /// of these, motors without a value that a limit needs; they count as violating it
  std::uint64_t no_value{0};
  std::string parts;  ///< name of the table of measured parts that were drawn; empty: none
  std::uint64_t part_count{0};  ///< how many there are
  std::string start;  ///< folder of the other study whose best design is the motor; empty: none
  /// the motor without its tolerances: the varied parameters, and those of the other study's design
  std::vector<NamedValue> nominal;
  std::vector<StoredColumn> variables;     ///< in the order of the study
  std::vector<Inadmissible> inadmissible;  ///< distributions that reach beyond the admissible range
  std::vector<Metric> metrics;             ///< in the order asked
  std::vector<Limit> limits;               ///< in the order of the study
  /// fraction of motors that meet all limits; nothing if there are no limits
  std::optional<Estimate> yield;
  Estimate broken{};  ///< the rest, exact where it is small
  std::vector<Estimate>
      causes{};  ///< share of each variable in the failures, the sum is 1; empty: not known
  /// of each variable, the change of the yield if its tolerance is 1 % tighter; NaN where it is not normal
  std::vector<Estimate> tighter{};
  /// motors were drawn about the ways to fail and weighted: method `importance`
  bool weighted{false};
  std::uint64_t ways{0};    ///< about how many points they were drawn
  std::uint64_t sought{0};  ///< motors, about, that were drawn before to find these
};

}  // namespace twum::inline v0_1::studies
