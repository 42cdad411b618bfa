// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/io/column.hpp>
#include <twum/studies/elementary_effects.hpp>
#include <twum/studies/estimate.hpp>
#include <twum/studies/sobol_indices.hpp>
#include <twum/studies/study.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace twum::inline v0_1::studies {

/// Effect of a variable on a metric at one motor.
struct LocalEffect {
  double gradient;    ///< SI; NaN: none
  double elasticity;  ///< per cent of the metric for a per cent of the variable; NaN: none
  /// standard deviation of the metric by the tolerance of the variable alone, to first order, SI; NaN: none
  double spread{std::numeric_limits<double>::quiet_NaN()};
};

/// Which variables matter for one metric.
struct MetricSensitivity {
  /// Effects of the three methods, one for each variable.
  /// @{
  using Local = std::vector<LocalEffect>;
  using Morris = std::vector<ElementaryEffect>;
  using Sobol = std::vector<SobolShares>;
  /// @}

  StoredColumn metric;       ///< whose effects these are
  std::string note;          ///< why there are no effects, or a remark on them; may be empty
  std::uint64_t samples{0};  ///< blocks or trajectories that were used
  std::uint64_t dropped{0};  ///< those in which an evaluation failed
  double value{0};           ///< mean over the box; local: at the motor; SI, NaN: none
  double sd{0};              ///< over the box; local: by the tolerances, to first order; NaN: none
  Smoothness smoothness{Smoothness::smooth};   ///< local: what the gradient can be used for
  std::variant<Local, Morris, Sobol> effects;  ///< one for each variable; empty: none
};

/// Answer of a sensitivity study.
struct SensitivityResult {
  SensitivityMethod method{};  ///< that was asked for
  double confidence{0.95};     ///< level of all intervals
  bool tolerances{false};      ///< over the laws of tolerances in place of ranges
  std::uint64_t samples{0};    ///< blocks (sobol) or trajectories (morris) evaluated in full
  double width{0};             ///< sobol: intervals should be narrower than this; 0: not asked
  bool narrow{true};           ///< all intervals are narrower than `width`
  std::vector<StoredColumn> variables;     ///< in the order of the study
  std::vector<double> motor;               ///< local: values of the variables at the motor, SI
  std::vector<MetricSensitivity> metrics;  ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
