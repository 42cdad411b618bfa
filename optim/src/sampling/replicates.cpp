// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/replicates.hpp>

#include <twum/optim/distributions.hpp>

#include <cmath>
#include <vector>

namespace twum::inline v0_1::optim {

namespace {

// A ratio, and by how much each replicate moves it to first order.
struct Ratio {
  double value{0};
  std::vector<double> moves{};

  explicit Ratio(std::span<const ReplicateSums> replicates) {
    double above = 0;
    double below = 0;
    for (const ReplicateSums& one : replicates) {
      above += one.above;
      below += one.below;
    }
    value = above / below;
    for (const ReplicateSums& one : replicates)
      moves.push_back((one.above - value * one.below) / below);
  }
};

IntervalEstimate with_interval(double value, std::span<const double> moves, double confidence) {
  double squares = 0;
  for (const double move : moves) squares += move * move;
  const auto count = static_cast<double>(moves.size());
  const double error = std::sqrt(squares * count / (count - 1));
  const double half = student_quantile(count - 1, (1 + confidence) / 2) * error;
  return {value, value - half, value + half};
}

}  // namespace

IntervalEstimate ratio_of_replicates(std::span<const ReplicateSums> replicates, double confidence) {
  const Ratio ratio(replicates);
  return with_interval(ratio.value, ratio.moves, confidence);
}

IntervalEstimate difference_of_ratios(std::span<const ReplicateSums> more,
                                      std::span<const ReplicateSums> less, double confidence) {
  const Ratio a(more), b(less);
  std::vector<double> moves = a.moves;
  for (std::size_t r = 0; r < moves.size(); ++r) moves[r] -= b.moves[r];
  return with_interval(a.value - b.value, moves, confidence);
}

}  // namespace twum::inline v0_1::optim
