// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/calibrate/measured_fit.hpp"
#include "kinds/rows/study_kind.hpp"

#include <twum/optim/fit_profile.hpp>
#include <twum/optim/serial_errors.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// What the answer of a calibration is made from, besides the fits.
struct CalibrationAsked {
  const MeasuredFit& fit;
  std::vector<std::string> tables{};  ///< of the measurements, without folders
  double confidence{0.95};            ///< level of the intervals
  std::vector<std::size_t>
      columns{};  ///< as AskedFit::columns; the fit is in parts of their deviations
  /// errors in series, by which the intervals are widened
  optim::SerialErrors serial{};
  std::string unsettled{};  ///< why these deviations are not settled; empty: they are
  /// Whether a path joins another optimum to the best fit inside the joint confidence region; none: never.
  std::function<bool(const optim::LeastSquaresResult& best, std::span<const double> other)>
      joined{};
  /// The sets of parameters that the data determine only together, at the best fit and beside it; none: those of the fit.
  std::optional<std::vector<std::vector<std::string>>> undetermined{};
};

/// A measured point as a result shows it; fitted and residual are NaN.
CalibrateResult::Point point_of(const MeasuredPoint& measured);
/// The measured points as a result shows them; fitted and residual are NaN.
/// @param tables  names of the tables
std::vector<CalibrateResult::Point> points_of(const MeasuredFit& fit,
                                              const std::vector<std::string>& tables);

/// Root of the weighted mean square of the residuals of a fit [N m].
double root_mean(const optim::LeastSquaresResult& one, const MeasuredFit& fit);

/// The least sum of squares; of equals the first start's. An optimum goes before a fit that stopped short, unless
/// that one is better. Nothing if no start could be evaluated.
std::optional<std::size_t> best_fit(const MeasuredFit& fit,
                                    const std::vector<optim::LeastSquaresResult>& fits);

/// Ends of a confidence interval, where they were looked for.
struct ProfiledInterval {
  std::optional<optim::ProfileEnd> low;
  std::optional<optim::ProfileEnd> high;
};

/// What local fits from several starts say together: best_fit() with its statistics, the other places where starts
/// ended, and whether the best one fits and is determined.
/// @param intervals  one for each parameter, of the best fit; none: the linearised ones stand
KindAnswer calibration(const CalibrationAsked& asked,
                       const std::vector<optim::LeastSquaresResult>& fits,
                       const std::vector<ProfiledInterval>& intervals = {});

}  // namespace twum::inline v0_1::studies
