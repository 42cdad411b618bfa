// SPDX-License-Identifier: Apache-2.0
#include "entries/repeats.hpp"
#include "entries/robust_shapes.hpp"
#include "entries/tolerance_shape.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

// What weighted motors about the ways to fail cannot answer.
void check_importance(const UncertaintyStudy& study, const Given& given, Diagnostics& diagnostics) {
  const auto refuse = [&](const YamlNode& at, const std::string& name, std::string found,
                          std::string expected) {
    diagnostics.add(at.mark, given.path(name), std::move(found), std::move(expected));
  };
  const std::string with = "given with method 'importance'";
  if (given.find("limits") == nullptr)
    refuse(given.node(), "limits", "missing",
           "give 'limits': method 'importance' computes the share of motors that violate them");
  if (const YamlNode* parts = given.find("parts"))
    refuse(*parts, "parts", with,
           "a table of measured parts is too short for rare failures: leave it out and give the "
           "distributions of the parameters, or use method 'plain'");
  if (const YamlNode* metrics = given.find("metrics"))
    refuse(*metrics, "metrics", with,
           "motors drawn near their limits do not show how a metric scatters: leave it out, or use "
           "method 'plain'");
  const YamlNode* quantiles = given.find("quantiles");
  if (quantiles != nullptr && study.quantiles != UncertaintyStudy{}.quantiles)
    refuse(*quantiles, "quantiles", with, "leave it out, or use method 'plain'");
  const YamlNode* variables = given.find("variables");
  for (const Tolerance& one : study.variables) {
    if (!info(one.parameter).integer || variables == nullptr) continue;
    for (const YamlEntry& entry : variables->entries)
      if (find_parameter(entry.key) == one.parameter)
        refuse(entry.value, "variables." + entry.key, "a whole number, with method 'importance'",
               "its distribution has steps, but the search for failures needs derivatives: leave "
               "it out, or use method 'plain'");
  }
}

// Each probability may occur only once; 5 % equals 0.05.
bool check_uncertainty(UncertaintyStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_repeats(given, diagnostics);
  if (given.find("variables") == nullptr && given.find("parts") == nullptr)
    diagnostics.add(given.node().mark, given.path("variables"), "missing",
                    "give 'variables' with their tolerances, or 'parts' that were measured");
  check_correlations(study.variables, study.correlations, given, "variables", diagnostics);
  if (study.method == DrawMethod::importance)
    check_importance(study, given, diagnostics);
  else if (given.find("metrics") == nullptr && given.find("limits") == nullptr)
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
                   "none; only the parts scatter"),
       hidden(optional<S>("correlations", shapes::correlations(), &S::correlations, "none")),
       parts_field<S>(), derived_field<S>(),
       hidden(standard<S>(
           "method",
           word<DrawMethod>(
               "plain: motors are drawn from their tolerances; importance: also near the points "
               "where they are most likely to fail, for failure shares down to 1e-9",
               {DrawMethod::plain, DrawMethod::importance}),
           &S::method)),
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

const char* to_string(DrawMethod value) noexcept {
  switch (value) {
    case DrawMethod::plain: return "plain";
    case DrawMethod::importance: return "importance";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::studies
