// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// @file
/// Distributions behind intervals and tests, to about 1e-14, also in a tail. Probabilities lie between 0 and 1; degrees of freedom
/// need not be whole, and lie between 1e-3 and 1e15; draws are at most 1e15.
/// An argument outside its range, or NaN, gives NaN.

namespace twum::inline v0_1::optim {

/// The density of a standard normal number.
double normal_density(double x);
/// Probability that a standard normal number is below x.
double normal_cdf(double x);
/// The p-quantile of a standard normal number; infinite at 0 and 1.
double normal_quantile(double p);
/// P(Z1 <= h, Z2 <= k) of standard normal numbers with correlation rho, to about 1e-14; arguments may be infinite.
double normal_cdf(double h, double k, double rho);

/// The p-quantile of Student's t.
/// @param freedom  beyond 1e15: a standard normal number
double student_quantile(double freedom, double p);
/// Probability that Student's t is at least t away from zero.
/// @param freedom  as above
/// @param t        >= 0
double student_tails(double freedom, double t);

/// The p-quantile of chi-square.
double chi_square_quantile(double freedom, double p);
/// Probability that chi-square is at least x.
/// @param freedom  0 gives 1
/// @param x        >= 0
double chi_square_tail(double freedom, double x);

/// The p-quantile of Fisher's F.
/// @param above, below  degrees of freedom of the two variances
double fisher_quantile(double above, double below, double p);

/// Probability of at most `count` hits in so many independent draws.
/// @param p  of a hit
double binomial_cdf(double draws, double p, double count);
/// The smallest count of hits with binomial_cdf() >= level.
/// @param level  inside (0, 1)
double binomial_quantile(double draws, double p, double level);

/// Ends of an interval for a probability.
struct ProbabilityRange {
  double low;   ///< 0 without a hit
  double high;  ///< 1 if all are hits
};
/// The interval of Clopper and Pearson for the probability of what occurred `hits` times in independent draws: beyond each of its
/// ends lies no more than `tail`.
/// @param hits   at most `draws`
/// @param draws  > 0
ProbabilityRange probability_range(std::uint64_t hits, std::uint64_t draws, double tail);

}  // namespace twum::inline v0_1::optim
