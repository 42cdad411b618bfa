// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/earlier_result.hpp"

#include "results/stored_summary.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/expression.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

using Json = nlohmann::ordered_json;

EarlierDesign design_from(const Json& entries) {
  EarlierDesign design;
  for (const auto& [name, entry] : entries.items()) {
    const Json& value = entry.is_object() ? entry.value("value", Json()) : entry;
    const auto parameter = find_parameter(name);
    if (parameter && value.is_number()) design.emplace_back(*parameter, value.get<double>());
  }
  return design;
}

std::vector<EarlierDesign> designs_from(const Json& summary) {
  std::vector<EarlierDesign> designs;
  if (summary.contains("front")) {
    for (const Json& point : summary["front"]) designs.push_back(design_from(point.at("design")));
  } else if (summary.contains("best") && summary["best"].is_object()) {
    designs.push_back(design_from(summary["best"].at("design")));
  } else if (summary.contains("estimates")) {
    designs.push_back(design_from(summary["estimates"]));
  }
  std::erase_if(designs, [](const EarlierDesign& d) { return d.empty(); });
  return designs;
}

// How good a start is: broken limits first, then the goal; smaller is better.
std::pair<double, double> merit(const DesignProblem& problem, const EarlierDesign& design) {
  constexpr double kWorst = std::numeric_limits<double>::infinity();
  std::vector<MetricExpression> metrics{problem.objectives.front().metric};
  for (const MotorLimit& limit : problem.limits) metrics.push_back(limit.metric);
  std::vector<MetricValue> values(metrics.size());
  try {
    ExpressionEvaluator(metrics).evaluate(Motor(with(problem.motor, design)), values);
  } catch (const InputError&) {  // a design of another motor, whose values are not admissible here
    return {kWorst, kWorst};
  }
  double broken = 0;
  for (std::size_t i = 0; i < problem.limits.size(); ++i) {
    const MotorLimit& limit = problem.limits[i];
    if (values[i + 1].status != MetricStatus::ok) return {kWorst, kWorst};
    const double value = values[i + 1].value;
    const double end = limit.at_least(value) ? limit.lower : limit.upper;
    broken += limit.excess(value) / std::max(std::fabs(end), 1e-300);
  }
  constexpr double kRoom = 1e-6;  // an optimum violates its active limits by the solver's tolerance
  if (values[0].status != MetricStatus::ok) return {kWorst, kWorst};
  return {broken > kRoom ? broken : 0,
          (problem.objectives.front().maximize ? -1 : 1) * values[0].value};
}

}  // namespace

std::vector<EarlierDesign> earlier_designs(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "summary.json").string();
  if (!std::filesystem::exists(path))
    throw InputError("study.start: no result in " + studies::quoted(folder) +
                     "; expected the directory of a study that has been run");
  std::vector<EarlierDesign> designs;
  try {
    designs = from_summary(path, [&] { return designs_from(stored_summary(path)); });
  } catch (const StoreError&) {
    throw InputError("study.start: " + studies::quoted(path) +
                     " cannot be read; run that study again");
  }
  if (designs.empty())
    throw InputError("study.start: " + studies::quoted(path) +
                     " has no design; expected an optimize, size, pareto or calibrate study "
                     "that found one");
  return designs;
}

const EarlierDesign& best_start(const DesignProblem& problem,
                                const std::vector<EarlierDesign>& designs) {
  std::size_t best = 0;
  auto least = merit(problem, designs.front());
  for (std::size_t i = 1; i < designs.size(); ++i) {
    const auto next = merit(problem, designs[i]);
    if (next < least) {
      least = next;
      best = i;
    }
  }
  return designs[best];
}

}  // namespace twum::inline v0_1::studies
