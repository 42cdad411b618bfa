// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/studies/results/column.hpp>
#include <twum/studies/statistics/fit_tests.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace twum::studies {

/// Answer of `calibrate`: parameters of a motor from measured torque-speed points, by least squares of
/// the torques at the speeds measured. Torques and residuals in N m, speeds in rad/s.
struct CalibrateResult {
  enum class Bound : unsigned char { none, min, max };

  struct Estimate {
    NamedValue parameter;
    double deviation{0};  ///< standard deviation; NaN if the data do not determine it
    double low{0};        ///< confidence interval, Student's t with the scatter of the residuals
    double high{0};
    Bound bound{Bound::none};  ///< held there: it counts as known, and has no interval
    double min{0};             ///< range that was searched
    double max{0};
  };

  struct Point {
    double speed{0};
    double torque{0};    ///< measured
    double weight{1};    ///< of its squared residual; mean 1
    double fitted{0};    ///< torque of the motor with the estimates
    double residual{0};  ///< measured - fitted
  };

  /// Parameters that only count together.
  struct Undetermined {
    std::vector<std::string> names;
    /// Of two: by how many percent the second has to change to undo 1 % more of the first.
    double undone_by{std::numeric_limits<double>::quiet_NaN()};
  };

  /// A place where starts ended; the first is the answer.
  struct Optimum {
    std::vector<double> values;  ///< of the parameters, SI
    double residual_rms{0};
    std::size_t starts{0};
  };

  /// One local fit.
  struct Start {
    optim::Outcome outcome{optim::Outcome::failed};
    std::string word;  ///< how its search ended
    std::size_t evaluations{0};
    double residual_rms{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: none
    std::vector<double> values;  ///< of the parameters, SI; empty: none
  };

  double confidence{0.95};
  std::vector<Estimate> estimates;  ///< empty if no start could be evaluated
  std::vector<double> correlation;  ///< row after row; NaN where undetermined
  double residual_rms{
      std::numeric_limits<double>::quiet_NaN()};  ///< root of the weighted mean square
  double residual_deviation{std::numeric_limits<double>::quiet_NaN()};  ///< by degrees of freedom
  std::size_t degrees_of_freedom{0};
  bool exact{false};                 ///< residuals are no more than rounding: nothing to test
  std::optional<RunsTest> runs;      ///< of the residuals in order of speed
  std::optional<double> chi_square;  ///< where standard deviations were measured
  double chi_square_p{1};
  std::vector<Undetermined> undetermined;
  std::vector<Optimum> optima;
  std::vector<Start> starts;
  std::vector<Point> data;  ///< in the order of the file; fitted is NaN without estimates

  /// A misfit that chance gives less often than one time in a hundred.
  bool poor() const {
    constexpr double kRare = 0.01;
    return (runs && runs->p < kRare) || (chi_square && chi_square_p < kRare);
  }
};

}  // namespace twum::studies
