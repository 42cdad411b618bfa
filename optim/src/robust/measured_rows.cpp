// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/measured_rows.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::optim {
namespace {

// Rows that are no more than the columns, or a column that follows from others, have a singular matrix of correlations. This
// much less of each coefficient leaves every input a part of its own.
constexpr double kKept = 1.0 - 1e-6;

}  // namespace

void MeasuredRows::add(std::span<const double> row, double weight) {
  const bool finite = std::ranges::all_of(row, [](double v) { return std::isfinite(v); });
  if (row.size() != columns_ || !finite || !(weight >= 0.0) || !std::isfinite(weight))
    throw InputError(
        "a measured row has one finite value for each column, and a weight of 0 or more");
  values_.insert(values_.end(), row.begin(), row.end());
  sums_.push_back(sum_of_weights() + weight);
}

std::span<const double> MeasuredRows::draw(double u) const {
  const auto found = std::ranges::upper_bound(sums_, u * sums_.back());
  const auto row = std::min(static_cast<std::size_t>(found - sums_.begin()), size() - 1);
  return std::span(values_).subspan(row * columns_, columns_);
}

double MeasuredRows::mean(std::size_t column) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) sum += weight(i) * value(i, column);
  return sum / sum_of_weights();
}

double MeasuredRows::covariance(std::size_t a, std::size_t b) const {
  const double mean_a = mean(a), mean_b = mean(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i)
    sum += weight(i) * (value(i, a) - mean_a) * (value(i, b) - mean_b);
  return sum / sum_of_weights();
}

double MeasuredRows::sd(std::size_t column) const { return std::sqrt(covariance(column, column)); }

double MeasuredRows::correlation(std::size_t a, std::size_t b) const {
  const double spread = sd(a) * sd(b);
  return spread > 0.0 ? covariance(a, b) / spread : 0.0;
}

RandomInput measured_input(const MeasuredRows& rows, std::size_t column, std::string name,
                           double value) {
  RandomInput input{std::move(name), Law::given};
  input.value = value;
  input.transform = [mean = rows.mean(column), sd = rows.sd(column)](double z) {
    return BuiltValue{mean + sd * z, 0.0, sd, 0.0};
  };
  return input;
}

std::vector<CorrelatedPair> measured_pairs(const MeasuredRows& rows, std::size_t first) {
  std::vector<CorrelatedPair> pairs;
  for (std::size_t a = 0; a < rows.columns(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (const double coefficient = rows.correlation(a, b); coefficient != 0.0)
        pairs.push_back({first + a, first + b, kKept * coefficient});
  return pairs;
}

}  // namespace twum::inline v0_1::optim
