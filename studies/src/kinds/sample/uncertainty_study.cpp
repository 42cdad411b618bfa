// SPDX-License-Identifier: Apache-2.0
#include "entries/tolerance_shape.hpp"
#include "kinds/rows/earlier_result.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/found_motors.hpp"
#include "kinds/sample/measured_parts.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/estimate.hpp>

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
  double inadmissible;

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
    variables.push_back({one.parameter, one.distribution(value), one.inadmissible(value)});
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

MeasuredParts measured_parts(const StudyFile& file, const UncertaintyStudy& asked,
                             const MotorDesign& design) {
  if (asked.parts.empty()) return {};
  MeasuredParts parts((std::filesystem::path(file.folder) / asked.parts).string(), design);
  for (const Tolerance& one : asked.variables)
    if (std::ranges::find(parts.parameters(), one.parameter) != parts.parameters().end())
      throw InputError("study.variables." + std::string(info(one.parameter).name) +
                       ": has a column in study.parts too; leave one of them out");
  return parts;
}

std::vector<Parameter> drawn_parameters(const std::vector<DrawnVariable>& variables,
                                        const MeasuredParts& parts) {
  std::vector<Parameter> list = parameters_of(variables);
  list.insert(list.end(), parts.parameters().begin(), parts.parameters().end());
  return list;
}

// The name of what a path leads to. The path itself is another one in the folder of the results.
std::string last_name(const std::string& path) {
  const auto normal = std::filesystem::path(path + "/").lexically_normal();
  return normal.parent_path().filename().string();
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
        correlation_(asked.variables.size(), correlated_pairs(asked.variables, asked.correlations)),
        parts_(measured_parts(file, asked, design_)),
        parts_name_(last_name(asked.parts)),
        probabilities_(sorted(asked.quantiles)),
        metrics_(with_derived(asked.metrics, asked.derived)),
        limits_(place_limits(asked.limits, metrics_)),
        evaluator_({design_, drawn_parameters(variables_, parts_), asked.derived}, metrics_),
        seed_(asked.seed),
        samples_(asked.samples),
        start_name_(last_name(asked.start)),
        nominal_(nominal_parameters(asked, start_)) {}

  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return variables_.size() + parts_.parameters().size(); }
  std::uint64_t seed() const override { return seed_; }
  std::optional<MotorDesign> own_motor() const override { return design_; }
  std::vector<std::string> notes() const override {
    std::vector<std::string> notes = shapes::tolerance_notes(tolerances_, design_);
    for (const std::string& name : parts_.unused())
      notes.push_back("column " + quoted(name) + " of " + quoted(parts_name_) +
                      " is no parameter and is not used");
    return notes;
  }
  std::string_view grows_by() const override { return "study.samples"; }

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
    if (parts_.size() > 0) {
      const auto part = parts_.draw(optim::Random(seed_, 1, index).uniform());
      design.insert(design.end(), part.begin(), part.end());
    }
    evaluator_.evaluate(design, row);
  }

  // Of each variable, correlated as their normal numbers are.
  std::vector<double> drawn_probabilities(std::uint64_t index) const {
    optim::Random random(seed_, 0, index);
    std::vector<double> list;
    // Half a step of the random number keeps it away from 0.
    for (std::size_t k = 0; k < variables_.size(); ++k)
      list.push_back(random.uniform() + 0x1.0p-54);
    if (correlation_.independent()) return list;
    for (double& u : list) u = optim::normal_quantile(u);
    list = correlation_.correlated(std::move(list));
    for (double& y : list) y = std::clamp(optim::normal_cdf(y), 0x1.0p-54, 1 - 0x1.0p-53);
    return list;
  }

  UncertaintyResult frame() const {
    UncertaintyResult result;
    result.parts = parts_name_;
    result.part_count = parts_.size();
    result.confidence = kConfidence;
    result.start = start_name_;
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
    for (std::size_t j = 0; j < variables_.size(); ++j)
      if (variables_[j].inadmissible > 1e-12)  // less is within rounding of the probabilities
        result.inadmissible.push_back({result.variables[j].name, variables_[j].inadmissible});
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
  optim::Correlation correlation_;
  MeasuredParts parts_;
  std::string parts_name_;
  std::vector<double> probabilities_;
  std::vector<MetricExpression> metrics_;
  std::vector<LimitPlace> limits_;
  RowEvaluator evaluator_;
  std::uint64_t seed_;
  std::uint64_t samples_;
  std::string start_name_;
  std::vector<Parameter> nominal_;
};

}  // namespace

std::unique_ptr<StudyKindRun> UncertaintyStudy::run(const StudyFile& file) const {
  return std::make_unique<UncertaintyRun>(*this, file);
}

}  // namespace twum::studies
