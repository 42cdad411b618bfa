// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample_rows.hpp"

#include <twum/studies/metrics/evaluate_design.hpp>

#include <twum/studies/jobs/ordered.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace twum::studies {
namespace {

constexpr std::uint64_t kMostRowsAtATime = 256;

// Rows that one thread fills at a stretch.
struct Block {
  std::uint64_t count{0};  // wanted; fewer rows if the run was asked to stop
  std::vector<Row> rows;
};

Row row_of(std::uint64_t stage, std::uint64_t index) {
  Row row;
  row.stage = stage;
  row.index = index;
  return row;
}

// Enough blocks for every thread to have its share, and rows enough in one to be worth the handing on.
std::uint64_t rows_at_a_time(std::uint64_t count, unsigned jobs) {
  return std::clamp<std::uint64_t>(count / (std::uint64_t{8} * jobs), 1, kMostRowsAtATime);
}

// Why a design is none: the text without the values it found, so that such rows can be counted.
std::string short_reason(const std::string& text) {
  return text.substr(0, std::min(text.find(", but is "), text.find(" = ")));
}

}  // namespace

bool store_rows(RunContext& context, std::uint64_t stage, std::uint64_t count,
                const std::function<void(std::uint64_t index, Row& row)>& fill,
                std::uint64_t offset, std::uint64_t total) {
  const unsigned jobs = std::max(context.jobs, 1U);
  std::uint64_t next = context.store.next_index(stage);
  std::uint64_t stored = std::min(next, count);
  const std::uint64_t at_a_time = rows_at_a_time(count - stored, jobs);
  bool complete = true;
  run_ordered<Block>(
      jobs,
      [&](Block& block) {
        if (next >= count || context.stop.stop_requested()) return false;
        block.count = std::min(at_a_time, count - next);
        block.rows.push_back(row_of(stage, next));
        next += block.count;
        return true;
      },
      [&](Block& block) {
        const std::uint64_t first = block.rows.front().index;
        fill(first, block.rows.front());
        for (std::uint64_t i = 1; i < block.count && !context.stop.stop_requested(); ++i) {
          block.rows.push_back(row_of(stage, first + i));
          fill(first + i, block.rows.back());
        }
      },
      [&](Block& block) {
        if (!complete) return;  // rows have no gaps
        for (const Row& row : block.rows) context.store.add(row);
        stored += block.rows.size();
        complete = block.rows.size() == block.count;
        if (context.progress) context.progress({offset + stored, total > 0 ? total : count, {}});
      });
  return stored >= count;
}

RowEvaluator::RowEvaluator(VariedParameters varied, std::vector<MetricExpression> metrics)
    : varied_(std::move(varied)), metrics_(std::move(metrics)), evaluator_(metrics_) {}

std::vector<Column> RowEvaluator::columns() const {
  std::vector<Column> columns;
  for (const Parameter parameter : varied_.varied()) {
    columns.push_back({std::string(info(parameter).name), std::string(info(parameter).unit)});
  }
  for (const MetricExpression& metric : metrics_) {
    columns.push_back({metric.text, std::string(metric.unit())});
  }
  return columns;
}

void RowEvaluator::evaluate(std::span<const double> variables, Row& row) const {
  constexpr MetricValue kNone{std::numeric_limits<double>::quiet_NaN(), MetricStatus::undefined};
  std::vector<MetricValue> values(metrics_.size(), kNone);
  std::string reason;
  try {
    reason = evaluate_design(varied_.motor(variables), metrics_, evaluator_, values);
  } catch (const InputError& error) {
    reason = short_reason(error.what());
  } catch (const EvaluationError& error) {
    reason = error.reason();
  }
  row.values.assign(variables.begin(), variables.end());
  for (const MetricValue& value : values) {
    row.values.push_back(
        value.status == MetricStatus::ok ? value.value : std::numeric_limits<double>::quiet_NaN());
  }
  row.status = reason.empty() ? "ok" : reason;
}

}  // namespace twum::studies
