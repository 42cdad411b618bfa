// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/calibration.hpp"

#include "kinds/calibrate/answer_moves.hpp"
#include "kinds/calibrate/measurement_plan.hpp"
#include "kinds/calibrate/residual_tests.hpp"
#include "kinds/calibrate/unseen_changes.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/outliers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace twum::inline v0_1::studies {
namespace {

using optim::LeastSquaresResult;
using optim::Outcome;

// Root mean squares that agree as far as rounding and the search can tell.
bool as_good(double a, double b, const MeasuredFit& fit) {
  return std::fabs(a - b) <= 1e-6 * std::max(a, b) + MeasuredFit::kRounding * fit.size();
}

class Calibration {
 public:
  Calibration(const CalibrationAsked& asked, const std::vector<LeastSquaresResult>& fits)
      : fit_(asked.fit),
        fits_(fits),
        tables_(asked.tables),
        columns_(asked.columns),
        joined_(asked.joined),
        lost_(asked.undetermined),
        unsettled_(asked.unsettled) {
    result_.confidence = asked.confidence;
    for (const LeastSquaresResult& one : fits_) result_.starts.push_back(start_of(one));
    result_.unit = fit_.unit();
    result_.data = points_of(fit_, asked.tables);
    add_serial(asked.serial);
    if (!asked.columns.empty()) add_columns(asked);
  }

  KindAnswer answer(const std::vector<ProfiledInterval>& intervals) {
    const std::optional<std::size_t> number = best_fit(fit_, fits_);
    if (!number) return {"failed", std::move(result_)};
    const LeastSquaresResult& best = fits_[*number];
    add_optima(*number);
    add_estimates(best);
    for (std::size_t j = 0; j < intervals.size(); ++j)
      set_interval(intervals[j], best.estimates[j].high, result_.estimates[j]);
    const auto residuals = fit_.residuals(result_.optima.front().values);
    add_data(residuals);
    if (!columns_.empty()) tell_columns_without_scatter();
    name_outliers(best, residuals);
    test_residuals(result_, residuals, best, fit_.deviations_given(), known_deviation(best));
    compare_optima(best, residuals);
    result_.undetermined = unseen_sets(best, residuals, lost_ ? *lost_ : best.undetermined);
    result_.folded =
        result_.undetermined.size() < best.undetermined.size() || leave_out_far_correlations(best);
    if (!result_.determined())
      result_.combinations =
          hardly_seen(best, fit_.points().size(), result_.exact && !result_.stated);
    const bool ended = best.outcome == Outcome::optimal || best.outcome == Outcome::feasible;
    if (ended) result_.moves = moves_of(fit_, best);
    if (result_.folded) leave_out_moves();
    if (ended) result_.plan = measurement_plan(fit_, best, tables_);
    result_.unfinished = best.outcome == Outcome::optimal ? unsettled_ : best.word;
    const StudyOutcome outcome = outcome_after(best.outcome);
    return {outcome, std::move(result_)};
  }

 private:
  void add_serial(const optim::SerialErrors& serial) {
    if (serial.small_sample.empty()) return;
    CalibrateResult::Serial& told = result_.serial.emplace(CalibrateResult::Serial{});
    told.correlation = serial.correlation;
    for (const optim::SmallSample& sample : serial.small_sample)
      told.widening = std::max(told.widening, sample.widening * sample.quantile);
    told.widening /= optim::student_quantile(serial.small_sample.front().freedom,
                                             0.5 + 0.5 * result_.confidence);
  }

  void add_columns(const CalibrationAsked& asked) {
    for (std::size_t i = 0; i < asked.columns.size(); ++i) {
      const MeasuredPoint& point = fit_.points()[i];
      if (asked.columns[i] == result_.columns.size())
        result_.columns.push_back({std::string(name_of(point.reading)),
                                   std::string(unit_of(point.reading)), asked.tables[point.table],
                                   0, 0});
      CalibrateResult::ColumnScatter& column = result_.columns[asked.columns[i]];
      ++column.count;
      column.deviation = std::hypot(column.deviation, point.deviation);
    }
    for (auto& column : result_.columns)
      column.deviation /= std::sqrt(static_cast<double>(column.count));
  }

  // A column whose residuals are rounding has no deviation that a fit could find.
  void tell_columns_without_scatter() {
    std::vector<double> squares(result_.columns.size(), 0.0);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      squares[columns_[i]] += result_.data[i].residual * result_.data[i].residual;
    for (std::size_t k = 0; k < squares.size(); ++k) {
      CalibrateResult::ColumnScatter& column = result_.columns[k];
      const double rms = std::sqrt(squares[k] / static_cast<double>(column.count));
      if (rms <= MeasuredFit::kRounding * column.deviation) column.deviation = rms;
    }
  }

  // The least sum of squares is not yet a fit; and a search that stopped short of it says so only where it would be one.
  StudyOutcome outcome_after(Outcome search) const {
    const StudyOutcome verdict = result_.verdict();
    if (search == Outcome::optimal && result_.unfinished.empty()) return verdict;
    if (search == Outcome::optimal || search == Outcome::feasible)
      return verdict == StudyOutcome::fitted ? StudyOutcome::feasible : verdict;
    return outcome_of(search);
  }

  CalibrateResult::Start start_of(const LeastSquaresResult& one) const {
    CalibrateResult::Start start;
    start.outcome = one.outcome;
    start.word = one.word;
    start.evaluations = one.counters.evaluations;
    if (one.estimates.empty()) return start;
    start.residual_rms = root_mean(one, fit_);
    for (const optim::Estimate& e : one.estimates) start.values.push_back(e.value);
    return start;
  }

  // Whether two starts ended in one place. Parameters that the data do not determine say nothing.
  bool same_place(const CalibrateResult::Start& a, const CalibrateResult::Optimum& b,
                  const LeastSquaresResult& fit) const {
    constexpr double kNear = 1e-3;  // of the range
    if (!as_good(a.residual_rms, b.residual_rms, fit_)) return false;
    for (std::size_t j = 0; j < a.values.size(); ++j) {
      const double part = fit_.parameters()[j].part(b.values[j], a.values[j]);
      if (!(std::fabs(part) <= kNear) && !undetermined(fit, fit.estimates[j].name)) return false;
    }
    return true;
  }

  static bool undetermined(const LeastSquaresResult& fit, const std::string& name) {
    return std::any_of(fit.undetermined.begin(), fit.undetermined.end(), [&](const auto& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
  }

  void add_optima(std::size_t best) {
    std::vector<std::size_t> order(fits_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (a == best || b == best) return a == best && b != best;
      return result_.starts[a].residual_rms < result_.starts[b].residual_rms;
    });
    for (const std::size_t s : order) {
      const CalibrateResult::Start& start = result_.starts[s];
      if (start.values.empty() || (start.outcome != Outcome::optimal && s != best)) continue;
      const auto known = std::find_if(
          result_.optima.begin(), result_.optima.end(),
          [&](const CalibrateResult::Optimum& o) { return same_place(start, o, fits_[s]); });
      if (known != result_.optima.end())
        ++known->starts;
      else
        result_.optima.push_back(
            {start.values, start.residual_rms, 1, false, fit_.derived(start.values), false});
    }
  }

  // A linearised interval knows no range.
  static void cut_off(CalibrateResult::Estimate& e) {
    e.low_cut = e.low < e.min;
    e.high_cut = e.high > e.max;
    if (e.low_cut) e.low = e.min;
    if (e.high_cut) e.high = e.max;
  }

  // The slope of a profile at the estimate from its nearest points, where the linearised interval does not give it.
  static double slope_at(double b, const ProfiledInterval& found) {
    double sum = 0;
    int count = 0;
    const auto add = [&](const optim::ProfilePoint& point) {
      sum += point.z / (point.value - b);
      ++count;
    };
    if (!found.low->points.empty()) add(found.low->points.back());
    if (!found.high->points.empty()) add(found.high->points.front());
    return count > 0 ? sum / count : 0;
  }

  // `linear_high` is the upper end of the linearised interval.
  static void set_interval(const ProfiledInterval& found, double linear_high,
                           CalibrateResult::Estimate& e) {
    if (!found.low || !found.high) return;
    const double b = e.parameter.value;
    const double half_width =
        e.scale == optim::Scale::log ? b * std::log(linear_high / b) : linear_high - b;
    e.low = found.low->value;
    e.high = found.high->value;
    e.profiled = !found.low->linear || !found.high->linear;
    e.low_cut = found.low->cut_off;
    e.high_cut = found.high->cut_off;
    e.profile = found.low->points;
    e.profile.push_back({b, 0, std::isfinite(half_width) ? 1 / half_width : slope_at(b, found)});
    e.profile.insert(e.profile.end(), found.high->points.begin(), found.high->points.end());
  }

  // Another optimum fits as well if its sum of squares is in the joint confidence region (L2.2), though it is not there
  // itself: places that the linearised region of the best one holds, or that a path leads to, belong to the same valley.
  // Few points leave so large a region that a motor which misses them by far is in it; such a one does not fit.
  void compare_optima(const LeastSquaresResult& best, const optim::Residuals& residuals) {
    const double count = static_cast<double>(fit_.points().size());
    for (std::size_t k = 0; k < result_.optima.size(); ++k) {
      CalibrateResult::Optimum& other = result_.optima[k];
      const double sum = other.residual_rms * other.residual_rms * count;
      const bool equal = sum <= best.joint_limit ||
                         as_good(other.residual_rms, result_.optima.front().residual_rms, fit_);
      const bool near =
          linear_increase(residuals, other.values) <= best.joint_limit - best.sum_of_squares;
      const bool far =
          !fit_.deviations_given() && result_.misfit_of(other) > CalibrateResult::kLarge;
      const bool apart = k > 0 && equal && !near && !far;
      other.same_valley = apart && joined_ && joined_(best, other.values);
      other.fits_as_well = k == 0 || (apart && !other.same_valley);
      const double half_width = best.student_t * best.scatter;
      if (other.same_valley && sum <= best.sum_of_squares + half_width * half_width)
        widen_intervals(other.values);
    }
  }

  // To a place within the limit of (L3.1). Along a valley the sum of squares may rise above it and fall again, and a search from
  // the best place ends where it rises.
  void widen_intervals(const std::vector<double>& values) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      CalibrateResult::Estimate& e = result_.estimates[j];
      e.low = std::min(e.low, values[j]);
      e.high = std::max(e.high, values[j]);
    }
  }

  // What the sum of squares would rise by on the way from the best place, were the residuals linear.
  double linear_increase(const optim::Residuals& residuals,
                         const std::vector<double>& values) const {
    const std::vector<double>& from = result_.optima.front().values;
    double sum = 0;
    for (std::size_t i = 0; i < residuals.values.size(); ++i) {
      double change = 0;
      for (std::size_t j = 0; j < from.size(); ++j)
        change += residuals.jacobian[i * from.size() + j] * (values[j] - from[j]);
      sum += change * change;
    }
    return sum;
  }

  void add_estimates(const LeastSquaresResult& best) {
    for (std::size_t j = 0; j < best.estimates.size(); ++j) {
      const optim::Estimate& e = best.estimates[j];
      const FitParameter& range = fit_.parameters()[j];
      CalibrateResult::Estimate estimate;
      estimate.file = range.file;
      estimate.parameter = {e.name, std::string(info(range.parameter).unit), e.value};
      estimate.deviation = e.standard_deviation;
      estimate.low = e.low;
      estimate.high = e.high;
      estimate.min = range.min;
      estimate.max = range.max;
      estimate.scale = range.scale;
      cut_off(estimate);
      if (e.at_bound)
        estimate.bound = e.value - range.min < range.max - e.value ? CalibrateResult::Bound::min
                                                                   : CalibrateResult::Bound::max;
      if (e.at_bound) estimate.followers = followers(best, j);
      result_.estimates.push_back(std::move(estimate));
    }
    std::vector<double> values;
    for (const optim::Estimate& e : best.estimates) values.push_back(e.value);
    result_.derived = fit_.derived(values);
    result_.correlation = best.correlation;
    result_.residual_deviation = best.residual_deviation;
    result_.degrees_of_freedom = best.degrees_of_freedom;
    result_.student_t = best.student_t;
    result_.stated = best.scatter_known;
    result_.huber = std::isfinite(best.bend);
    result_.static_ratio = fit_.static_ratio();
  }

  // Only what moves by a thousandth of what it follows, or more.
  static std::vector<CalibrateResult::Follower> followers(const LeastSquaresResult& best,
                                                          std::size_t held) {
    constexpr double kNotable = 1e-3;
    std::vector<CalibrateResult::Follower> list;
    const std::size_t n = best.estimates.size();
    for (std::size_t i = 0; i < n && best.follows.size() == n * n; ++i) {
      const double percent =
          best.follows[i * n + held] * best.estimates[held].value / best.estimates[i].value;
      if (!best.estimates[i].at_bound && std::fabs(percent) >= kNotable)
        list.push_back({best.estimates[i].name, percent});
    }
    return list;
  }

  void add_data(const optim::Residuals& residuals) {
    for (std::size_t i = 0; i < result_.data.size(); ++i) {
      CalibrateResult::Point& point = result_.data[i];
      point.residual = -residuals.values[i] / std::sqrt(point.weight);
      point.fitted = point.value - point.residual;
    }
    result_.residual_rms = fit_.rms(residuals.values);
    result_.exact = fit_.exact(result_.residual_rms);
  }

  // From a fold, where the estimates are no smooth function of anything, first derivatives do not lead to the next answer.
  // Close to a fold the Jacobian has its rank, but its intervals end far outside of the range. Then it says no more than at the
  // fold. True if there are such intervals.
  bool leave_out_far_correlations(const LeastSquaresResult& best) {
    constexpr double kFar = 10;  // times the range
    const std::size_t n = result_.estimates.size();
    bool found = false;
    for (std::size_t j = 0; j < n; ++j) {
      const CalibrateResult::Estimate& e = result_.estimates[j];
      const double range = e.scale == optim::Scale::log
                               ? e.parameter.value * std::log(e.max / e.min)
                               : e.max - e.min;
      if (!(best.estimates[j].standard_deviation > kFar * range)) continue;
      found = true;
      for (std::size_t k = 0; k < n; ++k)
        if (k != j)
          result_.correlation[j * n + k] = result_.correlation[k * n + j] =
              std::numeric_limits<double>::quiet_NaN();
    }
    return found;
  }

  void leave_out_moves() {
    for (Move& move : result_.moves)
      std::fill(move.slopes.begin(), move.slopes.end(), std::numeric_limits<double>::quiet_NaN());
  }

  // Of a residual of weight 1; NaN if it is estimated.
  double known_deviation(const LeastSquaresResult& best) const {
    return best.scatter_known ? fit_.stated_deviation() : std::numeric_limits<double>::quiet_NaN();
  }

  // Under a loss that lets them count little the rest of the points says how good the fit is.
  void name_outliers(const LeastSquaresResult& best, const optim::Residuals& residuals) {
    if (result_.exact) return;
    for (const optim::Outlier& one : optim::find_outliers(residuals, best, known_deviation(best))) {
      CalibrateResult::Point& point = result_.data[one.residual];
      point.outlier = true;
      point.counts = !result_.huber;
      // A residual of the fit is fitted - measured, one of a result the other way round.
      result_.outliers.push_back({one.residual, -one.distance, one.p});
    }
    std::vector<double> counting;
    for (std::size_t i = 0; i < result_.data.size(); ++i)
      if (result_.data[i].counts) counting.push_back(residuals.values[i]);
    result_.residual_rms = fit_.rms(counting);
  }

  const MeasuredFit& fit_;
  const std::vector<LeastSquaresResult>& fits_;
  std::vector<std::string> tables_;
  const std::vector<std::size_t> columns_;  // as CalibrationAsked::columns
  decltype(CalibrationAsked::joined) joined_;
  decltype(CalibrationAsked::undetermined) lost_;
  std::string unsettled_;
  CalibrateResult result_;
};

}  // namespace

CalibrateResult::Point point_of(const MeasuredPoint& measured) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  CalibrateResult::Point point{0, measured.value, measured.weight, kNone, kNone};
  point.quantity = name_of(measured.reading);
  point.unit = unit_of(measured.reading);
  const auto* request = std::get_if<MetricRequest>(&measured.reading);
  point.argument = request != nullptr ? request->argument : Argument::none;
  if (request != nullptr) point.at = request->at, point.after = request->after;
  point.deviation = measured.deviation;
  for (const auto& [parameter, value] : measured.set)
    point.set.push_back(
        {std::string(info(parameter).name), std::string(info(parameter).unit), value});
  return point;
}

std::vector<CalibrateResult::Point> points_of(const MeasuredFit& fit,
                                              const std::vector<std::string>& tables) {
  std::vector<CalibrateResult::Point> list;
  for (const MeasuredPoint& measured : fit.points()) {
    list.push_back(point_of(measured));
    if (measured.table < tables.size())
      list.back().where = tables[measured.table] + ":" + std::to_string(measured.cell.line);
  }
  return list;
}

double root_mean(const LeastSquaresResult& one, const MeasuredFit& fit) {
  return std::sqrt(one.sum_of_squares / static_cast<double>(fit.points().size()));
}

std::optional<std::size_t> best_fit(const MeasuredFit& fit,
                                    const std::vector<LeastSquaresResult>& fits) {
  std::optional<std::size_t> best;
  for (std::size_t s = 0; s < fits.size(); ++s) {
    if (fits[s].estimates.empty()) continue;
    if (!best) {
      best = s;
      continue;
    }
    const LeastSquaresResult& one = fits[s];
    const LeastSquaresResult& other = fits[*best];
    const bool equal = as_good(root_mean(one, fit), root_mean(other, fit), fit);
    const bool finished = one.outcome == Outcome::optimal && other.outcome != Outcome::optimal;
    if (equal ? finished : one.sum_of_squares < other.sum_of_squares) best = s;
  }
  return best;
}

KindAnswer calibration(const CalibrationAsked& asked, const std::vector<LeastSquaresResult>& fits,
                       const std::vector<ProfiledInterval>& intervals) {
  return Calibration(asked, fits).answer(intervals);
}

}  // namespace twum::inline v0_1::studies
