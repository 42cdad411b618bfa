// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/statistics/distribution.hpp>
#include <twum/studies/text/value_error.hpp>

#include <cmath>
#include <optional>

namespace twum::studies {

/// How far a quantity scatters.
struct Spread {
  double amount{0};      ///< SI, or a share of the quantity
  bool relative{false};  ///< a share: typed with `%`

  /// In SI, of a quantity that is `centre` [SI].
  double of(double centre) const { return relative ? amount * std::fabs(centre) : amount; }
};

/// How a parameter scatters from motor to motor: about the design's own value unless `mean` or limits are given.
struct Tolerance {
  /// The shape of the distribution.
  enum class Shape : unsigned char { normal, uniform, lognormal, triangular };
  Parameter parameter{};        ///< which one
  Shape shape{};                ///< of the distribution
  std::optional<double> mean;   ///< stands for the design's value; SI
  std::optional<Spread> sd;     ///< normal, lognormal: standard deviation
  std::optional<Spread> range;  ///< uniform: to both sides
  std::optional<Spread> below;  ///< triangular: from the most likely value down
  std::optional<Spread> above;  ///< triangular: and up
  std::optional<double> min;    ///< uniform, triangular: instead, in SI whatever the design
  std::optional<double> mode;   ///< triangular
  std::optional<double> max;    ///< uniform, triangular

  /// What it scatters about if the design has `value`, SI: its mean, or the most likely value of a triangle.
  double centre(double value) const;
  /// The distribution if the design has `value` [SI], cut off at the parameter's admissible range. Draws of a parameter
  /// of whole numbers have to be rounded.
  Distribution distribution(double value) const;
};

/// Why a tolerance means nothing for a design with this value [SI], and what would be right; nothing if it does.
std::optional<ValueError> complaint(const Tolerance& tolerance, double value);

/// The words of Tolerance::Shape, in its order; static lifetime.
const char* to_string(Tolerance::Shape shape);

}  // namespace twum::studies
