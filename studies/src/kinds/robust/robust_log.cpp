// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/robust_log.hpp"

#include "kinds/rows/row_bytes.hpp"

#include <algorithm>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kRoundsOfASearch = 1'000'000;  // more than one search ever needs

}  // namespace

RobustLog::RobustLog(const DesignProblem& problem, std::vector<double> chosen, std::uint64_t search,
                     RunContext& context)
    : context_(context),
      variables_(problem.variables.size()),
      chosen_(std::move(chosen)),
      search_(search),
      rows_(problem),
      motors_(problem),
      done_(context.store.rows()) {
  context.store.read([&](const StoredRow& row) {
    if (SearchStage::of(row.stage).phase != SearchStage::Phase::robust) return;
    RowBytes bytes(row.detail);
    const bool gradient = bytes.take<std::uint8_t>() != 0;
    const auto round = bytes.take<std::uint64_t>();
    const std::vector<double> y = bytes.numbers();
    optim::Evaluation evaluation;
    if (row.status != "ok") evaluation.failure = row.status;
    evaluation.values = bytes.numbers();
    evaluation.jacobian = bytes.numbers();
    stored_.emplace(key(round, y, gradient), std::move(evaluation));
  });
}

optim::RobustOptions RobustLog::options(const optim::SolveOptions& solve) {
  optim::RobustOptions options;
  options.solve = solve;
  options.solve.observer = {};
  budget_ = solve.budget.evaluations;
  options.solve.first_stage = SearchStage{SearchStage::Phase::robust, 0, search_}.number();
  options.recall = [this](std::uint64_t round, std::span<const double> y, bool gradient,
                          const optim::Evaluator& evaluate) {
    return recall(kRoundsOfASearch * search_ + round, y, gradient, evaluate);
  };
  options.observer = [this](std::uint64_t round, const optim::Observation& observation) {
    observe(kRoundsOfASearch * search_ + round, observation);
  };
  options.sampled = [this](std::uint64_t made, std::uint64_t most) {
    if (made < sample_) products_ += sample_;  // another sample
    sample_ = made;
    if (context_.progress) context_.progress(progress_of_sample(motors(), made, most));
  };
  return options;
}

RunProgress progress_of_sample(std::uint64_t done, std::uint64_t made, std::uint64_t most) {
  return {.done = done,
          .budget = true,
          .stage = "motor " + std::to_string(made) + " of a sample",
          .share = static_cast<double>(made) / static_cast<double>(most)};
}

std::string RobustLog::key(std::uint64_t round, std::span<const double> y, bool gradient) {
  std::string bytes = SearchRows::key(y, gradient);
  append_bytes(bytes, round);
  return bytes;
}

optim::Evaluation RobustLog::recall(std::uint64_t round, std::span<const double> y, bool gradient,
                                    const optim::Evaluator& evaluate) const {
  const auto found = stored_.find(key(round, y, gradient));
  return found != stored_.end() ? found->second : evaluate(y, gradient);
}

void RobustLog::observe(std::uint64_t round, const optim::Observation& observation) {
  const auto x = observation.design.first(variables_);
  std::vector<double> design(x.begin(), x.end());
  design.insert(design.end(), chosen_.begin(), chosen_.end());
  StoredRow row = rows_.row(observation.stage, observation.index, design, false,
                            motors_.evaluate(design, false));
  row.status = observation.evaluation.ok() ? "ok" : observation.evaluation.failure;
  row.detail.clear();
  append_bytes(row.detail, static_cast<std::uint8_t>(observation.gradient));
  append_bytes(row.detail, round);
  append_numbers(row.detail, {observation.design.begin(), observation.design.end()});
  append_numbers(row.detail, observation.evaluation.values);
  append_numbers(row.detail, observation.evaluation.jacobian);
  context_.store.add(row);
  ++done_;
  report_progress(round);
}

void RobustLog::report_progress(std::uint64_t round) {
  in_round_ = round == round_ ? in_round_ + 1 : 1;
  round_ = round;
  if (!context_.progress) return;
  const double share =
      budget_ > 0 ? static_cast<double>(in_round_) / static_cast<double>(budget_) : 0;
  context_.progress(
      {.done = motors(),
       .budget = true,
       .stage = "under tolerances, round " + std::to_string(1 + round % kRoundsOfASearch),
       .share = std::min(share, 1.0)});
}

}  // namespace twum::inline v0_1::studies
