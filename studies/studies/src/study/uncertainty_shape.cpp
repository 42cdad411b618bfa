// SPDX-License-Identifier: Apache-2.0
#include "study/entry_shapes.hpp"
#include "study/repeats.hpp"

#include <twum/studies/text/number.hpp>
#include <twum/studies/text/words.hpp>

#include <cmath>
#include <limits>

namespace twum::studies {

namespace {

double half_step(Parameter parameter) { return info(parameter).integer ? 0.5 : 0.0; }

}  // namespace

Distribution UncertainVariable::distribution() const {
  const ParameterInfo& row = info(parameter);
  const double half = half_step(parameter);
  const auto whole = [&] {
    switch (shape) {
      case Shape::normal: return Distribution::normal(mean, sd);
      case Shape::lognormal: return Distribution::lognormal(mean, sd);
      case Shape::triangular: return Distribution::triangular(min, mode, max);
      case Shape::uniform: break;
    }
    // Whole numbers: each has the same share once draws are rounded.
    return Distribution::uniform(min - half, max + half);
  };
  return whole().within(row.min - half, row.max + half);
}

using namespace shapes;

namespace {

// Largest share of a distribution that may lie outside the admissible range of its parameter. More
// than that would move mean and spread visibly away from those that were typed.
constexpr double kMostCutOff = 0.01;

constexpr const char* kTolerances =
    "preload: {distribution: normal, mean: 160 N, sd: 8 N}\n"
    "kinetic_friction: {distribution: uniform, min: 0.17, max: 0.23}";

// A standard deviation has the parameter's unit but not its range: more than 0.
Shape<double> spread_of(const ParameterInfo& row) {
  Schema schema = value_of(row).schema;
  schema.text = "standard deviation";
  schema.min = 0;
  schema.min_excluded = true;
  schema.whole = false;
  return number(std::move(schema));
}

bool check_lognormal(const UncertainVariable& value, const Given& given, Diagnostics& diagnostics) {
  const YamlNode& mean = *given.find("mean");
  if (!(value.mean > 0)) {
    diagnostics.add(mean.mark, given.path("mean"),
                    quoted(mean.scalar) + " as the mean of a lognormal distribution",
                    "must be more than 0");
    return false;
  }
  // Beyond, the variance of the logarithm is lost in rounding, or infinite.
  const double ratio = value.sd / value.mean;
  if (ratio >= 1e-7 && ratio <= 1e7) return true;
  diagnostics.add(mean.mark, given.path("mean"),
                  quoted(mean.scalar) + " with a standard deviation of " +
                      quoted(given.find("sd")->scalar) + ", of a lognormal distribution",
                  "the deviation must be from 1e-7 to 1e7 times the mean");
  return false;
}

// What only a look at the whole distribution shows.
bool check_numbers(const UncertainVariable& value, const Given& given, Diagnostics& diagnostics) {
  const auto both = [&](const char* a, const char* b) {
    return given.right(a) != nullptr && given.right(b) != nullptr;
  };
  bool good = true;
  if (value.shape == UncertainVariable::Shape::normal) return both("mean", "sd");
  if (value.shape == UncertainVariable::Shape::lognormal)
    return !std::isnan(value.mean) && !std::isnan(value.sd) &&
           check_lognormal(value, given, diagnostics) && both("mean", "sd");
  if (both("min", "max")) good = rising(given, "min", value.min, "max", value.max, diagnostics);
  if (value.shape == UncertainVariable::Shape::uniform) return good && both("min", "max");
  if (both("min", "mode"))
    good = rising(given, "min", value.min, "mode", value.mode, diagnostics) && good;
  if (both("mode", "max"))
    good = rising(given, "mode", value.mode, "max", value.max, diagnostics) && good;
  return good && both("min", "max") && both("mode", "max");
}

Shape<UncertainVariable> uncertain(const ParameterInfo& row) {
  using V = UncertainVariable;
  const Shape<double> value = value_of(row);
  const Shape<double> spread = spread_of(row);
  const auto one = [&](const char* name, V::Shape kind, std::vector<Field<V>> fields) {
    fields.insert(fields.begin(), selector<V>("distribution", "its shape", name));
    V fresh;
    fresh.shape = kind;
    fresh.parameter = row.parameter;
    fresh.mean = fresh.sd = std::numeric_limits<double>::quiet_NaN();  // not read
    return mapping<V>(
        "", std::move(fields),
        [](V& into, const Given& given, Diagnostics& diagnostics) {
          if (!check_numbers(into, given, diagnostics)) return false;
          const double cut_off = into.distribution().cut_off();
          if (cut_off <= kMostCutOff) return true;
          diagnostics.add(
              given.node().mark, given.path(),
              rounded_text(100 * cut_off, 3) +
                  " % of the distribution lies outside the admissible range",
              "at most 1 % may be cut off: a smaller spread, or a lognormal or triangular "
              "distribution, has less there");
          return false;
        },
        fresh);
  };
  const auto mean = needed<V>("mean", value, &V::mean);
  const auto sd = needed<V>("sd", spread, &V::sd);
  const auto min = needed<V>("min", value, &V::min);
  const auto max = needed<V>("max", value, &V::max);
  const auto mode = needed<V>("mode", value, &V::mode);
  return one_of<V>(
      std::string(row.text),
      {one("normal", V::Shape::normal, {mean, sd}), one("uniform", V::Shape::uniform, {min, max}),
       one("lognormal", V::Shape::lognormal, {mean, sd}),
       one("triangular", V::Shape::triangular, {min, mode, max})},
      [](const V& v) { return static_cast<std::size_t>(v.shape); }, "distribution",
      {"normal", "uniform", "lognormal", "triangular"});
}

// Probabilities stand in the list once each; 5 % is 0.05.
bool check_uncertainty(UncertaintyStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_repeats(given, diagnostics);
  if (const YamlNode* list = given.right("quantiles")) {
    Repeats repeats(given.path("quantiles"), "leave one of them out", diagnostics);
    for (std::size_t i = 0; i < list->items.size(); ++i)
      repeats.see(list->items[i], number_text(study.quantiles[i]));
  }
  return true;
}

}  // namespace

Shape<UncertaintyStudy> UncertaintyStudy::shape() {
  using S = UncertaintyStudy;
  auto quantiles = list("probabilities", fraction("a probability", "0.05"));
  quantiles.schema.example = "[0.05, 0.5, 0.95]";
  return mapping<S>(
      "spread and yield under tolerances",
      {kind_field<S>(),
       needed<S>("variables",
                 by_parameter<UncertainVariable>(uncertain, "what is uncertain", kTolerances),
                 &S::variables),
       needed<S>("metrics", shapes::metrics(), &S::metrics),
       standard<S>("samples", shapes::samples(), &S::samples),
       optional<S>("limits", shapes::constraints(), &S::limits, "no yield"),
       standard<S>("quantiles", quantiles, &S::quantiles),
       standard<S>("seed", shapes::seed(), &S::seed),
       hidden(
           optional<S>("start",
                       path("result directory of another study, whose best design or fitted motor "
                            "is varied",
                            "results/first"),
                       &S::start, "the motor as it is"))},
      check_uncertainty);
}

}  // namespace twum::studies
