// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/round.hpp"

#include <cstdint>

namespace twum::inline v0_1::optim {

/// Which sample to draw, and on how many threads.
struct SamplePlan {
  std::uint64_t products{4096};
  std::uint64_t seed{1};
  std::uint64_t replicate{0};
  unsigned jobs{1};
  std::function<bool()> proceed{};  ///< called between products; false ends the sample early
  /// called with the number of products made so far and that of the sample, by one thread at a time
  std::function<void(std::uint64_t, std::uint64_t)> sampled{};
};

/// Products, as standard normal numbers z.
using NormalPoints = std::vector<std::vector<double>>;

/// Part of the products that are drawn without a centre.
inline constexpr double kPlainShare = 0.1;

/// z of a product, U4.1.
/// @param u  a point of the unit cube with one coordinate more than z, which selects plain, wide, or one of the centres
std::vector<double> drawn_normals(std::span<const double> u, const NormalPoints& centres);
/// The density of plain products at z over that of the drawn ones, N w of U4.2: at most 1 / kPlainShare.
double drawn_weight(std::span<const double> z, const NormalPoints& centres);

/// Margins of products drawn about the worst points, U4.1 and U4.2.
struct ImportanceSample {
  std::vector<double> weights;  ///< one for each product
  /// for each product, one for each term; -infinity without an answer
  std::vector<std::vector<double>> margins;
  NormalPoints normals;  ///< z of each product
  bool complete{false};  ///< false if the sample ended early
};

ImportanceSample draw_importance(const RobustProblem& problem, const RobustTerms& terms,
                                 std::span<const double> x, const NormalPoints& centres,
                                 const SamplePlan& plan);

/// Risk of one yield target estimated from a sample, U4.3.
struct SampledRisk {
  std::vector<double> of_term;  ///< p_j, of the target's terms in their order
  double any{0.0};              ///< p_any
  double error{0.0};            ///< its standard error
};

SampledRisk sampled_risk(const ImportanceSample& sample, std::span<const std::size_t> terms);

/// Q_j of U4.4: the value below which a term's margin lies with the given probability, by a line through 40
/// neighbours. NaN if too few products have an answer.
double weighted_quantile(const ImportanceSample& sample, std::size_t term, double beta);
/// Standard deviation of a term's margin over the products with an answer.
double weighted_spread(const ImportanceSample& sample, std::size_t term);

}  // namespace twum::inline v0_1::optim
