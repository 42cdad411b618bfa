// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/optim/failure_shares.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/optim/scrambled_sobol.hpp>

#include <functional>

namespace twum::inline v0_1::optim {

/// The most likely of the products that break one end of a limit: the one nearest to the design in standard normal numbers.
struct DesignPoint {
  std::size_t limit{0};           ///< position among the problem's limits
  Side side{Side::lower};         ///< which end
  double beta{kInfinity};         ///< its distance; infinite: none was found within 8.2
  std::vector<double> normals{};  ///< z; empty: none
  bool converged{false};          ///< the search for it converged
};

/// Where the products of a fixed design fail.
struct WaysToFail {
  std::vector<DesignPoint> points{};           ///< one for each end of a limit
  std::vector<std::vector<double>> centres{};  ///< about which products are drawn
};

/// Options of ways_to_fail().
struct WaysOptions {
  std::uint64_t seed{1};            ///< of the samples
  unsigned jobs{1};                 ///< threads
  std::function<bool()> proceed{};  ///< false ends the search early
  /// called with the number of products made so far and that of all, by one thread at a time
  std::function<void(std::uint64_t made, std::uint64_t most)> sampled{};
};

/// Products made by ways_to_fail(), at most four times as many.
inline constexpr std::uint64_t kProductsOfWays = 16 * 2048;

/// Searches the design points of all limits from several directions (U8.1), and the ways to fail that 16 samples about them
/// show besides (U4.1).
/// @param problem  without variables, with one yield target
WaysToFail ways_to_fail(const RobustProblem& problem, const WaysOptions& options);

/// Products drawn about the ways to fail, U4.1: product i is point i / 16 of scramble i mod 16, whatever their number. Immutable,
/// safe for any number of threads.
class WeightedProducts {
 public:
  /// @param centres  those of WaysToFail
  WeightedProducts(std::size_t inputs, std::uint64_t seed,
                   std::vector<std::vector<double>> centres);

  /// z of a product.
  std::vector<double> normals(std::uint64_t index) const;
  /// Density of plain products at z over that of the drawn ones, N w of U4.2: at most 10.
  double weight(std::span<const double> z) const;
  /// The least number that is at least `products` and gives each scramble a power of two, at least 256.
  static std::uint64_t balanced(std::uint64_t products);

 private:
  std::vector<ScrambledSobol> scrambles_;
  std::vector<std::vector<double>> centres_;
};

}  // namespace twum::inline v0_1::optim
