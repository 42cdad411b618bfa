// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/drawn_motors.hpp"

#include <twum/base/no_value.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/estimate.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

// Motors drawn by their tolerances, one row each.
//
// The draws are independent random numbers, not a Latin hypercube or a Sobol sequence. Those would reduce the scatter
// of means, but the intervals of yield and quantiles are valid for independent draws only. Draw k of row i depends on
// the seed, i and k alone.
class UncertaintyRun : public DrawnMotors {
 public:
  UncertaintyRun(const UncertaintyStudy& asked, const StudyFile& file)
      : DrawnMotors(asked, file),
        probabilities_(sorted(asked.quantiles)),
        samples_(asked.samples) {}

  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return varied_.varied().size(); }

  KindAnswer run(RunContext& context) override {
    const bool complete = store_rows(context, 0, samples_);
    UncertaintyResult result = answer(context.store);
    const bool any = std::any_of(result.metrics.begin(), result.metrics.end(),
                                 [](const auto& metric) { return metric.count > 0; });
    return {!complete ? "interrupted" : any ? "done" : "failed", std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index >= samples_) return {};
    StoredRow row;
    row.index = asked.index;
    fill(asked.index, row);
    return row;
  }

 private:
  void fill(std::uint64_t index, StoredRow& row) const {
    std::vector<double> design = drawn_probabilities(index);
    for (std::size_t k = 0; k < design.size(); ++k) design[k] = variables_[k].draw(design[k]);
    if (!table_.parts.rows.empty()) {
      const auto part = table_.parts.rows.draw(optim::Random(seed_, 1, index).uniform());
      design.insert(design.end(), part.begin(), part.end());
    }
    if (variables_.empty())
      fill_once(design, row);
    else
      evaluator_.evaluate(design, row);
  }

  // Measured parts alone make as many motors as there are parts: each is computed once, however often it is drawn.
  void fill_once(const std::vector<double>& design, StoredRow& row) const {
    {
      const std::lock_guard guard(mutex_);
      if (const auto known = known_.find(design); known != known_.end()) {
        row.values = known->second.values, row.status = known->second.status;
        return;
      }
    }
    evaluator_.evaluate(design, row);
    const std::lock_guard guard(mutex_);
    known_.emplace(design, row);
  }

  // Of each variable, independent ones.
  std::vector<double> independent_probabilities(std::uint64_t index) const {
    optim::Random random(seed_, 0, index);
    std::vector<double> list;
    // Half a step of the random number keeps it away from 0.
    for (std::size_t k = 0; k < variables_.size(); ++k)
      list.push_back(random.uniform() + 0x1.0p-54);
    return list;
  }

  std::vector<double> normals(std::uint64_t index) const {
    std::vector<double> list = independent_probabilities(index);
    for (double& u : list) u = optim::normal_quantile(u);
    return list;
  }

  // Of each variable, correlated as their normal numbers are.
  std::vector<double> drawn_probabilities(std::uint64_t index) const {
    if (correlation_.independent()) return independent_probabilities(index);
    std::vector<double> list = correlation_.correlated(normals(index));
    for (double& y : list) y = std::clamp(optim::normal_cdf(y), 0x1.0p-54, 1 - 0x1.0p-53);
    return list;
  }

  // Quantiles need the values at hand: 8 bytes for each metric and row.
  UncertaintyResult answer(const ResultStore& store) const {
    UncertaintyResult result = frame();
    Broken broken = nothing_broken();
    std::vector<std::vector<double>> values(metrics_.size());
    store.read(0, [&](const StoredRow& row) {
      ++result.samples;
      if (row.status != "ok") ++result.failed;
      const double* metrics = row.values.data() + variables();
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        if (!std::isnan(metrics[i])) values[i].push_back(metrics[i]);
      }
      result.no_value += std::ranges::any_of(
          limits_, [&](const LimitPlace& one) { return std::isnan(metrics[one.metric]); });
      count(broken, row.index, 1, metrics, [&] { return normals(row.index); });
    });
    for (std::size_t i = 0; i < metrics_.size(); ++i) describe(values[i], result.metrics[i]);
    if (!limits_.empty()) tell_yield(broken, result);
    return result;
  }

  void tell_yield(const Broken& broken, UncertaintyResult& result) const {
    const auto share = [&](std::uint64_t motors) {
      return proportion_estimate(motors, result.samples, kConfidence);
    };
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const std::uint64_t failing = broken.of_limit[i].failing();
      result.limits[i].broken = share(failing);
      result.limits[i].kept = share(result.samples - failing);
    }
    result.broken = share(broken.any.failing());
    result.yield = share(result.samples - broken.any.failing());
    tell_causes(broken, result);
  }

  void describe(std::vector<double>& values, UncertaintyResult::Metric& metric) const {
    // Of times of which some have no end there is no mean; their quantiles are times.
    const bool endless =
        std::ranges::any_of(values, [](double value) { return std::isinf(value); });
    Moments moments;
    for (const double value : values) moments.add(endless ? kNoValue : value);
    metric.count = moments.count();
    metric.mean = moments.mean_estimate(kConfidence);
    metric.sd = moments.sd_estimate(kConfidence);
    std::sort(values.begin(), values.end());
    for (const double p : probabilities_)
      metric.quantiles.push_back({p, quantile_estimate(values, p, kConfidence)});
  }

  std::vector<double> probabilities_;
  std::uint64_t samples_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::map<std::vector<double>, StoredRow> known_;
};

}  // namespace

std::unique_ptr<StudyKindRun> make_plain_uncertainty(const UncertaintyStudy& asked,
                                                     const StudyFile& file) {
  return std::make_unique<UncertaintyRun>(asked, file);
}

}  // namespace twum::inline v0_1::studies
