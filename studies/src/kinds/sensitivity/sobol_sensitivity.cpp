// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/metric_gradients.hpp"
#include "kinds/sensitivity/sensitivity_study.hpp"

#include <twum/studies/estimate.hpp>
#include <twum/studies/sobol_indices.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kMostDoublings = 6;  // by default 64 times the first round

// Shares of the variance. Stage 0 holds the first round of blocks, d + 2 rows each; every further
// stage as many as all before it, so that 2^m points of the sequence are complete.
class SobolSensitivity : public SensitivityRun {
 public:
  SobolSensitivity(const SensitivityStudy& asked, const MotorDesign& motor)
      : SensitivityRun(asked, motor),
        seed_(asked.seed),
        first_round_(SobolDesign::balanced(
            asked.samples.value_or(standard_samples(SensitivityMethod::sobol)))),
        most_(asked.max_samples.value_or(first_round_ << kMostDoublings)),
        width_(asked.width.value_or(0)),
        design_(box_.size(), seed_),
        gradients_(metrics_, varied_) {}

  std::uint64_t seed() const override { return seed_; }

  KindAnswer run(RunContext& context) override {
    std::vector<SobolIndices> indices(metrics_.size(), SobolIndices(variables()));
    std::vector<Moments> drawn(metrics_.size());
    SensitivityResult result;
    bool complete = true;
    for (std::uint64_t stage = 0; complete; ++stage) {
      complete = store_round(context, stage);
      read_round(context.store, stage, indices, drawn);
      result = answer(indices, drawn);
      if (width_ == 0 || result.narrow || 2 * end_of(stage) > most_) break;
    }
    std::string word = outcome(result, complete);
    return {std::move(word), std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    constexpr std::uint64_t kStages = 32;  // limit given by the length of the sequence
    if (asked.stage >= kStages ||
        asked.index >= (end_of(asked.stage) - begin_of(asked.stage)) * design_.block_size())
      return {};
    StoredRow row;
    row.stage = asked.stage;
    row.index = asked.index;
    fill(asked.stage, asked.index, row);
    return row;
  }

 private:
  // Blocks of a stage: from begin_of() to end_of().
  std::uint64_t begin_of(std::uint64_t stage) const {
    return stage == 0 ? 0 : first_round_ << (stage - 1);
  }
  std::uint64_t end_of(std::uint64_t stage) const { return first_round_ << stage; }

  bool store_round(RunContext& context, std::uint64_t stage) const {
    const std::uint64_t size = design_.block_size();
    return store_rows(context, stage, (end_of(stage) - begin_of(stage)) * size,
                      begin_of(stage) * size, end_of(stage) * size);
  }

  void fill(std::uint64_t stage, std::uint64_t index, StoredRow& row) const {
    const std::size_t member = index % design_.block_size();
    std::vector<double> unit(variables());
    design_.point(begin_of(stage) + index / design_.block_size(), member, unit);
    const std::vector<double> values = box_.values(unit);
    evaluator_.evaluate(values, row);
    if (member == 0) row.detail = slopes(values);
  }

  // Derivatives of the metrics by the coordinates.
  std::string slopes(const std::vector<double>& values) const {
    std::vector<double> numbers;
    try {
      for (const auto& gradient : gradients_.at(values)) {
        for (std::size_t j = 0; j < variables(); ++j)
          numbers.push_back(gradient.values[j] * box_.slope(j, values[j]));
      }
    } catch (const std::exception&) {
      return {};  // the row's status says why there is no such motor
    }
    return packed(numbers);
  }

  void read_round(const ResultStore& store, std::uint64_t stage, std::vector<SobolIndices>& indices,
                  std::vector<Moments>& drawn) const {
    const std::size_t size = design_.block_size();
    std::vector<std::vector<double>> values(metrics_.size());  // of one block
    std::vector<double> slopes;
    store.read(stage, [&](const StoredRow& row) {
      if (row.index % size == 0) slopes = unpacked(row.detail);
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        const double value = row.values[variables() + i];
        values[i].push_back(value);
        const bool independent = row.index % size < 2;  // A and B of a block
        if (independent && std::isfinite(value)) drawn[i].add(value);
      }
      if (row.index % size != size - 1) return;
      const std::uint64_t block = begin_of(stage) + row.index / size;
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        const bool counts = indices[i].add(block, values[i]);
        values[i].clear();
        if (counts && !slopes.empty())
          indices[i].add_gradient(block, std::span(slopes).subspan(i * variables(), variables()));
      }
    });
  }

  SensitivityResult answer(const std::vector<SobolIndices>& indices,
                           const std::vector<Moments>& drawn) const {
    SensitivityResult result = frame(SensitivityMethod::sobol);
    result.width = width_;
    for (std::size_t i = 0; i < metrics_.size(); ++i) {
      MetricSensitivity& metric = result.metrics[i];
      metric.samples = indices[i].blocks();
      metric.dropped = indices[i].dropped();
      metric.value = indices[i].mean();
      metric.sd = std::sqrt(indices[i].variance());
      if (metric.dropped > 0)  // of all motors with a value, not of whole blocks alone
        metric.value = drawn[i].mean(), metric.sd = drawn[i].sd();
      result.samples = metric.samples + metric.dropped;
      if (refused(metric, "samples")) continue;
      if (indices[i].constant()) {
        metric.note = metric.sd == 0
                          ? "the same over the whole ranges: no variable has an influence"
                          : "its standard deviation is less than 1e-9 of its mean, the accuracy of "
                            "a metric: no shares can be computed";
        continue;
      }
      const std::vector<SobolShares> shares = indices[i].shares(confidence_);
      if (width_ > 0 && widest(shares) > width_) result.narrow = false;
      metric.effects = shares;
    }
    return result;
  }

  std::uint64_t seed_;
  std::uint64_t first_round_;
  std::uint64_t most_;
  double width_;
  SobolDesign design_;
  MetricGradients gradients_;
};

}  // namespace

std::unique_ptr<StudyKindRun> make_sobol_sensitivity(const SensitivityStudy& asked,
                                                     const MotorDesign& motor) {
  return std::make_unique<SobolSensitivity>(asked, motor);
}

}  // namespace twum::inline v0_1::studies
