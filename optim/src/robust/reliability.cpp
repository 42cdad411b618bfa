// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/reliability.hpp>

#include "robust/centres.hpp"
#include "robust/design_point.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::uint64_t kSoughtReplicates = 1'000'000;  // apart from those that decide
constexpr std::uint64_t kProductsOfScramble = kProductsOfWays / FailureShares::kSamples;
// of the index of a limit: the risk of a point beyond is 100 times smaller
constexpr double kOtherPoints = 1.5;
constexpr double kFirstDistance = 3.0;

class WaysSearch {
 public:
  WaysSearch(const RobustProblem& problem, const WaysOptions& options)
      : problem_(problem), options_(options), terms_(problem) {}

  WaysToFail run() {
    for (std::size_t j = 0; j < terms_.terms.size(); ++j) found_.push_back(of_term(j));
    Centres centres(problem_, terms_, {}, nearest_points(), taken(),
                    [this](std::size_t j, std::span<const double> z) { return noted(j, z); });
    for (const auto& list : found_)
      for (const NearestFailure& one : list)
        if (one.beta <= list.front().beta + kOtherPoints && std::isfinite(one.beta))
          centres.add(one.point.at.z);
    // Without a centre products are plain; about the design a tenth of them is twice as wide.
    if (centres.centres().empty()) centres.add(std::vector<double>(problem_.inputs.size(), 0.0));
    for (std::uint64_t k = 0; k < FailureShares::kSamples; ++k) {
      if (options_.proceed && !options_.proceed()) break;
      centres.sample(plan(k));
    }
    return {points(), centres.centres()};
  }

 private:
  // The nearest first.
  using Found = std::vector<NearestFailure>;

  static void sort(Found& list) {
    std::ranges::stable_sort(list, {}, [](const NearestFailure& one) { return one.beta; });
  }

  // From the gradient at the design, and from both sides of each input.
  Found of_term(std::size_t j) const {
    const Margin& margin = terms_.terms[j].margin;
    Found list{nearest_failure(problem_, margin, {}, {})};
    for (std::size_t k = 0; k < 2 * problem_.inputs.size(); ++k) {
      std::vector<double> start(problem_.inputs.size(), 0.0);
      start[k / 2] = k % 2 == 0 ? kFirstDistance : -kFirstDistance;
      list.push_back(nearest_failure(problem_, margin, {}, start));
    }
    sort(list);
    return list;
  }

  // The point of a term from a failing product, which a sample has shown.
  InversePoint noted(std::size_t j, std::span<const double> direction) {
    std::vector<double> start(direction.begin(), direction.end());
    for (double& c : start) c *= kFirstDistance;
    NearestFailure one = nearest_failure(problem_, terms_.terms[j].margin, {}, start);
    if (!std::isfinite(one.beta)) one.point.at.failure = "none";
    found_[j].push_back(one);
    sort(found_[j]);
    return one.point;
  }

  std::vector<InversePoint> nearest_points() const {
    std::vector<InversePoint> list;
    for (const Found& found : found_) list.push_back(found.front().point);
    return list;
  }

  std::vector<bool> taken() const {
    std::vector<bool> list;
    for (const Found& found : found_) list.push_back(std::isfinite(found.front().beta));
    return list;
  }

  SamplePlan plan(std::uint64_t scramble) const {
    const std::uint64_t before = scramble * kProductsOfScramble;
    return {kProductsOfScramble,
            options_.seed,
            kSoughtReplicates + scramble,
            options_.jobs,
            options_.proceed,
            [this, before](std::uint64_t made, std::uint64_t /*of*/) {
              if (options_.sampled) options_.sampled(before + made, kProductsOfWays);
            }};
  }

  std::vector<DesignPoint> points() const {
    std::vector<DesignPoint> list;
    for (std::size_t j = 0; j < found_.size(); ++j) {
      const Margin& margin = terms_.terms[j].margin;
      const NearestFailure& nearest = found_[j].front();
      list.push_back({margin.response, margin.sign > 0.0 ? Side::lower : Side::upper, nearest.beta,
                      nearest.point.at.z, nearest.point.converged});
    }
    return list;
  }

  const RobustProblem& problem_;
  const WaysOptions& options_;
  RobustTerms terms_;
  std::vector<Found> found_;  // of each term
};

}  // namespace

WaysToFail ways_to_fail(const RobustProblem& problem, const WaysOptions& options) {
  return WaysSearch(problem, options).run();
}

WeightedProducts::WeightedProducts(std::size_t inputs, std::uint64_t seed,
                                   std::vector<std::vector<double>> centres)
    : centres_(std::move(centres)) {
  for (std::uint64_t k = 0; k < FailureShares::kSamples; ++k)
    scrambles_.emplace_back(inputs + 1, seed, k);
}

std::vector<double> WeightedProducts::normals(std::uint64_t index) const {
  const ScrambledSobol& scramble = scrambles_[index % FailureShares::kSamples];
  std::vector<double> u(scramble.dimension());
  scramble.point(index / FailureShares::kSamples, u);
  return drawn_normals(u, centres_);
}

double WeightedProducts::weight(std::span<const double> z) const {
  return drawn_weight(z, centres_);
}

std::uint64_t WeightedProducts::balanced(std::uint64_t products) {
  constexpr std::uint64_t kLeastOfScramble = 256;
  return std::bit_ceil(std::max(products, FailureShares::kSamples * kLeastOfScramble));
}

}  // namespace twum::inline v0_1::optim
