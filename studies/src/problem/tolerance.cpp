// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/tolerance.hpp>

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// Largest share of a distribution that may lie outside the admissible range of its parameter, where no motor can be: a distribution
// with more is not the one of a part that is made.
constexpr double kMostOutside = 0.01;

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

std::optional<ValueError> weibull_complaint(const Tolerance& tolerance, double mean) {
  const std::string unit(info(tolerance.parameter).unit);
  const double ratio = mean > 0 ? tolerance.sd->of(mean) / mean : 0;
  if (ratio >= 1e-3 && ratio <= 10) return {};
  return ValueError(
      "a Weibull distribution about " + engineering(mean, unit) + " with a standard deviation of " +
          engineering(tolerance.sd->of(mean), unit),
      "the mean must be more than 0, and the deviation from 0.1 % to 10 times the mean");
}

// Of distributions between two ends of their own.
std::optional<ValueError> ends_complaint(const Tolerance& tolerance, double mean) {
  using Shape = Tolerance::Shape;
  if (tolerance.shape == Shape::weibull) return weibull_complaint(tolerance, mean);
  if (tolerance.shape != Shape::truncated && tolerance.shape != Shape::beta) return {};
  const std::string unit(info(tolerance.parameter).unit);
  const double from = *tolerance.from, to = *tolerance.to, sd = tolerance.sd->of(mean);
  const std::string between =
      "between " + engineering(from, unit) + " and " + engineering(to, unit);
  if (tolerance.shape == Shape::truncated) {
    const Distribution whole = Distribution::normal(mean, sd);
    if (whole.cdf(to) - whole.cdf(from) > 1e-6) return {};
    return ValueError("a normal distribution about " + engineering(mean, unit) +
                          " of which nothing lies " + between,
                      "expected ends about the mean");
  }
  if (mean > from && mean < to && sd * sd < (mean - from) * (to - mean)) return {};
  return ValueError("a beta distribution " + between + " with the mean " + engineering(mean, unit) +
                        " and the standard deviation " + engineering(sd, unit),
                    "the mean must lie between the ends, and the deviation be less than the root "
                    "of the product of its distances from them");
}

}  // namespace

double Tolerance::centre(double value) const {
  if (mode) return *mode;
  if (min && max) return 0.5 * (*min + *max);
  return mean.value_or(value);
}

Distribution Tolerance::distribution(double value) const {
  const double middle = centre(value);
  // Extends the range by 1/2 for integers, so that all have the same share after rounding.
  const double half = info(parameter).integer ? 0.5 : 0.0;
  switch (shape) {
    case Shape::normal: return Distribution::normal(middle, sd->of(middle));
    case Shape::lognormal: return Distribution::lognormal(middle, sd->of(middle));
    case Shape::triangular:
      return min ? Distribution::triangular(*min, middle, *max)
                 : Distribution::triangular(middle - below->of(middle), middle,
                                            middle + above->of(middle));
    case Shape::truncated: return Distribution::normal(middle, sd->of(middle)).within(*from, *to);
    case Shape::weibull: return Distribution::weibull(middle, sd->of(middle));
    case Shape::beta: return Distribution::beta(middle, sd->of(middle), *from, *to);
    case Shape::uniform: break;
  }
  return min ? Distribution::uniform(*min - half, *max + half)
             : Distribution::uniform(middle - range->of(middle) - half,
                                     middle + range->of(middle) + half);
}

double Tolerance::inadmissible(double value) const {
  const ParameterInfo& row = info(parameter);
  const double half = row.integer ? 0.5 : 0.0;
  const Distribution whole = distribution(value);
  return whole.cdf(row.min - half) + (1 - whole.cdf(row.max + half));
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
  if (auto wrong = ends_complaint(tolerance, centre)) return wrong;
  const double outside = tolerance.inadmissible(value);
  if (outside <= kMostOutside) return {};
  return ValueError(
      rounded_text(100 * outside, 3) + " % of the distribution lies outside the admissible range",
      "expected at most 1 %: a smaller spread, or a lognormal, triangular or truncated "
      "distribution, has less there");
}

std::vector<optim::CorrelatedPair> correlated_pairs(
    const std::vector<Tolerance>& tolerances,
    const std::vector<ToleranceCorrelation>& correlations) {
  const auto place = [&](Parameter parameter) {
    return static_cast<std::size_t>(
        std::ranges::find(tolerances, parameter, &Tolerance::parameter) - tolerances.begin());
  };
  std::vector<optim::CorrelatedPair> pairs;
  for (const ToleranceCorrelation& one : correlations)
    pairs.push_back({place(one.a), place(one.b), one.coefficient});
  return pairs;
}

const char* to_string(Tolerance::Shape shape) {
  switch (shape) {
    case Tolerance::Shape::normal: return "normal";
    case Tolerance::Shape::uniform: return "uniform";
    case Tolerance::Shape::lognormal: return "lognormal";
    case Tolerance::Shape::triangular: return "triangular";
    case Tolerance::Shape::truncated: return "truncated";
    case Tolerance::Shape::weibull: return "weibull";
    case Tolerance::Shape::beta: break;
  }
  return "beta";
}

}  // namespace twum::inline v0_1::studies
