// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/replicates.hpp>
#include <twum/optim/scrambled_sobol.hpp>
#include <twum/studies/estimate.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// Points at which a function is evaluated for its Sobol indices: blocks of d + 2 points in (0, 1)^d. Points 0 and 1
/// of a block, A and B, are independent; point 2 + j is A with coordinate j from B. Consecutive blocks come from
/// kReplicates randomizations of one Sobol sequence in 2 d dimensions in turn.
class SobolDesign {
 public:
  /// Independent randomizations of the sequence.
  static constexpr std::uint64_t kReplicates = 4;

  /// @throws InputError as optim::ScrambledSobol, for twice as many dimensions as variables
  SobolDesign(std::size_t variables, std::uint64_t seed);

  /// Variables of the function, d.
  std::size_t variables() const noexcept { return variables_; }
  /// Points of a block, d + 2.
  std::size_t block_size() const noexcept { return variables_ + 2; }
  /// The least power of two that is at least `blocks` and gives each replicate at least 64 points. Other numbers of
  /// blocks are not evenly spread.
  static std::uint64_t balanced(std::uint64_t blocks);

  /// One point of a block; `unit` has room for d numbers. Safe from any number of threads.
  void point(std::uint64_t block, std::size_t member, std::span<double> unit) const;

 private:
  std::size_t variables_;
  std::vector<optim::ScrambledSobol> replicates_;
};

/// Shares of one variable in the variance of a function.
struct SobolShares {
  Estimate first;  ///< share explained by the variable alone; an estimate near 0 may be negative
  Estimate total;  ///< share of the variable with all its interactions
  Estimate interactions;  ///< their difference; there are interactions if its interval lies above 0
  /// E[(df/du)^2] / (pi^2 V), an upper bound of the total index for a uniform u (Sobol and Kucherenko 2009); NaN
  /// without derivatives
  Estimate derivative_bound;
};

/// First and total indices of a function of independent uniform variables, from its values on the
/// blocks of a SobolDesign: the estimators of Saltelli et al. (2010) and Jansen (1999), and for first indices above a half that
/// of Janon et al. (2014), which is then more accurate.
///
/// An index is a ratio of sums over all blocks. Its interval follows from the scatter of the replicates about that
/// ratio, with Student's t of 3 degrees of freedom. Replicates are independent, but the points of one sequence are
/// not, so a bootstrap over points would be wrong. Few long sequences are more accurate than many short ones
/// (docs/validation.md, which has the coverage too).
class SobolIndices {
 public:
  /// For a function of so many variables, without blocks yet. Not thread-safe.
  explicit SobolIndices(std::size_t variables);

  /// Adds the values at the points of a block. A value that is NaN drops the whole block, because the sums must be
  /// taken over the same blocks.
  /// @return true if the block was used
  bool add(std::uint64_t block, std::span<const double> values);
  /// Adds the derivatives by the coordinates at the first point of a block that was used. The bound is NaN unless
  /// every used block has its derivatives.
  void add_gradient(std::uint64_t block, std::span<const double> gradient);

  /// Blocks that were used.
  std::uint64_t blocks() const noexcept { return blocks_; }
  /// Blocks that were dropped.
  std::uint64_t dropped() const noexcept { return dropped_; }
  /// Mean of the function over the box; NaN without blocks.
  double mean() const;
  /// Its variance over the box; NaN without blocks.
  double variance() const;
  /// True if the values are equal up to rounding errors, so that there is no variance.
  bool constant() const;

  /// One entry for each variable; all NaN if there is no variance or fewer than 2 replicates.
  std::vector<SobolShares> shares(double confidence) const;

 private:
  // Sums over the blocks of one replicate, of values minus shift_.
  struct Sums {
    double count{0};
    double value{0};                  // (A + B) / 2
    double square{0};                 // (A^2 + B^2) / 2
    std::vector<double> step;         // C - A
    std::vector<double> product;      // B (C - A)
    std::vector<double> half_square;  // (A - C)^2 / 2
    double b{0}, b_square{0};         // B and B^2
    std::vector<double> c, c_square;  // C and C^2
    std::vector<double> b_c;          // B C
    double gradients{0};              // number of gradients
    std::vector<double> slope;        // (df/du)^2
  };
  double centre() const;
  double variance_sum(const Sums& sums) const;
  std::vector<optim::ReplicateSums> saltelli(std::size_t variable) const;
  std::vector<optim::ReplicateSums> janon(std::size_t variable) const;
  std::vector<optim::ReplicateSums> jansen(std::size_t variable) const;
  std::vector<optim::ReplicateSums> slope_bound(std::size_t variable) const;
  std::vector<const Sums*> filled() const;

  std::size_t variables_;
  std::vector<Sums> replicates_;
  double shift_{0};
  std::uint64_t blocks_{0};
  std::uint64_t dropped_{0};
};

/// The widest of the intervals of first and total indices; infinite if one is NaN.
double widest(std::span<const SobolShares> shares);

}  // namespace twum::inline v0_1::studies
