// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/studies/sobol_indices.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace twum::studies {
namespace {

constexpr std::uint64_t kLeastPoints = 16;  // of a replicate

bool any_nan(std::span<const double> values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
}

// A ratio of sums over independent replicates: {numerator, denominator} of each.
Estimate ratio_estimate(std::span<const std::pair<double, double>> replicates, double confidence) {
  double above = 0;
  double below = 0;
  for (const auto& [n, d] : replicates) {
    above += n;
    below += d;
  }
  const double ratio = above / below;
  double scatter = 0;
  for (const auto& [n, d] : replicates) scatter += (n - ratio * d) * (n - ratio * d);
  const auto count = static_cast<double>(replicates.size());
  const double error = std::sqrt(scatter * count / (count - 1)) / std::abs(below);
  const double half = optim::student_quantile(count - 1, (1 + confidence) / 2) * error;
  return {ratio, ratio - half, ratio + half};
}

}  // namespace

SobolDesign::SobolDesign(std::size_t variables, std::uint64_t seed) : variables_(variables) {
  for (std::uint64_t r = 0; r < kReplicates; ++r) replicates_.emplace_back(2 * variables, seed, r);
}

std::uint64_t SobolDesign::balanced(std::uint64_t blocks) {
  return std::bit_ceil(std::max(blocks, kReplicates * kLeastPoints));
}

void SobolDesign::point(std::uint64_t block, std::size_t member, std::span<double> unit) const {
  TWUM_ASSERT(unit.size() == variables_ && member < block_size());
  std::vector<double> both(2 * variables_);
  replicates_[block % kReplicates].point(block / kReplicates, both);
  const auto second = both.begin() + static_cast<std::ptrdiff_t>(variables_);
  std::copy(member == 1 ? second : both.begin(), member == 1 ? both.end() : second, unit.begin());
  if (member >= 2) unit[member - 2] = both[variables_ + member - 2];
}

SobolIndices::SobolIndices(std::size_t variables)
    : variables_(variables), replicates_(SobolDesign::kReplicates) {
  for (Sums& sums : replicates_) {
    sums.step.resize(variables);
    sums.product.resize(variables);
    sums.half_square.resize(variables);
    sums.slope.resize(variables);
  }
}

bool SobolIndices::add(std::uint64_t block, std::span<const double> values) {
  TWUM_ASSERT(values.size() == variables_ + 2);
  if (any_nan(values)) {
    ++dropped_;
    return false;
  }
  // Shifting by a value of the function avoids cancellation in the sums of squares.
  if (blocks_++ == 0) shift_ = values[0];
  Sums& sums = replicates_[block % SobolDesign::kReplicates];
  const double a = values[0] - shift_;
  const double b = values[1] - shift_;
  sums.count += 1;
  sums.value += (a + b) / 2;
  sums.square += (a * a + b * b) / 2;
  for (std::size_t j = 0; j < variables_; ++j) {
    const double step = values[2 + j] - values[0];
    sums.step[j] += step;
    sums.product[j] += b * step;
    sums.half_square[j] += step * step / 2;
  }
  return true;
}

void SobolIndices::add_gradient(std::uint64_t block, std::span<const double> gradient) {
  TWUM_ASSERT(gradient.size() == variables_);
  if (any_nan(gradient)) return;
  Sums& sums = replicates_[block % SobolDesign::kReplicates];
  sums.gradients += 1;
  for (std::size_t j = 0; j < variables_; ++j) sums.slope[j] += gradient[j] * gradient[j];
}

double SobolIndices::centre() const {
  double value = 0;
  for (const Sums& sums : replicates_) value += sums.value;
  return value / static_cast<double>(blocks_);
}

double SobolIndices::variance_sum(const Sums& sums) const {
  const double m = centre();
  return sums.square - 2 * m * sums.value + m * m * sums.count;
}

double SobolIndices::mean() const {
  return blocks_ == 0 ? std::numeric_limits<double>::quiet_NaN() : shift_ + centre();
}

double SobolIndices::variance() const {
  if (blocks_ == 0) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const Sums& sums : replicates_) sum += variance_sum(sums);
  return std::max(0.0, sum / static_cast<double>(blocks_));
}

bool SobolIndices::constant() const {
  // Metrics are accurate to about 1e-12; a standard deviation below 1e-9 of the mean is of no practical interest.
  return blocks_ > 0 && std::sqrt(variance()) <= 1e-9 * std::abs(mean());
}

std::vector<SobolShares> SobolIndices::shares(double confidence) const {
  std::vector<SobolShares> result(variables_);
  std::vector<const Sums*> filled;
  for (const Sums& sums : replicates_) {
    if (sums.count > 0) filled.push_back(&sums);
  }
  if (filled.size() < 2 || constant() || variance() == 0) return result;
  const double m = centre();
  const bool slopes = std::all_of(filled.begin(), filled.end(),
                                  [](const Sums* s) { return s->gradients == s->count; });
  std::vector<std::pair<double, double>> ratios(filled.size());
  for (std::size_t j = 0; j < variables_; ++j) {
    const auto estimate = [&](auto&& numerator) {
      for (std::size_t r = 0; r < filled.size(); ++r)
        ratios[r] = {numerator(*filled[r]), variance_sum(*filled[r])};
      return ratio_estimate(ratios, confidence);
    };
    result[j].first = estimate([&](const Sums& s) { return s.product[j] - m * s.step[j]; });
    result[j].total = estimate([&](const Sums& s) { return s.half_square[j]; });
    if (!slopes) continue;
    result[j].derivative_bound =
        estimate([&](const Sums& s) { return s.slope[j] / (std::numbers::pi * std::numbers::pi); });
  }
  return result;
}

double widest(std::span<const SobolShares> shares) {
  double width = 0;
  for (const SobolShares& s : shares) {
    for (const Estimate& e : {s.first, s.total}) {
      const double one = e.high - e.low;
      width = one >= 0 ? std::max(width, one) : std::numeric_limits<double>::infinity();
    }
  }
  return width;
}

}  // namespace twum::studies
