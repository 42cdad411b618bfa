// SPDX-License-Identifier: Apache-2.0
#include "entries/tolerance_shape.hpp"
#include "kinds/rows/earlier_result.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/found_motors.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/moments.hpp>
#include <twum/studies/quantiles.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace twum::studies {
namespace {

constexpr double kConfidence = 0.95;

// A parameter with its distribution.
struct DrawnVariable {
  Parameter parameter;
  Distribution distribution;

  double draw(double u) const {
    const double value = distribution.quantile(u);
    return info(parameter).integer ? std::round(value) : value;
  }
};

std::vector<DrawnVariable> drawn_variables(const std::vector<Tolerance>& asked,
                                           const MotorDesign& design) {
  std::vector<DrawnVariable> variables;
  for (const Tolerance& one : asked) {
    const double value = get(design, one.parameter);
    if (const auto wrong = complaint(one, value))
      throw InputError("study.variables." + std::string(info(one.parameter).name) + ": " +
                       wrong->what());
    variables.push_back({one.parameter, one.distribution(value)});
  }
  return variables;
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

// A limit and the position of its metric.
struct LimitPlace {
  MotorLimit limit;
  std::size_t metric;
};

// Adds the metrics of limits that are not yet in the list.
std::vector<LimitPlace> place_limits(const std::vector<MotorLimit>& limits,
                                     std::vector<MetricExpression>& metrics) {
  std::vector<LimitPlace> places;
  for (const MotorLimit& limit : limits) {
    const auto found = std::find_if(
        metrics.begin(), metrics.end(),
        [&](const MetricExpression& metric) { return metric.text == limit.metric.text; });
    places.push_back({limit, static_cast<std::size_t>(found - metrics.begin())});
    if (found == metrics.end()) metrics.push_back(limit.metric);
  }
  return places;
}

// The values of an earlier study's best design; none if the motor of the file is varied.
EarlierDesign start_design(const StudyFile& file, const std::string& start) {
  if (start.empty()) return {};
  const auto designs = earlier_designs((std::filesystem::path(file.folder) / start).string());
  if (designs.size() != 1) {
    throw InputError("study.start: '" + start + "' holds a front of " +
                     std::to_string(designs.size()) +
                     " designs; tolerances are those of one motor: name one of its motor files "
                     "instead, such as 'motor: " +
                     start + "/" + front_file(1, designs.size()) + "'");
  }
  return designs.front();
}

// What tells the varied motor from others: the varied parameters and those of the earlier design.
std::vector<Parameter> nominal_parameters(const UncertaintyStudy& asked,
                                          const EarlierDesign& start) {
  std::vector<Parameter> list = parameters_of(asked.variables);
  for (const auto& [parameter, value] : start)
    if (std::find(list.begin(), list.end(), parameter) == list.end()) list.push_back(parameter);
  return list;
}

// Motors drawn by their tolerances, one row each.
//
// The draws are independent random numbers, not a Latin hypercube or a Sobol sequence. Those would reduce the scatter
// of means, but the intervals of yield and quantiles are valid for independent draws only. Draw k of row i depends on
// the seed, i and k alone.
class UncertaintyRun : public StudyKindRun {
 public:
  UncertaintyRun(const UncertaintyStudy& asked, const StudyFile& file)
      : start_(start_design(file, asked.start)),
        design_(with(file.motor.design, start_)),
        tolerances_(asked.variables),
        variables_(drawn_variables(asked.variables, design_)),
        probabilities_(sorted(asked.quantiles)),
        metrics_(with_derived(asked.metrics, asked.derived)),
        limits_(place_limits(asked.limits, metrics_)),
        evaluator_({design_, parameters_of(variables_), asked.derived}, metrics_),
        seed_(asked.seed),
        samples_(asked.samples),
        start_folder_(asked.start),
        nominal_(nominal_parameters(asked, start_)) {}

  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return variables_.size(); }
  std::uint64_t seed() const override { return seed_; }
  std::optional<MotorDesign> own_motor() const override { return design_; }
  std::vector<std::string> notes() const override {
    return shapes::tolerance_notes(tolerances_, design_);
  }

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
    optim::Random random(seed_, 0, index);
    std::vector<double> design;
    for (const DrawnVariable& variable : variables_) {
      // Half a step of the random number keeps it away from 0.
      design.push_back(variable.draw(random.uniform() + 0x1.0p-54));
    }
    evaluator_.evaluate(design, row);
  }

  UncertaintyResult frame() const {
    UncertaintyResult result;
    result.confidence = kConfidence;
    result.start = start_folder_;
    for (const Parameter parameter : nominal_)
      result.nominal.push_back({std::string(info(parameter).name),
                                std::string(info(parameter).unit), get(design_, parameter)});
    const std::vector<StoredColumn> all = columns();
    const auto metrics = all.begin() + static_cast<std::ptrdiff_t>(variables());
    result.variables.assign(all.begin(), metrics);
    for (auto column = metrics; column != all.end(); ++column) {
      result.metrics.emplace_back();
      result.metrics.back().column = *column;
    }
    for (std::size_t j = 0; j < variables(); ++j) {
      const double share = variables_[j].distribution.cut_off();
      // A smaller share is within rounding of the probabilities.
      if (share > 1e-12) result.cut_off.push_back({result.variables[j].name, share});
    }
    return result;
  }

  // Quantiles need the values at hand: 8 bytes for each metric and row.
  UncertaintyResult answer(const ResultStore& store) const {
    UncertaintyResult result = frame();
    std::vector<std::vector<double>> values(metrics_.size());
    std::vector<std::uint64_t> kept(limits_.size(), 0);
    std::uint64_t good = 0;
    store.read(0, [&](const StoredRow& row) {
      ++result.samples;
      if (row.status != "ok") ++result.failed;
      const double* metrics = row.values.data() + variables();
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        if (!std::isnan(metrics[i])) values[i].push_back(metrics[i]);
      }
      bool all = true;
      bool known = true;
      for (std::size_t i = 0; i < limits_.size(); ++i) {
        const bool holds = limits_[i].limit.holds(metrics[limits_[i].metric]);
        known = known && !std::isnan(metrics[limits_[i].metric]);
        kept[i] += holds ? 1 : 0;
        all = all && holds;
      }
      good += all ? 1 : 0;
      result.no_value += known ? 0 : 1;
    });
    for (std::size_t i = 0; i < metrics_.size(); ++i) describe(values[i], result.metrics[i]);
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const MotorLimit& limit = limits_[i].limit;
      result.limits.push_back({limit.text, limit.metric.text, limit.lower, limit.upper,
                               proportion_estimate(kept[i], result.samples, kConfidence)});
    }
    if (!limits_.empty()) result.yield = proportion_estimate(good, result.samples, kConfidence);
    return result;
  }

  void describe(std::vector<double>& values, UncertaintyResult::Metric& metric) const {
    Moments moments;
    for (const double value : values) moments.add(value);
    metric.count = moments.count();
    metric.mean = moments.mean_estimate(kConfidence);
    metric.sd = moments.sd_estimate(kConfidence);
    std::sort(values.begin(), values.end());
    for (const double p : probabilities_)
      metric.quantiles.push_back({p, quantile_estimate(values, p, kConfidence)});
  }

  EarlierDesign start_;
  MotorDesign design_;
  std::vector<Tolerance> tolerances_;
  std::vector<DrawnVariable> variables_;
  std::vector<double> probabilities_;
  std::vector<MetricExpression> metrics_;
  std::vector<LimitPlace> limits_;
  RowEvaluator evaluator_;
  std::uint64_t seed_;
  std::uint64_t samples_;
  std::string start_folder_;
  std::vector<Parameter> nominal_;
};

}  // namespace

std::unique_ptr<StudyKindRun> UncertaintyStudy::run(const StudyFile& file) const {
  return std::make_unique<UncertaintyRun>(*this, file);
}

}  // namespace twum::studies
