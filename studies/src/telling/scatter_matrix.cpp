// SPDX-License-Identifier: Apache-2.0
#include "telling/scatter_matrix.hpp"

#include "telling/goal_parts.hpp"

#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

constexpr std::size_t kMostQuantities = 6, kMostMetrics = 3;
// The first motors: they are independent of each other, so that these are as good as any others.
constexpr std::size_t kMostMotors = 200;

struct ScatterQuantity {
  StoredColumn column;
  std::vector<double> values;  // of the motors that are drawn
  double closeness{0};         // largest correlation with a metric, without its sign
};

double pair_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double n = 0, ma = 0, mb = 0;
  const auto known = [&](std::size_t i) { return std::isfinite(a[i]) && std::isfinite(b[i]); };
  for (std::size_t i = 0; i < a.size(); ++i)
    if (known(i)) n += 1, ma += a[i], mb += b[i];
  ma /= n, mb /= n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!known(i)) continue;
    ab += (a[i] - ma) * (b[i] - mb);
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

bool is_scattered(const std::vector<double>& values) {
  constexpr double kRounding = 1e-9;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double v : values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  return high - low > kRounding * std::fabs(high);
}

class ScatterMatrix {
 public:
  ScatterMatrix(const UncertaintyResult& answer, const ResultStore& rows) : answer_(answer) {
    for (const UncertaintyResult::Metric& metric : answer.metrics)
      if (quantities_.size() < kMostMetrics) add(quantities_, metric.column, rows);
    std::vector<ScatterQuantity> variables;
    for (const StoredColumn& variable : answer.variables) add(variables, variable, rows);
    for (ScatterQuantity& variable : variables)
      for (const ScatterQuantity& metric : quantities_)
        variable.closeness = std::fmax(variable.closeness,
                                       std::fabs(pair_correlation(variable.values, metric.values)));
    std::ranges::stable_sort(variables, std::greater<>(), &ScatterQuantity::closeness);
    for (ScatterQuantity& variable : variables)
      if (quantities_.size() < kMostQuantities) quantities_.push_back(std::move(variable));
    find_broken(rows);
  }

  std::vector<Section> sections() const {
    const std::size_t count = quantities_.size();
    if (count < 2) return {};
    Section section{{"Scatter matrix"},
                    {"Each dot is a motor" +
                     std::string(answer_.samples > kMostMotors
                                     ? ", one of the first " + std::to_string(kMostMotors)
                                     : "") +
                     "."}};
    section.columns = count - 1;
    for (std::size_t row = 1; row < count; ++row)
      for (std::size_t column = 0; column + 1 < count; ++column)
        section.charts.push_back(column < row ? pair(column, row) : Chart{});
    return {section};
  }

 private:
  static void add(std::vector<ScatterQuantity>& list, const StoredColumn& column,
                  const ResultStore& rows) {
    std::vector<double> values = column_values(rows, column.name);
    values.resize(std::min(values.size(), kMostMotors));
    if (is_scattered(values)) list.push_back({column, std::move(values)});
  }

  void find_broken(const ResultStore& rows) {
    for (const UncertaintyResult::Limit& limit : answer_.limits) {
      const std::vector<double> values = column_values(rows, limit.metric);
      broken_.resize(std::min(values.size(), kMostMotors), false);
      for (std::size_t i = 0; i < broken_.size(); ++i)
        if (!(values[i] >= limit.lower && values[i] <= limit.upper)) broken_[i] = true;
    }
  }

  Chart pair(std::size_t x, std::size_t y) const {
    const ScatterQuantity& across = quantities_[x];
    const ScatterQuantity& up = quantities_[y];
    const bool keyed = x == 0 && y == 1 && !broken_.empty();  // once for all
    Series keep{keyed ? "keeps the limits" : "", Stroke::dots},
        fail{keyed ? "violates a limit" : "", Stroke::dots, {}, {}, "c1"};
    for (std::size_t i = 0; i < across.values.size(); ++i) {
      if (!std::isfinite(across.values[i]) || !std::isfinite(up.values[i])) continue;
      Series& one = i < broken_.size() && broken_[i] ? fail : keep;
      one.x.values.push_back(across.values[i]);
      one.y.values.push_back(up.values[i]);
    }
    Chart chart{"scatter " + up.column.name + " " + across.column.name,
                {name_part(up.column.name), " over ", name_part(across.column.name)},
                {{name_part(across.column.name)}, across.column.unit},
                {{name_part(up.column.name)}, up.column.unit}};
    for (Series* one : {&keep, &fail})
      if (!one->x.values.empty()) chart.series.push_back(std::move(*one));
    return chart;
  }

  const UncertaintyResult& answer_;
  std::vector<ScatterQuantity> quantities_;
  std::vector<bool> broken_;
};

}  // namespace

std::vector<Section> scatter_sections(const UncertaintyResult& answer, const ResultStore& rows) {
  return ScatterMatrix(answer, rows).sections();
}

}  // namespace twum::inline v0_1::studies::telling
