// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/io/column.hpp>
#include <twum/optim/fit_profile.hpp>
#include <twum/optim/neighbour_test.hpp>
#include <twum/optim/result.hpp>
#include <twum/studies/move.hpp>
#include <twum/studies/study_outcome.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Answer of `calibrate`: parameters of a motor from measurements, by least squares. SI; residuals in the unit of what was
/// measured, their root mean square in standard deviations where that is of several kinds.
struct CalibrateResult {
  /// End of its range that holds a parameter.
  enum class Bound : unsigned char { none, min, max };
  /// "none", "min" or "max"; static lifetime.
  friend const char* to_string(Bound value) noexcept;

  /// What a free parameter does when the end of a range that holds another one moves.
  struct Follower {
    std::string name;   ///< of the free parameter
    double percent{0};  ///< its change for 1 % more of the held one, to first order
  };

  /// What the fit says of one parameter, SI.
  struct Estimate {
    NamedValue
        parameter;        ///< name and value; a parameter of one table is named "amplitude (b.csv)"
    double deviation{0};  ///< standard deviation; NaN if the data do not determine it
    double low{0};  ///< confidence interval, Student's t with the scatter of the residuals; in the
        ///< logarithm where the variable has a log scale; from the profile of the sum of
        ///< squares where that differs, so that it holds admissible values only; extended to
        ///< other optima of the same valley that fit as well (L3.1)
    double high{0};            ///< its upper end
    bool profiled{false};      ///< one of the ends comes from the profile
    bool low_cut{false};       ///< the range cuts the interval off: the data allow smaller values
    bool high_cut{false};      ///< likewise for larger ones
    Bound bound{Bound::none};  ///< end of the range where the estimate lies: it has no interval
    double min{0};             ///< range that was searched
    double max{0};             ///< its upper end
    optim::Scale scale{optim::Scale::linear};  ///< in whose logarithm it was searched
    std::vector<Follower> followers;           ///< if at a bound: changes of the free parameters
    std::string file{};  ///< table of measurements that it belongs to; empty: all tables
    /// of the sum of squares (L3.1), the estimate among them; empty: not made
    std::vector<optim::ProfilePoint> profile{};
  };

  /// One measured number, and the fitted value of it.
  struct Point {
    double at{0};        ///< speed of the rotor [rad/s] or torque [N m] of the measurement
    double value{0};     ///< measured
    double weight{1};    ///< factor of the squared residual; mean 1 if all numbers are of one kind
    double fitted{0};    ///< value of the motor with the estimates
    double residual{0};  ///< measured - fitted
    std::string quantity{"torque_at"};   ///< metric or circuit quantity
    std::string unit{"N.m"};             ///< its SI unit
    Argument argument{Argument::speed};  ///< what `at` is
    /// of a temperature that was not steady: time since the motor took up the load [s]
    std::optional<double> after{};
    double deviation{0};            ///< standard deviation; 0: not given
    std::vector<NamedValue> set{};  ///< settings of the bench
    std::string where{};  ///< table and line, such as "points.csv:12"; empty: not from a table
    bool outlier{false};  ///< one of CalibrateResult::outliers
    bool counts{true};    ///< included in residual_rms and in the tests of the fit

    /// A torque at a speed.
    bool torque() const { return quantity == "torque_at"; }
  };

  /// A point that chance does not explain (L7.1, L7.2).
  struct Outlier {
    std::size_t point{0};  ///< its number in the data
    double distance{0};  ///< from the fit of the others, in standard deviations; > 0: measured more
    double p{1};         ///< probability that chance puts one of the points so far away
  };

  /// The scatter of one column of a table, estimated from its residuals.
  struct ColumnScatter {
    std::string quantity;  ///< what it is
    std::string unit;      ///< its SI unit
    std::string table;     ///< as typed
    std::size_t count{0};  ///< numbers in it
    double deviation{0};   ///< their standard deviation, SI
  };

  /// Chi-square of the numbers of one kind.
  struct KindScatter {
    std::string quantity;  ///< which kind
    double chi_square{0};  ///< of its residuals
    std::size_t count{0};  ///< of its numbers
    double p{1};           ///< how often chance gives one of the kinds as much or more
  };

  /// Readings of one kind in one table that seem to share an offset (L4.2).
  struct ColumnOffset {
    std::string quantity;  ///< what was read
    std::string unit;      ///< its SI unit
    std::string table;     ///< as typed; empty: not from a table
    std::size_t count{0};  ///< readings in it
    double offset{0};      ///< measured - motor, SI
    double p{1};           ///< how often chance gives one of the columns as much or more
  };

  /// Parameters that the data determine only in combination.
  struct Undetermined {
    std::vector<std::string> names;  ///< of the parameters
    /// Of two: by how many percent the second has to change to undo 1 % more of the first.
    double undone_by{std::numeric_limits<double>::quiet_NaN()};
  };

  /// A change of several parameters together that hardly changes the measured numbers, or does not change them at all (L2.3).
  struct Combination {
    /// One parameter's share.
    struct Part {
      std::string name;   ///< of the parameter
      double percent{0};  ///< relative change; if the value is 0, relative to the range
    };
    std::vector<Part> parts;  ///< the largest is 10 %
    /// Change of the measured numbers, root mean square in standard deviations; NaN if these are
    /// not known.
    double effect{0};
    bool unseen{false};  ///< to first order nothing changes
  };

  /// A place where starts ended; the first is the answer.
  struct Optimum {
    std::vector<double> values;       ///< of the parameters, SI
    double residual_rms{0};           ///< of the fit there
    std::size_t starts{0};            ///< how many ended there
    bool fits_as_well{false};         ///< the data cannot tell this motor from the first
    std::vector<NamedValue> derived;  ///< derived parameters
    bool same_valley{false};          ///< motors between the two fit as well, so that they are one
  };

  /// A measurement worth making next, and what the estimates would be like after it and those before it in the plan.
  struct Planned {
    Point point;  ///< what to read, and where; without values
    std::string
        file{};  ///< table on whose motor, where tables have values of their own; else empty
    std::vector<double>
        widths;        ///< of the intervals relative to the present ones, for each parameter
    double volume{1};  ///< of the joint region of the estimates, likewise
    double mean{1};    ///< root of the mean square of the widths in parts of the ranges, likewise
  };

  /// One local fit.
  struct Start {
    optim::Outcome outcome{optim::Outcome::failed};                 ///< what its search came to
    std::string word;                                               ///< how its search ended
    std::size_t evaluations{0};                                     ///< calls of the motor
    double residual_rms{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: none
    std::vector<double> values;  ///< of the parameters, SI; empty: none
  };

  double confidence{0.95};  ///< level of all intervals
  std::string unit{
      "N.m"};  ///< of residual_rms: that of the points, or "1" where they are of several kinds
  bool huber{false};       ///< large residuals count by their size, not by their square (L8.1)
  bool unmeasured{false};  ///< there are no data, and the plan is of first measurements
  std::vector<ColumnScatter> columns;  ///< where each column has a scatter of its own
  bool stated{
      false};  ///< the width of the intervals follows from the standard deviations of the data
  std::vector<Estimate> estimates;  ///< empty if no start could be evaluated
  std::vector<NamedValue> derived;  ///< derived parameters at the estimates
  std::vector<double> correlation;  ///< row after row; NaN where undetermined
  double residual_rms{std::numeric_limits<
      double>::quiet_NaN()};  ///< root of the weighted mean square, of points that count
  double residual_deviation{std::numeric_limits<double>::quiet_NaN()};  ///< by degrees of freedom
  std::size_t degrees_of_freedom{0};  ///< points less free parameters
  double student_t{0};  ///< half width of an interval in standard deviations of the estimate
  bool exact{false};    ///< residuals are no more than rounding: nothing to test
  /// Of the residuals of the kind that stands out most, in their order.
  std::optional<optim::NeighbourTest> neighbours;
  /// The kind of data of `neighbours`, and what it is in order of, such as "torque_at" and "speed".
  struct NeighboursOf {
    std::string quantity{"torque_at"};  ///< the kind
    std::string over{"speed"};          ///< what its numbers are in order of
  } neighbours_of;                      ///< of `neighbours`
  /// Errors that follow each other in series.
  struct Serial {
    double correlation{0};  ///< the likeliest one of neighbours
    double widening{0};  ///< of the interval that is widened most, compared with independent errors
  };
  std::optional<Serial> serial;           ///< where the intervals are widened by it
  std::optional<double> chi_square;       ///< where standard deviations were measured
  double chi_square_p{1};                 ///< how often chance gives as much or more
  std::optional<KindScatter> worst_kind;  ///< where it is as rare as one time in twenty
  std::optional<ColumnOffset> offset;     ///< the rarest, where it is as rare as one time in twenty
  std::vector<Outlier> outliers;          ///< the farthest first
  std::vector<Undetermined> undetermined;  ///< none if the data determine all
  /// The Jacobian lacks more rank at the estimates, or close to them, than elsewhere: there only the profiles give intervals,
  /// and `moves` and the correlations of what the lost direction holds are NaN.
  bool folded{false};
  std::vector<Combination> combinations;  ///< least visible first; none if the intervals are of use
  std::vector<Optimum> optima;            ///< local optima where starts ended, best first
  std::vector<Start> starts;              ///< every local fit
  std::vector<Move> moves;                ///< of the estimates, by each held parameter that counts
  std::vector<Planned>
      plan;  ///< the next measurements in their order; empty where the scatter is unknown
  std::vector<Point> data;  ///< in the order of the file; fitted is NaN without estimates

  /// Why the search stopped short of the least residuals, or the scatter of the columns is not settled; empty: neither.
  std::string unfinished{};

  double static_ratio{1};  ///< static to kinetic friction, kept where only the latter is estimated

  /// A larger misfit() is poor if no standard deviations are given.
  static constexpr double kLarge = 0.05;
  /// Degrees of freedom from which on the residuals show by themselves what the scatter is: a standard deviation of ten lies
  /// within 0.70 and 1.75 of the true one (95 %).
  static constexpr std::size_t kKnownScatter = 10;
  /// Whether the residuals that `neighbours` tests are nearly equal: of one sign, and within a quarter of the smallest.
  bool alike() const;
  /// How often chance gives such residuals: the rarest of `neighbours`, `chi_square` and `worst_kind`.
  double chance() const;
  /// Chance gives `offset` less often than one time in a hundred.
  bool shifted() const;

  /// Root mean square of the residuals relative to the largest measured torque; 0 without estimates.
  double misfit() const;
  /// Likewise of one of the optima.
  double misfit_of(const Optimum& optimum) const;
  /// Tables with values of their own, in their order; one without a name if none has.
  std::vector<std::string> files() const;
  /// What the motor of such a table has at these values of the estimates, by the names of its parameters.
  std::vector<NamedValue> motor_values(const std::vector<double>& values,
                                       const std::string& file) const;
  /// Likewise at the estimates.
  std::vector<NamedValue> motor_values(const std::string& file) const;
  /// Every parameter is held by an end of its range: nothing was fitted.
  bool at_bounds() const;
  /// The residuals do not agree with the scatter. Chance gives them less often than one time in a hundred, or one time in
  /// twenty if misfit() exceeds 2 %; or a column is shifted(); or, without a chi-square, misfit() exceeds 5 %, or one number is
  /// missed().
  bool poor() const;
  /// Without standard deviations and with fewer than ten degrees of freedom: the worst of the points that the fit misses
  /// by more than 5 % of their value and 2 % of the largest value (by 1 / sqrt(weight) as much); else null.
  const Point* missed() const;
  /// Degrees of freedom of the points that count.
  std::size_t counting_freedom() const;
  /// How many of the optima the data cannot tell from the best, that one included.
  std::size_t equals() const;
  /// An interval is narrow enough: its ends differ by a factor of 3 at most, or by a tenth of the range that was
  /// searched; and the range does not cut off both ends. A parameter at a bound has none.
  static bool of_use(const Estimate& estimate);
  /// Every parameter has an interval of use.
  bool determined() const;
  /// Outcome of a finished search: at_bounds, poor, several, undetermined or fitted.
  OutcomeWord verdict() const;
};

}  // namespace twum::inline v0_1::studies
