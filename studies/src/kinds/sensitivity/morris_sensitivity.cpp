// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/sensitivity_study.hpp"

#include <twum/studies/elementary_effects.hpp>

#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// Morris' screening: a stage of trajectories of d + 1 rows.
class MorrisSensitivity : public SensitivityRun {
 public:
  MorrisSensitivity(const SensitivityStudy& asked, const MotorDesign& motor)
      : SensitivityRun(asked, motor),
        seed_(asked.seed),
        trajectories_(asked.samples.value_or(standard_samples(SensitivityMethod::morris))),
        design_(box_.size(), seed_) {}

  std::uint64_t seed() const override { return seed_; }

  KindAnswer run(RunContext& context) override {
    const bool complete = store_rows(context, 0, trajectories_ * design_.trajectory_size());
    SensitivityResult result = answer(context.store);
    std::string word = outcome(result, complete);
    return {std::move(word), std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index >= trajectories_ * design_.trajectory_size()) return {};
    StoredRow row;
    row.index = asked.index;
    fill(asked.index, row);
    return row;
  }

 private:
  std::vector<double> unit_point(std::uint64_t index) const {
    std::vector<double> unit(variables());
    design_.point(index / design_.trajectory_size(), index % design_.trajectory_size(), unit);
    return unit;
  }

  void fill(std::uint64_t index, StoredRow& row) const {
    evaluator_.evaluate(box_.values(unit_point(index)), row);
  }

  SensitivityResult answer(const ResultStore& store) const {
    const std::size_t size = design_.trajectory_size();
    std::vector<ElementaryEffects> effects(metrics_.size(), ElementaryEffects(variables()));
    std::vector<Moments> values(metrics_.size());
    std::vector<std::vector<double>> along(metrics_.size());  // values of one trajectory
    std::vector<double> points;
    store.read(0, [&](const StoredRow& row) {
      const auto coordinates = box_.coordinates(unit_point(row.index));
      points.insert(points.end(), coordinates.begin(), coordinates.end());
      for (std::size_t i = 0; i < metrics_.size(); ++i)
        along[i].push_back(row.values[variables() + i]);
      if (row.index % size != size - 1) return;
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        const std::uint64_t before = effects[i].trajectories();
        effects[i].add(points, along[i]);
        if (effects[i].trajectories() > before) {
          for (const double value : along[i]) values[i].add(value);
        }
        along[i].clear();
      }
      points.clear();
    });
    SensitivityResult result = frame(SensitivityMethod::morris);
    for (std::size_t i = 0; i < metrics_.size(); ++i) {
      MetricSensitivity& metric = result.metrics[i];
      metric.samples = effects[i].trajectories();
      metric.dropped = effects[i].dropped();
      metric.value = values[i].mean();
      metric.sd = values[i].sd();
      result.samples = metric.samples + metric.dropped;
      if (!refused(metric, "trajectories")) metric.effects = effects[i].effects(confidence_);
    }
    return result;
  }

  std::uint64_t seed_;
  std::uint64_t trajectories_;
  MorrisDesign design_;
};

}  // namespace

std::unique_ptr<StudyKindRun> make_morris_sensitivity(const SensitivityStudy& asked,
                                                      const MotorDesign& motor) {
  return std::make_unique<MorrisSensitivity>(asked, motor);
}

}  // namespace twum::inline v0_1::studies
