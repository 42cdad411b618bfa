// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>
#include <twum/io/value_error.hpp>
#include <twum/optim/correlation.hpp>
#include <twum/studies/distribution.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// How far a quantity scatters.
struct Spread {
  double amount{0};      ///< SI, or a share of the value
  bool relative{false};  ///< `amount` is a share of the value, typed with `%`

  /// The spread in SI about the value `centre` [SI].
  double of(double centre) const { return relative ? amount * std::fabs(centre) : amount; }
};

/// How a parameter scatters from motor to motor: about the design's own value unless `mean` or limits are given.
struct Tolerance {
  /// The shape of the distribution.
  enum class Shape : unsigned char {
    normal,
    uniform,
    lognormal,
    triangular,
    truncated,  ///< normal, without what lies beyond `from` and `to`
    weibull,
    beta
  };
  Parameter parameter{};          ///< which one
  Shape shape{};                  ///< of the distribution
  std::optional<double> mean{};   ///< replaces the design's value; SI
  std::optional<Spread> sd{};     ///< standard deviation, but of uniform and triangular ones
  std::optional<Spread> range{};  ///< uniform: half width
  std::optional<Spread> below{};  ///< triangular: width below the most likely value
  std::optional<Spread> above{};  ///< triangular: width above it
  std::optional<double> min{};    ///< uniform, triangular: absolute limit instead of a width, SI
  std::optional<double> mode{};   ///< triangular
  std::optional<double> max{};    ///< uniform, triangular
  std::optional<double> from{};   ///< truncated, beta: lower end, SI
  std::optional<double> to{};     ///< truncated, beta: upper end, SI

  /// The centre of the distribution if the design has `value`, SI: the mean, or the most likely value of a triangular
  /// one.
  double centre(double value) const;
  /// The distribution if the design has `value` [SI]. The caller rounds draws of an integer parameter.
  Distribution distribution(double value) const;
  /// Share of it that no motor can have: what lies beyond the admissible range of the parameter.
  double inadmissible(double value) const;
};

/// Two parameters that scatter together, such as those of one batch: a normal copula. For two normal distributions the
/// coefficient is that of their values.
struct ToleranceCorrelation {
  Parameter a{};          ///< one of them
  Parameter b{};          ///< the other
  double coefficient{0};  ///< in (-1, 1)
};

/// The correlations as pairs of positions in a list of tolerances; a parameter that has none is the position behind the last.
std::vector<optim::CorrelatedPair> correlated_pairs(
    const std::vector<Tolerance>& tolerances,
    const std::vector<ToleranceCorrelation>& correlations);

/// Why a tolerance is not valid for a design with this value [SI], and what would be right, if it is not.
std::optional<ValueError> complaint(const Tolerance& tolerance, double value);

/// The words of Tolerance::Shape, in its order; static lifetime.
const char* to_string(Tolerance::Shape shape);

}  // namespace twum::inline v0_1::studies
