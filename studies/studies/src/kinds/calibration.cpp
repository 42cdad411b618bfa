// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibration.hpp"

#include "results/calibration_notes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace twum::studies {
namespace {

using optim::LeastSquaresResult;
using optim::Outcome;

// Residuals below this part of the torques are rounding.
constexpr double kExact = 1e-9;

class Calibration {
 public:
  Calibration(const TorqueFit& fit, const std::vector<LeastSquaresResult>& fits, double confidence)
      : fit_(fit), fits_(fits) {
    result_.confidence = confidence;
    for (const LeastSquaresResult& one : fits_) result_.starts.push_back(start_of(one));
    for (const MeasuredPoint& p : fit_.points()) {
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      result_.data.push_back({p.speed, p.torque, p.weight, kNone, kNone});
    }
  }

  KindAnswer answer() {
    const LeastSquaresResult* best = find_best();
    if (best == nullptr) return {"failed", std::move(result_)};
    add_estimates(*best);
    const auto residuals = fit_.residuals(result_.optima.front().values);
    add_data(residuals);
    test_fit();
    name_undetermined(*best, residuals);
    std::string outcome = verdict(*best);
    return {std::move(outcome), std::move(result_)};
  }

 private:
  // The least sum of squares is not yet a fit.
  std::string verdict(const LeastSquaresResult& best) const {
    if (best.outcome != Outcome::optimal) return optim::to_string(best.outcome);
    if (result_.at_bounds()) return "at-bounds";
    return result_.poor() ? "poor" : "fitted";
  }

  CalibrateResult::Start start_of(const LeastSquaresResult& one) const {
    CalibrateResult::Start start;
    start.outcome = one.outcome;
    start.word = one.word;
    start.evaluations = one.counters.evaluations;
    if (one.estimates.empty()) return start;
    start.residual_rms = std::sqrt(one.sum_of_squares / static_cast<double>(fit_.points().size()));
    for (const optim::Estimate& e : one.estimates) start.values.push_back(e.value);
    return start;
  }

  // Sums of squares that agree as far as rounding and the search can tell.
  bool as_good(double a, double b) const {
    return std::fabs(a - b) <= 1e-6 * std::max(a, b) + kExact * fit_.torque_size();
  }

  // The smallest residuals; of equals the first start's. An optimum goes before a fit that stopped
  // short, unless that one is better.
  const LeastSquaresResult* find_best() {
    std::size_t best = fits_.size();
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      const CalibrateResult::Start& start = result_.starts[s];
      if (start.values.empty()) continue;
      if (best == fits_.size()) {
        best = s;
        continue;
      }
      const CalibrateResult::Start& other = result_.starts[best];
      const bool equal = as_good(start.residual_rms, other.residual_rms);
      const bool finished = start.outcome == Outcome::optimal && other.outcome != Outcome::optimal;
      if (equal ? finished : start.residual_rms < other.residual_rms) best = s;
    }
    if (best == fits_.size()) return nullptr;
    add_optima(best);
    return &fits_[best];
  }

  // Whether two starts ended in one place. Parameters that the data do not determine say nothing.
  bool same_place(const CalibrateResult::Start& a, const CalibrateResult::Optimum& b,
                  const LeastSquaresResult& fit) const {
    constexpr double kNear = 1e-3;  // of the range
    if (!as_good(a.residual_rms, b.residual_rms)) return false;
    for (std::size_t j = 0; j < a.values.size(); ++j) {
      const DesignVariable& range = fit_.parameters()[j];
      const double part =
          range.log ? std::log(a.values[j] / b.values[j]) / std::log(range.max / range.min)
                    : (a.values[j] - b.values[j]) / (range.max - range.min);
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
        result_.optima.push_back({start.values, start.residual_rms, 1});
    }
  }

  void add_estimates(const LeastSquaresResult& best) {
    for (std::size_t j = 0; j < best.estimates.size(); ++j) {
      const optim::Estimate& e = best.estimates[j];
      const DesignVariable& range = fit_.parameters()[j];
      CalibrateResult::Estimate estimate;
      estimate.parameter = {e.name, std::string(info(range.parameter).unit), e.value};
      estimate.deviation = e.standard_deviation;
      estimate.low = e.low;
      estimate.high = e.high;
      estimate.min = range.min;
      estimate.max = range.max;
      estimate.log = range.log;
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
      point.fitted = point.torque - point.residual;
    }
    result_.residual_rms = fit_.rms(residuals.values);
    result_.exact = result_.residual_rms <= kExact * fit_.torque_size();
  }

  void test_fit() {
    if (result_.exact || result_.degrees_of_freedom == 0) return;
    std::vector<const CalibrateResult::Point*> ordered;
    for (const CalibrateResult::Point& point : result_.data) ordered.push_back(&point);
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto* a, const auto* b) { return a->speed < b->speed; });
    std::vector<double> residuals;
    for (const CalibrateResult::Point* point : ordered) residuals.push_back(point->residual);
    result_.runs = runs_test(residuals);
    if (!(fit_.points().front().deviation > 0)) return;
    double sum = 0;
    for (std::size_t i = 0; i < result_.data.size(); ++i) {
      const double part = result_.data[i].residual / fit_.points()[i].deviation;
      sum += part * part;
    }
    result_.chi_square = sum;
    result_.chi_square_p = chi_square_tail(sum, result_.degrees_of_freedom);
  }

  void name_undetermined(const LeastSquaresResult& best, const optim::Residuals& residuals) {
    for (const auto& names : best.undetermined) {
      CalibrateResult::Undetermined set;
      set.names = names;
      if (names.size() == 2) set.undone_by = undone_by(best, residuals, names);
      result_.undetermined.push_back(std::move(set));
    }
  }

  // The change of b, in percent, that undoes 1 % more of a: their columns are parallel.
  static double undone_by(const LeastSquaresResult& best, const optim::Residuals& residuals,
                          const std::vector<std::string>& names) {
    const std::size_t n = best.estimates.size();
    const auto place = [&](const std::string& name) {
      return static_cast<std::size_t>(
          std::find_if(best.estimates.begin(), best.estimates.end(),
                       [&](const optim::Estimate& e) { return e.name == name; }) -
          best.estimates.begin());
    };
    const std::size_t a = place(names[0]);
    const std::size_t b = place(names[1]);
    double both = 0;
    double second = 0;
    for (std::size_t i = 0; i < residuals.values.size(); ++i) {
      const double slope = residuals.jacobian[i * n + b];
      both += residuals.jacobian[i * n + a] * slope;
      second += slope * slope;
    }
    return -both / second * best.estimates[a].value / best.estimates[b].value;
  }

  const TorqueFit& fit_;
  const std::vector<LeastSquaresResult>& fits_;
  CalibrateResult result_;
};

}  // namespace

double CalibrateResult::misfit() const {
  double largest = 0;
  for (const Point& point : data) largest = std::max(largest, std::fabs(point.torque));
  return largest > 0 && residual_rms > 0 ? residual_rms / largest : 0;
}

bool CalibrateResult::at_bounds() const {
  return !estimates.empty() && std::all_of(estimates.begin(), estimates.end(),
                                           [](const auto& e) { return e.bound != Bound::none; });
}

bool CalibrateResult::poor() const {
  constexpr double kRare = 0.01;
  constexpr double kNoticeable = 0.02;
  constexpr double kLarge = 0.1;
  const double chance = std::min(runs ? runs->p : 1.0, chi_square ? chi_square_p : 1.0);
  return chance < kRare || (chance < kUnlikely && misfit() > kNoticeable) ||
         (!chi_square && misfit() > kLarge);
}

KindAnswer calibration(const TorqueFit& fit, const std::vector<LeastSquaresResult>& fits,
                       double confidence) {
  return Calibration(fit, fits, confidence).answer();
}

}  // namespace twum::studies
