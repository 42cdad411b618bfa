// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"
#include "kinds/rows/stored_medians.hpp"
#include "kinds/sample/design_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// Metrics of a grid, list or sample of designs: one stage, a row for each design.
class SweepRun : public StudyKindRun {
 public:
  SweepRun(const SweepStudy& asked, const MotorDesign& motor)
      : sampler_(asked),
        derived_(parameters_of(asked.derived)),
        evaluator_({motor, sampler_.variables(), asked.derived},
                   with_derived(asked.metrics, asked.derived)) {}

  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return sampler_.variables().size(); }
  std::uint64_t seed() const override { return sampler_.seed(); }

  KindAnswer run(RunContext& context) override {
    const bool complete = store_rows(context, 0, sampler_.count());
    SweepResult result = answer(context.store);
    bool any = false;
    for (const SweepResult::Metric& metric : result.metrics) any = any || metric.count > 0;
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index >= sampler_.count()) return {};
    StoredRow row{0, asked.index, {}, "ok", {}};
    fill(asked.index, row);
    return row;
  }

 private:
  void fill(std::uint64_t index, StoredRow& row) const {
    std::vector<double> design(variables());
    sampler_.design(index, design);
    evaluator_.evaluate(design, row);
  }

  SweepResult::Design design_of(const StoredRow& row) const {
    const auto metrics = row.values.begin() + static_cast<std::ptrdiff_t>(variables());
    return {row.index, {row.values.begin(), metrics}, {metrics, row.values.end()}};
  }

  void note(SweepResult::Metric& metric, double value, const StoredRow& row) const {
    if (std::isnan(value)) return;
    const bool first = metric.count++ == 0;
    if (first || value < metric.min) {
      metric.min = value;
      metric.lowest = design_of(row);
    }
    if (first || value > metric.max) {
      metric.max = value;
      metric.highest = design_of(row);
    }
  }

  bool is_derived(const std::string& name) const {
    return std::ranges::any_of(derived_, [&](Parameter p) { return info(p).name == name; });
  }

  SweepResult answer(const ResultStore& store) const {
    SweepResult result;
    result.sampling = to_string(sampler_.sampling());
    result.designs = sampler_.count();
    const std::vector<StoredColumn> all = columns();
    const auto metrics = all.begin() + static_cast<std::ptrdiff_t>(variables());
    result.variables.assign(all.begin(), metrics);
    for (auto column = metrics; column != all.end(); ++column) {
      if (is_derived(column->name)) result.derived.push_back(result.metrics.size());
      result.metrics.push_back({*column, 0, kNoValue, kNoValue, kNoValue, {}, {}});
    }
    store.read(0, [&](const StoredRow& row) {
      ++result.stored;
      result.failed += row.status == "ok" ? 0 : 1;
      for (std::size_t i = 0; i < result.metrics.size(); ++i)
        note(result.metrics[i], row.values[variables() + i], row);
    });
    const std::vector<double> medians = stored_medians(store, 0, variables());
    for (std::size_t i = 0; i < medians.size(); ++i) result.metrics[i].median = medians[i];
    return result;
  }

  DesignSampler sampler_;
  std::vector<Parameter> derived_;
  RowEvaluator evaluator_;
};

}  // namespace

std::unique_ptr<StudyKindRun> SweepStudy::run(const StudyFile& file) const {
  return std::make_unique<SweepRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
