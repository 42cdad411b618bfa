// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/tolerance.hpp>

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>

#include <cmath>

namespace twum::studies {
namespace {

// Largest share of a distribution that may lie outside the admissible range of its parameter. More
// than that would move mean and spread visibly away from those that were typed.
constexpr double kMostCutOff = 0.01;

// A relative spread has no meaning for a value of 0. A whole number rounds it away, so that nothing would vary.
std::optional<ValueError> meaningless_share(const Tolerance& tolerance, double centre) {
  const bool whole = info(tolerance.parameter).integer;
  for (const std::optional<Spread>& spread :
       {tolerance.sd, tolerance.range, tolerance.below, tolerance.above}) {
    if (!spread || !spread->relative || (centre != 0 && !whole)) continue;
    const std::string share = "found a spread of " + about(100 * spread->amount) + " % of ";
    if (whole)
      return ValueError(share + "a whole number",
                        "give the numbers it may have: {distribution: uniform, min: 8, max: 10}");
    return ValueError(share + "0", "give it with a unit, or the mean");
  }
  return {};
}

std::optional<ValueError> lognormal_complaint(const Tolerance& tolerance, double mean) {
  const std::string unit(info(tolerance.parameter).unit);
  if (!(mean > 0))
    return ValueError("a lognormal distribution about " + engineering(mean, unit),
                      "the mean must be more than 0");
  // Beyond these, the variance of the logarithm is lost in rounding, or infinite.
  const double ratio = tolerance.sd->of(mean) / mean;
  if (ratio >= 1e-7 && ratio <= 1e7) return {};
  return ValueError("a lognormal distribution about " + engineering(mean, unit) +
                        " with a standard deviation of " +
                        engineering(tolerance.sd->of(mean), unit),
                    "the deviation must be from 1e-7 to 1e7 times the mean");
}

}  // namespace

double Tolerance::centre(double value) const {
  if (mode) return *mode;
  if (min && max) return 0.5 * (*min + *max);
  return mean.value_or(value);
}

Distribution Tolerance::distribution(double value) const {
  const ParameterInfo& row = info(parameter);
  const double middle = centre(value);
  // Extends the range by 1/2 for integers, so that all have the same share after rounding.
  const double half = row.integer ? 0.5 : 0.0;
  const auto whole = [&] {
    switch (shape) {
      case Shape::normal: return Distribution::normal(middle, sd->of(middle));
      case Shape::lognormal: return Distribution::lognormal(middle, sd->of(middle));
      case Shape::triangular:
        return min ? Distribution::triangular(*min, middle, *max)
                   : Distribution::triangular(middle - below->of(middle), middle,
                                              middle + above->of(middle));
      case Shape::uniform: break;
    }
    return min ? Distribution::uniform(*min - half, *max + half)
               : Distribution::uniform(middle - range->of(middle) - half,
                                       middle + range->of(middle) + half);
  };
  return whole().within(row.min - half, row.max + half);
}

std::optional<ValueError> complaint(const Tolerance& tolerance, double value) {
  if (tolerance.parameter == Parameter::radial_slices)
    return ValueError(
        "the number of slices belongs to the computation, and motors do not differ in it",
        "leave it out");
  const double centre = tolerance.centre(value);
  if (std::isnan(centre))
    return ValueError("found a spread about the motor's own value, and this motor has none",
                      tolerance.parameter == Parameter::amplitude
                          ? "its wave follows from the voltage: vary that, or give a mean"
                          : "give a mean, or leave it out");
  if (auto wrong = meaningless_share(tolerance, centre)) return wrong;
  if (tolerance.shape == Tolerance::Shape::lognormal)
    if (auto wrong = lognormal_complaint(tolerance, centre)) return wrong;
  const double cut_off = tolerance.distribution(value).cut_off();
  if (cut_off <= kMostCutOff) return {};
  return ValueError(
      rounded_text(100 * cut_off, 3) + " % of the distribution lies outside the admissible range",
      "at most 1 % may be cut off: a smaller spread, or a lognormal or triangular "
      "distribution, has less there");
}

const char* to_string(Tolerance::Shape shape) {
  switch (shape) {
    case Tolerance::Shape::normal: return "normal";
    case Tolerance::Shape::uniform: return "uniform";
    case Tolerance::Shape::lognormal: return "lognormal";
    case Tolerance::Shape::triangular: break;
  }
  return "triangular";
}

}  // namespace twum::studies
