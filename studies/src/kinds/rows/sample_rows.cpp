// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"

#include "kinds/rows/executor.hpp"

#include <twum/base/ordered.hpp>
#include <twum/core/batch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace twum::inline v0_1::studies {
namespace {

StoredRow row_of(std::uint64_t stage, std::uint64_t index) {
  StoredRow row;
  row.stage = stage;
  row.index = index;
  return row;
}

struct RowsOfStage {
  std::uint64_t stage, count;
  std::uint64_t offset, total;  // of the progress shown
};

template <typename Ask>
bool store_asked(RunContext& context, const RowsOfStage& wanted, const Ask& ask) {
  const auto proceed = [&] { return !context.stop.stop_requested(); };
  const auto make = [&](std::uint64_t first, std::uint64_t end) {
    std::vector<StoredRow> asked;
    for (std::uint64_t index = first; index < end; ++index) asked.push_back(ask(index));
    return context.executor.rows(asked, proceed);
  };
  const auto store = [&](std::uint64_t first, const std::vector<StoredRow>& rows) {
    for (const StoredRow& row : rows) context.store.add(row);
    if (context.progress)
      context.progress({.done = wanted.offset + first + rows.size(), .total = wanted.total});
  };
  const IndexRange missing{context.store.next_index(wanted.stage), wanted.count,
                           context.executor.lanes(), proceed};
  return run_blocks(missing, make, store) >= wanted.count;
}

// Why a design is not admissible, without its values, so that equal reasons can be counted.
std::string short_reason(const DesignFailure& failure) {
  const std::string& text = failure.text;
  if (failure.kind != DesignFailure::Kind::refused) return text;
  return text.substr(0, std::min(text.find(", but is "), text.find(" = ")));
}

}  // namespace

bool store_rows(RunContext& context, std::uint64_t stage, std::uint64_t count, std::uint64_t offset,
                std::uint64_t total) {
  return store_asked(context, {stage, count, offset, total > 0 ? total : count},
                     [stage](std::uint64_t index) { return row_of(stage, index); });
}

bool store_rows(RunContext& context, std::uint64_t count,
                const std::function<StoredRow(std::uint64_t index)>& ask) {
  return store_asked(context, {0, count, 0, count}, ask);
}

RowEvaluator::RowEvaluator(VariedParameters varied, std::vector<MetricExpression> metrics)
    : varied_(std::move(varied)), metrics_(std::move(metrics)), evaluator_(metrics_) {}

std::vector<StoredColumn> RowEvaluator::columns() const {
  std::vector<StoredColumn> columns;
  for (const Parameter parameter : varied_.varied()) {
    columns.push_back({std::string(info(parameter).name), std::string(info(parameter).unit)});
  }
  for (const MetricExpression& metric : metrics_) {
    columns.push_back({metric.text, std::string(metric.unit())});
  }
  return columns;
}

namespace {

// Infinite is a time that does not end, which limits can count; its status says why.
double stored_value(const MetricValue& metric) {
  if (is_endless(metric.status)) return HUGE_VAL;
  return metric.status == MetricStatus::ok ? metric.value : kNoValue;
}

}  // namespace

void RowEvaluator::evaluate(std::span<const double> variables, StoredRow& row) const {
  row.values.assign(variables.begin(), variables.end());
  const auto outcome = ask_design([&] { return varied_.motor(variables); },
                                  [&](const Motor& motor) { return evaluator_.evaluate(motor); });
  if (const auto* failure = std::get_if<DesignFailure>(&outcome)) {
    row.values.resize(variables.size() + metrics_.size(), kNoValue);
    row.status = short_reason(*failure);
    return;
  }
  const auto& values = std::get<std::vector<MetricValue>>(outcome);
  for (const MetricValue& metric : values) row.values.push_back(stored_value(metric));
  const std::string reason = unanswered(metrics_, values);
  row.status = reason.empty() ? "ok" : reason;
}

}  // namespace twum::inline v0_1::studies
