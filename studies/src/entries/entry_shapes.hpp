// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>
#include <twum/io/shape.hpp>
#include <twum/studies/study.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Entries that several kinds of study have; internal.
namespace twum::inline v0_1::studies::shapes {

/// Variables in a template.
inline constexpr const char* kRanges =
    "amplitude: {min: 0.8 um, max: 2.2 um}\n"
    "preload: {min: 60 N, max: 300 N}\n"
    "thickness: {min: 0.1 mm, max: 1 mm, scale: log}";

/// `kind:` with the word for a study of type S.
template <typename S>
Field<S> kind_field() {
  return selector<S>("kind", "what the study asks", std::string(S::kName));
}

Shape<MetricExpression> metric(std::string text, std::string example = "peak_power");
Shape<std::vector<MetricExpression>> metrics();
Shape<std::vector<MotorLimit>> constraints();

/// A limit with an own tolerance: {limit: ..., tolerance: ...}.
Shape<MotorLimit> tolerant_limit();
Shape<std::uint64_t> samples();
Shape<std::uint64_t> seed();
Shape<std::string> folder();  ///< result directory of another study
/// A value of the parameter, in its unit and range. The text says what the value is for, such as "smallest value".
Shape<double> value_of(const ParameterInfo& parameter, std::string text);
inline constexpr const char* kSmallestValue = "smallest value";
inline constexpr const char* kLargestValue = "largest value";
Shape<optim::Scale> spacing();  ///< linear or log

/// {torque, speed}; its text is the limit torque_at(SPEED) >= TORQUE as typed.
Shape<DutyPoint> duty_point();

/// `torque` and `speed` of a load that a study S may have: one of them, both, or none.
template <typename S>
Fields<S> load_fields() {
  return {
      optional<S>("torque", quantity("load torque", "N.m", "0.5 N.m"), &S::torque,
                  "none; with a speed: the torque of the drive at that speed"),
      optional<S>("speed",
                  quantity("rotor speed; given with a torque: the drive is adjusted to hold both",
                           "rad/s", "60 rpm"),
                  &S::speed, "the speed under the torque")};
}
/// A torque is held at a speed of more than 0.
void check_held(const Given& given, const std::optional<double>& torque,
                const std::optional<double>& speed, Diagnostics& diagnostics);

/// The values of one parameter.
Shape<CurveStudy::Family> family(const char* example);

/// A metric or a statistic to maximize or minimize.
Shape<DesignObjective> wanted(std::string text, bool maximize, std::string example = "peak_power");

/// {maximize: METRIC} or {minimize: METRIC}, or a statistic: two fields of which one is needed.
template <typename T>
Fields<T> goal(DesignObjective T::*member) {
  const auto field = [member](const char* name, const char* text, const char* alternative,
                              bool maximize) {
    Field<T> one = required<T>(name, wanted(text, maximize), member);
    one.entry.required = maximize;
    one.entry.alternative_entry = alternative;
    one.write = [write = one.write, member, maximize](const T& from) {
      return (from.*member).maximize == maximize ? write(from) : std::nullopt;
    };
    return one;
  };
  return {field("maximize",
                "what to maximize: a metric, or under tolerances a statistic such as "
                "mean(peak_power) or yield",
                "minimize", true),
          field("minimize", "what to minimize: a metric, or under tolerances a statistic",
                "maximize", false)};
}

/// Adds errors on the number of parameters in a mapping.
using CountCheck = void (*)(const YamlNode& node, const Spot& spot, Diagnostics& diagnostics);
void needs_one(const YamlNode& node, const Spot& spot, Diagnostics& diagnostics);

ErasedShape erased_by_parameter(const std::function<ErasedShape(const ParameterInfo&)>& shape_of,
                                std::string text, std::string sample, CountCheck check_count,
                                const ErasedList& list, Parameter& (*parameter_of)(void* item));

/// A mapping from parameters, by name or symbol, to something whose shape depends on the parameter.
/// V has a member `parameter`.
/// @param sample  lines for a template
template <typename V, typename ShapeOf>
Shape<std::vector<V>> by_parameter(ShapeOf shape_of, std::string text, std::string sample,
                                   CountCheck check_count = needs_one) {
  return Shape<std::vector<V>>::from(erased_by_parameter(
      [&](const ParameterInfo& row) { return shape_of(row).erased(); }, std::move(text),
      std::move(sample), check_count, erased_list<V>(),
      [](void* item) -> Parameter& { return static_cast<V*>(item)->parameter; }));
}

/// {min, max, scale, start} of each parameter.
Shape<std::vector<DesignVariable>> variables(std::string text, std::string sample);

/// Parameters that follow from the variables, each as an expression.
Shape<std::vector<DerivedParameter>> derived();
/// The entry `derived` of a study S.
template <typename S>
Field<S> derived_field() {
  return hidden(optional<S>("derived", derived(), &S::derived, "none"));
}

/// A parameter and the value that replaces the motor's.
struct Override {
  Parameter parameter{};
  double value{0};
};
Shape<std::vector<Override>> overrides();

/// @name Checks of several entries, each of which says what it finds
/// @{
/// low < high, or low <= high where one of them is the mode; both right.
bool rising(const Given& given, const char* low, double low_value, const char* high,
            double high_value, Diagnostics& diagnostics);
/// A logarithmic scale needs min > 0.
void check_log(const Given& given, double min, Diagnostics& diagnostics);
/// Columns and limits may occur only once in a list.
void check_repeats(const Given& given, Diagnostics& diagnostics);
/// @}

}  // namespace twum::inline v0_1::studies::shapes
