// SPDX-License-Identifier: Apache-2.0
#include "entries/repeats.hpp"
#include "entries/tolerance_shape.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

namespace twum::studies {

using namespace shapes;

namespace {

// Each probability may occur only once; 5 % equals 0.05.
bool check_uncertainty(UncertaintyStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_repeats(given, diagnostics);
  if (given.find("variables") == nullptr && given.find("parts") == nullptr)
    diagnostics.add(given.node().mark, given.path("variables"), "missing",
                    "give 'variables' with their tolerances, or 'parts' that were measured");
  check_correlations(study.variables, study.correlations, given, "variables", diagnostics);
  if (given.find("metrics") == nullptr && given.find("limits") == nullptr)
    diagnostics.add(given.node().mark, given.path("metrics"), "missing",
                    "give 'metrics' to compute their spread, or 'limits' to compute the yield");
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
       optional<S>("variables", tolerances("what is uncertain"), &S::variables,
                   "none; parts scatter"),
       hidden(optional<S>("correlations", shapes::correlations(), &S::correlations, "none")),
       hidden(optional<S>("parts",
                          path("table of measured parts, which are drawn whole, with a column for "
                               "each of their parameters and if need be 'weight'",
                               "parts.csv"),
                          &S::parts, "none")),
       derived_field<S>(),
       optional<S>("metrics", shapes::metrics(), &S::metrics, "those of the limits"),
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
