// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/measured_fit.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// A derivative that a residual may have.
void require_value(const MetricDerivative& found, const std::string& name) {
  if (found.value.status != MetricStatus::ok)
    throw EvaluationError(name + ": " + to_string(found.value.status), "no " + name);
  if (found.smoothness == Smoothness::undefined)
    throw EvaluationError(name + ": no derivative", "no derivative");
}

// Name of a reading in failures; "torque" for torque_at.
std::string failure_name(const Reading& reading) {
  const std::string name(name_of(reading));
  return name == "torque_at" ? "torque" : name;
}

std::vector<double> picked(std::span<const double> values, const std::vector<std::size_t>& places) {
  std::vector<double> list;
  for (const std::size_t j : places) list.push_back(values[j]);
  return list;
}

}  // namespace

std::string FitParameter::name() const {
  return std::string(info(parameter).name) + (table ? " (" + file + ")" : "");
}

double FitParameter::part(double a, double b) const {
  return scale == optim::Scale::log ? std::log(b / a) / std::log(max / min) : (b - a) / (max - min);
}

double FitParameter::between(double a, double b, double share) const {
  const double value =
      scale == optim::Scale::log ? a * std::pow(b / a, share) : std::lerp(a, b, share);
  return std::clamp(value, min, max);
}

// Sorts points by their conditions and readings, each found by its key.
class MeasuredFit::Sorter {
 public:
  Sorter(MeasuredFit& fit, const std::vector<DerivedParameter>& derived)
      : fit_(fit), derived_(derived) {}

  void add(std::size_t point) {
    const MeasuredPoint& measured = fit_.points_[point];
    const std::size_t number = condition_of(measured);
    Condition& condition = fit_.conditions_[number];
    const auto [known, fresh] =
        readings_.try_emplace({number, place_of(measured.reading)}, condition.readings.size());
    if (fresh) {
      condition.readings.push_back({measured.reading, {}});
      if (const auto* request = std::get_if<MetricRequest>(&measured.reading))
        condition.requests.push_back(*request);
    }
    condition.readings[known->second].points.push_back(point);
  }

 private:
  using Place = std::tuple<std::size_t, int, int, double, double, double>;

  static Place place_of(const Reading& reading) {
    const auto* request = std::get_if<MetricRequest>(&reading);
    if (request == nullptr)
      return {reading.index(), static_cast<int>(std::get<CircuitPart>(reading)), 0, 0, 0, 0};
    return {reading.index(),
            static_cast<int>(request->metric),
            static_cast<int>(request->argument),
            request->at,
            request->torque,
            request->after.value_or(-1)};
  }

  std::size_t condition_of(const MeasuredPoint& point) {
    std::vector<std::size_t> places = fit_.places_in(point.table);
    std::vector<double> key(places.begin(), places.end());
    for (const double number : plain_numbers(point.set)) key.push_back(number);
    const auto [known, fresh] = conditions_.try_emplace(std::move(key), fit_.conditions_.size());
    if (!fresh) return known->second;
    VariedParameters varied(with(fit_.motor_, point.set), fit_.parameters_at(places), derived_);
    fit_.conditions_.push_back({std::move(places), std::move(varied), {}, {}});
    for (const auto& [parameter, value] : point.set)
      if (std::ranges::find(fit_.set_, parameter) == fit_.set_.end())
        fit_.set_.push_back(parameter);
    return known->second;
  }

  MeasuredFit& fit_;
  const std::vector<DerivedParameter>& derived_;
  std::map<std::vector<double>, std::size_t> conditions_;  // by places and set
  std::map<std::pair<std::size_t, Place>, std::size_t> readings_;
};

std::vector<double> plain_numbers(const std::vector<ParameterValue>& set) {
  std::vector<double> numbers{-1};  // no place has this number
  for (const auto& [parameter, value] : set) {
    numbers.push_back(static_cast<double>(index_of(parameter)));
    numbers.push_back(value);
  }
  return numbers;
}

MeasuredFit::MeasuredFit(const MotorDesign& motor, std::vector<FitParameter> parameters,
                         std::vector<MeasuredPoint> points, std::vector<DerivedParameter> derived)
    : motor_(motor),
      parameters_(std::move(parameters)),
      points_(std::move(points)),
      varied_(motor_, parameters_at(places_in(0)), derived) {
  Sorter sorter(*this, derived);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    sorter.add(i);
    mixed_ = mixed_ || !same_scale(points_[i].reading, points_.front().reading);
  }
}

std::vector<std::size_t> MeasuredFit::places_in(std::size_t table) const {
  std::vector<std::size_t> places;
  for (std::size_t j = 0; j < parameters_.size(); ++j)
    if (parameters_[j].table.value_or(table) == table) places.push_back(j);
  return places;
}

std::vector<Parameter> MeasuredFit::parameters_at(const std::vector<std::size_t>& places) const {
  std::vector<Parameter> list;
  for (const std::size_t j : places) list.push_back(parameters_[j].parameter);
  return list;
}

bool MeasuredFit::per_file() const {
  return std::any_of(parameters_.begin(), parameters_.end(),
                     [](const FitParameter& one) { return one.table.has_value(); });
}

// Every table varies the same parameters of the motor.
MotorDesign MeasuredFit::motor_at(std::span<const double> values, std::size_t table) const {
  return varied_.motor(picked(values, places_in(table)));
}

bool MeasuredFit::sets(Parameter parameter) const {
  const auto same = [&](Parameter other) {
    return other == parameter || info(other).alternative == parameter;
  };
  return std::any_of(varied_.varied().begin(), varied_.varied().end(), same) ||
         std::any_of(varied_.derived().begin(), varied_.derived().end(),
                     [&](const DerivedParameter& rule) { return same(rule.parameter); }) ||
         std::any_of(set_.begin(), set_.end(), same);
}

MeasuredFit MeasuredFit::varying(const std::vector<Parameter>& more) const {
  std::vector<FitParameter> all = parameters_;
  for (const Parameter parameter : more) all.emplace_back(DesignVariable{parameter});
  return {motor_, std::move(all), points_, varied_.derived()};
}

MeasuredFit MeasuredFit::asking(std::vector<MeasuredPoint> points) const {
  return {motor_, parameters_, std::move(points), varied_.derived()};
}

MeasuredFit MeasuredFit::in_parts(const std::vector<std::size_t>& columns,
                                  const std::vector<double>& deviations) const {
  std::vector<MeasuredPoint> points = points_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double part = deviations[columns[i]];
    points[i].weight /= part * part;
    points[i].deviation = 1 / std::sqrt(points[i].weight);
  }
  return asking(std::move(points));
}

optim::Residuals MeasuredFit::residuals(std::span<const double> values) const {
  optim::Residuals failed;
  try {
    return all_residuals(values);
  } catch (const EvaluationError& error) {
    failed.failure = error.reason();
  } catch (const InputError& error) {  // these values are not those of a valid motor
    failed.failure = std::string("not a motor: ") + error.what();
  }
  return failed;
}

optim::Residuals MeasuredFit::all_residuals(std::span<const double> values) const {
  optim::Residuals result;
  result.values.resize(points_.size());
  result.jacobian.resize(points_.size() * parameters_.size());
  for (const Condition& condition : conditions_) add(condition, values, result);
  return result;
}

void MeasuredFit::add(const Condition& condition, std::span<const double> values,
                      optim::Residuals& result) const {
  const MotorDesign motor = condition.varied.motor(picked(values, condition.places));
  const auto slopes = condition.varied.slopes(motor);
  const bool fixed = condition.varied.fixed_static_friction();
  std::vector<MetricDerivative> metrics;
  if (!condition.requests.empty()) metrics = differentiate(Motor(motor), condition.requests, fixed);
  auto next = metrics.begin();
  for (const Readings& readings : condition.readings) {
    const auto* part = std::get_if<CircuitPart>(&readings.reading);
    const MetricDerivative found = part != nullptr ? differentiate(motor, *part, fixed) : *next++;
    require_value(found, failure_name(readings.reading));
    add(condition, readings, found, slopes, result);
  }
}

void MeasuredFit::add(const Condition& condition, const Readings& readings,
                      const MetricDerivative& found, const VariedParameters::Slopes& slopes,
                      optim::Residuals& result) const {
  const std::vector<double> by = condition.varied.derivatives(found.gradient, slopes);
  for (const std::size_t i : readings.points) {
    const double root = std::sqrt(points_[i].weight);
    result.values[i] = root * (found.value.value - points_[i].value);
    for (std::size_t j = 0; j < by.size(); ++j)
      result.jacobian[i * parameters_.size() + condition.places[j]] = root * by[j];
  }
}

double MeasuredFit::rms(std::span<const double> residuals) const {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

std::string MeasuredFit::unit() const {
  return mixed_ ? "1" : std::string(unit_of(points_.front().reading));
}

// The weights are 1 / s^2 times one factor.
double MeasuredFit::stated_deviation() const {
  return points_.front().deviation * std::sqrt(points_.front().weight);
}

double MeasuredFit::size() const {
  double sum = 0;
  for (const MeasuredPoint& point : points_) sum += point.weight * point.value * point.value;
  return std::sqrt(sum / static_cast<double>(points_.size()));
}

std::vector<NamedValue> MeasuredFit::derived(std::span<const double> values) const {
  if (varied_.derived().empty()) return {};
  const MotorDesign motor = motor_at(values);
  std::vector<NamedValue> list;
  for (const DerivedParameter& rule : varied_.derived()) {
    const ParameterInfo& row = info(rule.parameter);
    list.push_back({std::string(row.name), std::string(row.unit), get(motor, rule.parameter)});
  }
  return list;
}

double MeasuredFit::static_ratio() const {
  const bool estimated = std::any_of(
      parameters_.begin(), parameters_.end(),
      [](const DesignVariable& range) { return range.parameter == Parameter::kinetic_friction; });
  const double kinetic = get(motor_, Parameter::kinetic_friction);
  if (!estimated || varied_.fixed_static_friction() || !(kinetic > 0)) return 1;
  return get(motor_, Parameter::static_friction) / kinetic;
}

std::vector<optim::Variable> MeasuredFit::variables(std::span<const double> start) const {
  std::vector<optim::Variable> result;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const FitParameter& range = parameters_[j];
    const double own = get(motor_, range.parameter);
    optim::Variable variable{range.name(), range.min, range.max, range.start, range.scale};
    if (!start.empty())
      variable.start = start[j];
    else if (std::isnan(range.start) && own >= range.min && own <= range.max)
      variable.start = own;
    result.push_back(std::move(variable));
  }
  return result;
}

}  // namespace twum::inline v0_1::studies
