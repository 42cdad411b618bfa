// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/studies/sobol_indices.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kLeastPoints = 64;  // of a replicate

bool any_nan(std::span<const double> values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
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
    sums.c.resize(variables);
    sums.c_square.resize(variables);
    sums.b_c.resize(variables);
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
  sums.b += b;
  sums.b_square += b * b;
  for (std::size_t j = 0; j < variables_; ++j) {
    const double step = values[2 + j] - values[0], c = values[2 + j] - shift_;
    sums.c[j] += c;
    sums.c_square[j] += c * c;
    sums.b_c[j] += b * c;
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

std::vector<const SobolIndices::Sums*> SobolIndices::filled() const {
  std::vector<const Sums*> list;
  for (const Sums& sums : replicates_)
    if (sums.count > 0) list.push_back(&sums);
  return list;
}

// B (C - A) over the variance: accurate where the index is small.
std::vector<optim::ReplicateSums> SobolIndices::saltelli(std::size_t variable) const {
  const double m = centre();
  std::vector<optim::ReplicateSums> list;
  for (const Sums* s : filled())
    list.push_back({s->product[variable] - m * s->step[variable], variance_sum(*s)});
  return list;
}

// The correlation of B and C about their common mean: accurate where the index is large.
std::vector<optim::ReplicateSums> SobolIndices::janon(std::size_t variable) const {
  double m = 0;
  for (const Sums& s : replicates_) m += 0.5 * (s.b + s.c[variable]);
  m /= static_cast<double>(blocks_);
  std::vector<optim::ReplicateSums> list;
  for (const Sums* s : filled()) {
    const double both = s->b + s->c[variable], shift = m * m * s->count - m * both;
    list.push_back({s->b_c[variable] + shift, 0.5 * (s->b_square + s->c_square[variable]) + shift});
  }
  return list;
}

// (A - C)^2 / 2 over the variance.
std::vector<optim::ReplicateSums> SobolIndices::jansen(std::size_t variable) const {
  std::vector<optim::ReplicateSums> list;
  for (const Sums* s : filled()) list.push_back({s->half_square[variable], variance_sum(*s)});
  return list;
}

std::vector<optim::ReplicateSums> SobolIndices::slope_bound(std::size_t variable) const {
  std::vector<optim::ReplicateSums> list;
  for (const Sums* s : filled())
    list.push_back({s->slope[variable] / (std::numbers::pi * std::numbers::pi), variance_sum(*s)});
  return list;
}

std::vector<SobolShares> SobolIndices::shares(double confidence) const {
  constexpr double kLarge = 0.5;
  std::vector<SobolShares> result(variables_);
  const std::vector<const Sums*> used = filled();
  if (used.size() < 2 || constant() || variance() == 0) return result;
  const bool slopes =
      std::ranges::all_of(used, [](const Sums* s) { return s->gradients == s->count; });
  for (std::size_t j = 0; j < variables_; ++j) {
    auto first = saltelli(j);
    if (optim::ratio_of_replicates(first, confidence).value > kLarge) first = janon(j);
    const auto total = jansen(j);
    result[j].first = optim::ratio_of_replicates(first, confidence);
    result[j].total = optim::ratio_of_replicates(total, confidence);
    result[j].interactions = optim::difference_of_ratios(total, first, confidence);
    if (slopes) result[j].derivative_bound = optim::ratio_of_replicates(slope_bound(j), confidence);
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

}  // namespace twum::inline v0_1::studies
