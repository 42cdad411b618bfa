// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/group_deviations.hpp>

#include <twum/base/error.hpp>

#include "fit/fit_rounds.hpp"
#include "fit/fitted_space.hpp"
#include "fit/kenward_roger.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

class GroupedFit {
 public:
  GroupedFit(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
             const std::vector<std::size_t>& groups, const LeastSquaresOptions& options)
      : parameters_(parameters), residuals_(residuals), groups_(groups), options_(options) {
    result_.deviations.assign(1 + *std::max_element(groups_.begin(), groups_.end()), 1.0);
  }

  GroupDeviations run() {
    bool done = false;
    for (int round = 0; round < kMostRounds && !done; ++round) {
      step();
      if (result_.fit.estimates.empty() || cut_short(options_, counters_)) break;
      done = settled();
    }
    if (!done) leave_unsettled(options_, counters_, result_.fit);
    result_.fit.counters = counters_;
    return result_;
  }

 private:
  void step() {
    std::vector<Variable> from = parameters_;
    const auto& before = result_.fit.estimates;
    for (std::size_t j = 0; j < before.size(); ++j) from[j].start = before[j].value;
    LeastSquaresOptions rest = options_;
    rest.max_evaluations -= std::min(rest.max_evaluations, counters_.evaluations);
    result_.fit = least_squares(
        from, [&](auto b) { return in_deviations(residuals_(b), groups_, result_.deviations); },
        rest);
    counters_.add(result_.fit.counters);
  }

  // Sum of squares and degrees of freedom of each group, as the fit counts them.
  struct Shares {
    std::vector<double> squares;
    std::vector<double> freedom;
  };

  Shares shares() {
    std::vector<double> b;
    std::vector<std::size_t> free;
    for (const Estimate& e : result_.fit.estimates) {
      if (!e.at_bound) free.push_back(b.size());
      b.push_back(e.value);
    }
    const Residuals here = in_deviations(residuals_(b), groups_, result_.deviations);
    ++counters_.evaluations;
    ++counters_.gradients;
    const Eigen::MatrixXd columns = free_jacobian(here, result_.fit);
    const Eigen::MatrixXd q = fitted_space(columns);
    const std::size_t count = result_.deviations.size();
    Shares found{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0)};
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      found.squares[groups_[i]] += here.values[i] * here.values[i];
      found.freedom[groups_[i]] += 1.0 - q.row(static_cast<Index>(i)).squaredNorm();
    }
    result_.small_sample.assign(b.size(), {static_cast<double>(columns.rows() - columns.cols())});
    find_small_sample(columns, q, free);
    return found;
  }

  // Kenward and Roger (L9.2, L9.3).
  void find_small_sample(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& q,
                         const std::vector<std::size_t>& free) {
    const GroupShares groups(q, groups_, result_.deviations.size());
    const KenwardRoger known(groups.shares, groups.counts);
    const Eigen::MatrixXd rows = parameter_rows(columns, q);
    for (std::size_t j = 0; j < free.size(); ++j)
      result_.small_sample[free[j]] =
          known.of(rows.row(static_cast<Index>(j)).transpose().normalized());
  }

  // True if the residuals have the deviations that the fit was made with (L9.1); else these change.
  bool settled() {
    constexpr double kSettled = 1e-9;
    const Shares found = shares();
    std::vector<double> next = result_.deviations;
    bool same = true;
    double weight = 0.0;
    result_.level = 0.0;
    for (std::size_t k = 0; k < next.size(); ++k) {
      weight += found.freedom[k];
      result_.level += found.freedom[k] * std::log(next[k]);
      if (!(found.squares[k] > 0.0) || !(found.freedom[k] > 0.0)) continue;
      const double factor = std::sqrt(found.squares[k] / found.freedom[k]);
      next[k] *= factor;
      same = same && std::abs(factor - 1.0) <= kSettled;
    }
    result_.level /= weight;
    if (!same) result_.deviations = next;
    return same;
  }

  const std::vector<Variable>& parameters_;
  const ResidualFunction& residuals_;
  const std::vector<std::size_t>& groups_;
  const LeastSquaresOptions& options_;
  GroupDeviations result_;
  Counters counters_;
};

}  // namespace

Residuals in_deviations(Residuals raw, std::span<const std::size_t> groups,
                        std::span<const double> deviations) {
  if (!raw.failure.empty()) return raw;
  if (raw.values.size() != groups.size())
    throw InputError("least squares: not every residual has a group");
  const std::size_t n = raw.jacobian.size() / raw.values.size();
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    const double unit = 1.0 / deviations[groups[i]];
    raw.values[i] *= unit;
    for (std::size_t j = 0; j < n; ++j) raw.jacobian[i * n + j] *= unit;
  }
  return raw;
}

GroupDeviations group_deviations(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const std::vector<std::size_t>& groups,
                                 const LeastSquaresOptions& options) {
  if (options.loss != Loss::squares || std::isfinite(options.deviation) || groups.empty())
    throw InputError("least squares: groups need the loss of squares and a scatter to estimate");
  return GroupedFit(parameters, residuals, groups, options).run();
}

}  // namespace twum::inline v0_1::optim
