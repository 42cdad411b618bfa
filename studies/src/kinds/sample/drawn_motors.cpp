// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/drawn_motors.hpp"

#include "entries/tolerance_shape.hpp"
#include "kinds/sample/found_motors.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

std::vector<DrawnVariable> drawn_variables(const std::vector<Tolerance>& asked,
                                           const MotorDesign& design) {
  std::vector<DrawnVariable> variables;
  for (const Tolerance& one : asked) {
    const double value = get(design, one.parameter);
    if (const auto wrong = complaint(one, value))
      throw InputError("study.variables." + std::string(info(one.parameter).name) + ": " +
                       wrong->what());
    variables.push_back({one.parameter, one.distribution(value), one.inadmissible(value),
                         one.shape == Tolerance::Shape::normal});
  }
  return variables;
}

// Adds the metrics of limits that are not yet in the list.
std::vector<LimitPlace> place_limits(const std::vector<MotorLimit>& limits,
                                     std::vector<MetricExpression>& metrics) {
  std::vector<LimitPlace> places;
  for (const MotorLimit& limit : limits) {
    const auto found = std::find_if(
        metrics.begin(), metrics.end(),
        [&](const MetricExpression& metric) { return metric.text == limit.metric.text; });
    places.push_back({limit, static_cast<std::size_t>(found - metrics.begin())});
    if (found == metrics.end()) metrics.push_back(limit.metric);
  }
  return places;
}

// The values of an earlier study's best design; none if the motor of the file is varied.
EarlierDesign start_design(const StudyFile& file, const std::string& start) {
  if (start.empty()) return {};
  const auto designs = earlier_designs((std::filesystem::path(file.folder) / start).string());
  if (designs.size() != 1) {
    throw InputError("study.start: '" + start + "' holds a front of " +
                     std::to_string(designs.size()) +
                     " designs; tolerances are those of one motor: name one of its motor files "
                     "instead, such as 'motor: " +
                     start + "/" + front_file(1, designs.size()) + "'");
  }
  return designs.front();
}

PartsTable measured_parts(const StudyFile& file, const UncertaintyStudy& asked,
                          const MotorDesign& design) {
  PartsTable table = read_parts(asked.parts, file.folder, design);
  for (const Tolerance& one : asked.variables) check_apart(table, one.parameter, "variables");
  return table;
}

std::vector<Parameter> drawn_parameters(const std::vector<DrawnVariable>& variables,
                                        const MeasuredParts& parts) {
  std::vector<Parameter> list = parameters_of(variables);
  list.insert(list.end(), parts.parameters.begin(), parts.parameters.end());
  return list;
}

// The name of what a path leads to. The path itself is another one in the folder of the results.
std::string last_name(const std::string& path) {
  const auto normal = std::filesystem::path(path + "/").lexically_normal();
  return normal.parent_path().filename().string();
}

// What tells the varied motor from others: the varied parameters and those of the earlier design.
std::vector<Parameter> nominal_parameters(const UncertaintyStudy& asked,
                                          const EarlierDesign& start) {
  std::vector<Parameter> list = parameters_of(asked.variables);
  for (const auto& [parameter, value] : start)
    if (std::find(list.begin(), list.end(), parameter) == list.end()) list.push_back(parameter);
  return list;
}

// A share that is known no better says nothing.
constexpr double kKnown = 0.25;

std::vector<Estimate> known_causes(const optim::FailureShares& shares, double confidence) {
  std::vector<Estimate> causes = shares.causes(confidence);
  const bool known = std::ranges::all_of(
      causes, [](const Estimate& share) { return share.high - share.value <= kKnown; });
  return known ? causes : std::vector<Estimate>{};
}

}  // namespace

DrawnMotors::DrawnMotors(const UncertaintyStudy& asked, const StudyFile& file)
    : start_(start_design(file, asked.start)),
      design_(with(file.motor.design, start_)),
      tolerances_(asked.variables),
      variables_(drawn_variables(asked.variables, design_)),
      correlation_(asked.variables.size(), correlated_pairs(asked.variables, asked.correlations)),
      table_(measured_parts(file, asked, design_)),
      metrics_(with_derived(asked.metrics, asked.derived)),
      limits_(place_limits(asked.limits, metrics_)),
      varied_(design_, drawn_parameters(variables_, table_.parts), asked.derived),
      evaluator_(varied_, metrics_),
      seed_(asked.seed),
      start_name_(last_name(asked.start)),
      nominal_(nominal_parameters(asked, start_)) {}

std::vector<std::string> DrawnMotors::notes() const {
  return table_.notes_after(shapes::tolerance_notes(tolerances_, design_));
}

UncertaintyResult DrawnMotors::frame() const {
  UncertaintyResult result;
  result.parts = table_.name;
  result.part_count = table_.parts.rows.size();
  result.confidence = kConfidence;
  result.start = start_name_;
  for (const Parameter parameter : nominal_)
    result.nominal.push_back({std::string(info(parameter).name), std::string(info(parameter).unit),
                              get(design_, parameter)});
  const std::vector<StoredColumn> all = evaluator_.columns();
  const auto metrics = all.begin() + static_cast<std::ptrdiff_t>(varied_.varied().size());
  result.variables.assign(all.begin(), metrics);
  for (auto column = metrics; column != all.end(); ++column) {
    result.metrics.emplace_back();
    result.metrics.back().column = *column;
  }
  for (std::size_t j = 0; j < variables_.size(); ++j)
    if (variables_[j].inadmissible > 1e-12)  // less is within rounding of the probabilities
      result.inadmissible.push_back({result.variables[j].name, variables_[j].inadmissible});
  for (const LimitPlace& place : limits_)
    result.limits.push_back(
        {place.limit.text, place.limit.metric.text, place.limit.lower, place.limit.upper});
  return result;
}

DrawnMotors::Broken DrawnMotors::nothing_broken() const {
  const optim::FailureShares none(variables_.size());
  return {none, std::vector(limits_.size(), none)};
}

void DrawnMotors::count(Broken& broken, std::uint64_t index, double weight, const double* metrics,
                        const std::function<std::vector<double>()>& normals) const {
  std::vector<double> parts;  // of independent normal numbers; none of measured parts alone
  bool fails = false;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (limits_[i].limit.holds(metrics[limits_[i].metric])) {
      broken.of_limit[i].add(index);
      continue;
    }
    if (!fails) parts = correlation_.parts(normals());
    fails = true;
    broken.of_limit[i].add_failing(index, weight, parts);
  }
  if (fails)
    broken.any.add_failing(index, weight, parts);
  else
    broken.any.add(index);
}

// Measured parts are drawn whole and have no normal numbers: what fails because of them is not known.
void DrawnMotors::tell_causes(const Broken& broken, UncertaintyResult& result) const {
  if (!table_.parts.rows.empty()) return;
  for (std::size_t i = 0; i < limits_.size(); ++i)
    result.limits[i].causes = known_causes(broken.of_limit[i], kConfidence);
  result.causes = known_causes(broken.any, kConfidence);
  for (std::size_t k = 0; k < variables_.size(); ++k)
    result.tighter.push_back(variables_[k].normal ? broken.any.tighter(k, kConfidence)
                                                  : Estimate{});
}

}  // namespace twum::inline v0_1::studies
