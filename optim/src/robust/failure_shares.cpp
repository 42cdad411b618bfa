// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/failure_shares.hpp>

#include "robust/importance.hpp"

#include <twum/base/no_value.hpp>
#include <twum/optim/replicates.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::inline v0_1::optim {

FailureShares::FailureShares(std::size_t inputs) {
  for (Sums& sums : samples_) sums.scores.resize(inputs);
}

void FailureShares::add(std::uint64_t index) { samples_[index % kSamples].products += 1; }

void FailureShares::add_failing(std::uint64_t index, double weight, std::span<const double> parts) {
  add(index);
  ++failing_;
  Sums& sums = samples_[index % kSamples];
  sums.weight += weight;
  for (std::size_t k = 0; k < parts.size(); ++k) sums.scores[k] += weight * (parts[k] - 1);
}

IntervalEstimate FailureShares::share(double confidence) const {
  std::vector<ReplicateSums> list;
  double products = 0;
  for (const Sums& sums : samples_) {
    list.push_back({sums.weight, sums.products});
    products += sums.products;
  }
  IntervalEstimate share = ratio_of_replicates(list, confidence);
  share.low = std::max(share.low, 0.0);
  if (failing_ == 0) share.high = -std::log1p(-confidence) / (kPlainShare * products);  // U8.3
  share.high = std::min(share.high, 1.0);
  return share;
}

std::vector<IntervalEstimate> FailureShares::causes(double confidence) const {
  std::vector<IntervalEstimate> list;
  const std::size_t inputs = samples_.front().scores.size();
  const auto seen = std::ranges::count_if(samples_, [](const Sums& s) { return s.weight > 0; });
  for (std::size_t k = 0; k < inputs; ++k) {
    std::vector<ReplicateSums> ratios;
    for (const Sums& sums : samples_)
      ratios.push_back({sums.scores[k], std::reduce(sums.scores.begin(), sums.scores.end())});
    list.push_back(seen < 2 ? IntervalEstimate{} : ratio_of_replicates(ratios, confidence));
  }
  return list;
}

IntervalEstimate FailureShares::tighter(std::size_t input, double confidence) const {
  std::vector<ReplicateSums> list;
  for (const Sums& sums : samples_) list.push_back({0.01 * sums.scores[input], sums.products});
  return ratio_of_replicates(list, confidence);
}

}  // namespace twum::inline v0_1::optim
