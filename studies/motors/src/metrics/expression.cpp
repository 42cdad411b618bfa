// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/expression.hpp>

#include <twum/base/error.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace twum::motors {
namespace {

constexpr Expected kSpeed{"rad/s", "100 rpm"};
constexpr Expected kTorque{"N.m", "0.5 N.m"};

// "torque_at(100 rpm)": how a point metric is written.
std::string usage(const MetricInfo& metric) {
  if (metric.argument == Argument::both) return std::string(metric.name) + "(0.5 N.m, 100 rpm)";
  const char* example = metric.argument == Argument::torque ? "0.5 N.m" : "100 rpm";
  return std::string(metric.name) + "(" + example + ")";
}

const char* argument_phrase(Argument argument) {
  if (argument == Argument::both) return "a torque and a speed";
  if (argument == Argument::speed) return "a speed";
  return argument == Argument::torque ? "a torque" : "a speed or a torque";
}

[[noreturn]] void unknown_name(std::string_view name, std::size_t at) {
  std::vector<std::string_view> names;
  for (const MetricInfo& row : metric_table()) names.push_back(row.name);
  const bool is_near_metric = !nearest(name, names).empty();
  if (!is_near_metric) {
    for (const ParameterInfo& row : parameter_table()) names.push_back(row.name);
  }
  const std::string remedy =
      nearest(name, names).empty()
          ? "'twum metrics' lists the metrics, 'twum parameters' the parameters"
          : did_you_mean(name, names);
  throw ValueError("unknown metric " + quoted(name), remedy, at);
}

// The text between the parentheses, as a request.
MetricRequest parse_argument(const MetricInfo& metric, std::string_view argument, std::size_t at) {
  std::vector<Expected> expected;
  if (metric.argument != Argument::torque) expected.push_back(kSpeed);
  if (metric.argument != Argument::speed) expected.push_back(kTorque);
  try {
    const Quantity quantity = parse_quantity(argument, expected);
    const bool speed = expected[quantity.which].unit == kSpeed.unit;
    return {metric.metric, speed ? Argument::speed : Argument::torque, quantity.value};
  } catch (const ValueError& error) {
    throw ValueError(std::string(metric.name) + ": " + error.found(), error.expected(),
                     at + error.position());
  }
}

// "0.5 N.m, 100 rpm" in either order: the drive holds the torque at the speed.
MetricRequest parse_held(const MetricInfo& metric, std::string_view first, std::string_view second,
                         std::string_view text) {
  const bool drive_stays = metric.metric == Metric::voltage_reserve_at;
  if (metric.argument == Argument::torque || metric.argument == Argument::speed || drive_stays)
    throw ValueError(
        std::string(metric.name) + " takes " + argument_phrase(metric.argument) + " alone",
        "write '" + usage(metric) + "'", static_cast<std::size_t>(second.data() - text.data()));
  const auto at = [&](std::string_view piece) {
    return static_cast<std::size_t>(piece.data() - text.data());
  };
  MetricInfo either = metric;
  either.argument = Argument::speed_or_torque;
  const MetricRequest a = parse_argument(either, first, at(first)),
                      b = parse_argument(either, second, at(second));
  if (a.argument == b.argument)
    throw ValueError(std::string(metric.name) + " takes one torque and one speed, but both are " +
                         (a.argument == Argument::speed ? "speeds" : "torques"),
                     "write '" + std::string(metric.name) + "(0.5 N.m, 100 rpm)'", at(second));
  const bool speed_first = a.argument == Argument::speed;
  if (!((speed_first ? a.at : b.at) > 0))
    throw ValueError(
        std::string(metric.name) + ": a drive holds a torque at a speed of more than 0 rpm",
        "at rest friction holds it without a wave; give a speed such as '100 rpm'",
        at(speed_first ? first : second));
  return {metric.metric, Argument::both, speed_first ? a.at : b.at, speed_first ? b.at : a.at};
}

// Reads "torque_at(100 rpm)"; the formula reader has checked the parentheses.
MetricRequest parse_request(const MetricInfo& metric, std::string_view text, std::size_t open) {
  if (open == std::string_view::npos) {
    if (metric.argument != Argument::none) {
      throw ValueError(quoted(text) + " needs " + argument_phrase(metric.argument),
                       "expected one such as '" + usage(metric) + "'", text.size());
    }
    return {metric.metric, Argument::none, 0};
  }
  if (metric.argument == Argument::none) {
    throw ValueError(quoted(metric.name) + " takes nothing in parentheses",
                     "write it without parentheses", open);
  }
  const std::string_view argument = trimmed(text.substr(open + 1, text.size() - open - 2));
  const std::size_t comma = argument.find(',');
  if (comma != std::string_view::npos)
    return parse_held(metric, trimmed(argument.substr(0, comma)),
                      trimmed(argument.substr(comma + 1)), text);
  if (metric.argument == Argument::both)
    throw ValueError(quoted(text) + " needs " + argument_phrase(metric.argument),
                     "expected one such as '" + usage(metric) + "'", text.size());
  return parse_argument(metric, argument, static_cast<std::size_t>(argument.data() - text.data()));
}

// Refuses a symbol in a formula, where it could be a unit.
void refuse_symbol(const ParameterInfo& row, std::string_view name) {
  if (row.name == name) return;
  throw ValueError(quoted(name) + " is a symbol, which an expression does not read",
                   "write '" + std::string(row.name) +
                       "'; a unit is written without blanks, such as '5 kW/m^2'");
}

Term parse_term(std::string_view text, bool whole_text) {
  const std::size_t open = text.find('(');
  const std::string_view name = trimmed(text.substr(0, open));
  if (const auto metric = find_metric(name)) return parse_request(info(*metric), text, open);
  const auto parameter = find_parameter(name);
  if (!parameter) unknown_name(name, 0);
  if (!whole_text) refuse_symbol(info(*parameter), name);
  if (open != std::string_view::npos) {
    throw ValueError(quoted(name) + " is a parameter and takes nothing in parentheses",
                     "write it without parentheses", open);
  }
  return *parameter;
}

// True if the text begins with the name of a metric or parameter: not if it stands in parentheses.
bool find_term(std::string_view text) {
  const std::string_view name = trimmed(text.substr(0, text.find('(')));
  return find_metric(name).has_value() || find_parameter(name).has_value();
}

bool same(const MetricRequest& a, const MetricRequest& b) { return a == b; }

bool same(const Term& a, const Term& b) { return a == b; }

// Place of an item in a list, to which it is added if it is new.
template <typename T>
std::size_t place_in(std::vector<T>& list, const T& item) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const T& one) { return same(one, item); });
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(item);
  return place;
}

std::string_view unit_of(const Term& term) {
  if (const auto* request = std::get_if<MetricRequest>(&term)) return info(request->metric).unit;
  if (const auto* parameter = std::get_if<Parameter>(&term)) return info(*parameter).unit;
  return std::get<std::shared_ptr<const OwnMetric>>(term)->unit;
}

// Cached, because the units library serves one thread at a time.
const Dimension& dimension_of(const Term& term) {
  static const std::vector<Dimension> metrics = [] {
    std::vector<Dimension> list;
    for (const MetricInfo& row : metric_table()) list.emplace_back(row.unit);
    return list;
  }();
  static const std::vector<Dimension> parameters = [] {
    std::vector<Dimension> list;
    for (const ParameterInfo& row : parameter_table()) list.emplace_back(row.unit);
    return list;
  }();
  if (const auto* request = std::get_if<MetricRequest>(&term))
    return metrics[static_cast<std::size_t>(request->metric)];
  return parameters[index_of(std::get<Parameter>(term))];
}

std::string long_text(const Term& term, std::string_view reference) {
  const auto* parameter = std::get_if<Parameter>(&term);
  return std::string(parameter != nullptr ? info(*parameter).name : reference);
}

using OwnTerm = std::shared_ptr<const OwnMetric>;

template <typename... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

// NaN where the program has no answer.
MetricValue own_value(const OwnMetric& own, const Motor& motor) {
  try {
    const double value = own.value(motor);
    return {value, std::isfinite(value) ? MetricStatus::ok : MetricStatus::undefined};
  } catch (const EvaluationError&) {
    return {std::numeric_limits<double>::quiet_NaN(), MetricStatus::undefined};
  }
}

MetricDerivative own_derivative(const OwnMetric& own, const Motor& motor,
                                bool fixed_static_friction) {
  MetricDerivative result;
  result.value = own_value(own, motor);
  result.smoothness = Smoothness::undefined;
  result.gradient.fill(std::numeric_limits<double>::quiet_NaN());
  if (result.value.status != MetricStatus::ok || !own.gradient) return result;
  result.gradient = own.gradient(motor);
  result.smoothness = Smoothness::smooth;
  if (!fixed_static_friction) return result;
  const Friction& f = motor.design().friction;
  if (f.kinetic > 0)
    result.gradient[index_of(Parameter::kinetic_friction)] -=
        f.static_ / f.kinetic * result.gradient[index_of(Parameter::static_friction)];
  return result;
}

// Of an expression of parameters alone.
Parameter parameter_of(Parameter parameter) { return parameter; }
template <typename Other>
Parameter parameter_of(const Other&) {
  TWUM_ASSERT(false);
  return {};
}

void require_own_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const bool word = !name.empty() && letter(name.front()) && std::ranges::all_of(name, [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
  if (!word)
    throw InputError(
        quoted(name) +
        " cannot be the name of a metric; use letters, digits and '_', a letter first");
  if (find_metric(name) || find_parameter(name))
    throw InputError(quoted(name) + " is a metric or parameter of twum; use another name");
}

Dimension dimension_of_own(const OwnMetric& own) {
  if (own.unit == "1") return {};
  const Measure one = parse_measure("1 " + own.unit);
  if (one.value != 1)
    throw InputError(own.name + ": its unit " + quoted(own.unit) + " is not an SI unit");
  return one.dimension;
}

// The value of a formula from those of its terms; the first failure of a term is passed on.
MetricValue value_of(const Formula& formula, std::span<const MetricValue> terms) {
  if (formula.is_name()) return terms[0];
  std::vector<double> values;
  for (const MetricValue& term : terms) {
    if (term.status != MetricStatus::ok) return term;
    values.push_back(term.value);
  }
  const double value = formula.value(values);
  return {value, std::isnan(value) ? MetricStatus::undefined : MetricStatus::ok};
}

// Smoothness of a sum of gradients: the worst of its terms; flat if all are flat.
Smoothness smoothness_of(const FormulaDerivative& formula,
                         std::span<const MetricDerivative> terms) {
  bool undefined = false;
  bool one_sided = formula.kinked;
  bool flat = true;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (formula.by_name[i] == 0) continue;
    const Smoothness term = terms[i].smoothness;
    undefined = undefined || term == Smoothness::undefined || std::isnan(formula.by_name[i]);
    one_sided = one_sided || term == Smoothness::one_sided;
    flat = flat && term == Smoothness::flat;
  }
  if (undefined) return Smoothness::undefined;
  if (one_sided) return Smoothness::one_sided;
  return flat && !terms.empty() ? Smoothness::flat : Smoothness::smooth;
}

// The chain rule: derivatives of the formula by its terms times those of the terms by the parameters.
MetricDerivative derivative_of(const Formula& formula, std::span<const MetricDerivative> terms) {
  if (formula.is_name()) return terms[0];
  MetricDerivative result;
  std::vector<MetricValue> values;
  std::vector<double> numbers;
  for (const MetricDerivative& term : terms) {
    values.push_back(term.value);
    numbers.push_back(term.value.value);
  }
  result.value = value_of(formula, values);
  result.gradient.fill(std::numeric_limits<double>::quiet_NaN());
  result.smoothness = Smoothness::undefined;
  if (result.value.status != MetricStatus::ok) return result;
  const FormulaDerivative derivative = formula.differentiate(numbers);
  result.smoothness = smoothness_of(derivative, terms);
  if (result.smoothness == Smoothness::undefined) return result;
  result.gradient.fill(0);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (derivative.by_name[i] == 0) continue;
    for (std::size_t p = 0; p < kParameterCount; ++p)
      result.gradient[p] += derivative.by_name[i] * terms[i].gradient[p];
  }
  return result;
}

}  // namespace

std::string MetricExpression::unit() const {
  return formula.is_name() ? std::string(unit_of(terms[0])) : formula.dimension().unit();
}

const MetricRequest* MetricExpression::request() const {
  return formula.is_name() ? std::get_if<MetricRequest>(terms.data()) : nullptr;
}

const Parameter* MetricExpression::parameter() const {
  return formula.is_name() ? std::get_if<Parameter>(terms.data()) : nullptr;
}

bool MetricExpression::has_derivatives() const {
  return std::all_of(terms.begin(), terms.end(), [](const Term& term) {
    const auto* own = std::get_if<OwnTerm>(&term);
    return own == nullptr || (*own)->gradient != nullptr;
  });
}

MetricExpression expression_of(Parameter parameter) { return parse_metric(info(parameter).name); }

MetricExpression expression_of(OwnMetric metric) {
  require_own_name(metric.name);
  if (!metric.value) throw InputError(metric.name + ": a metric without a function for its value");
  MetricExpression expression;
  expression.text = metric.name;
  expression.formula =
      Formula({{Formula::Operation::name, 0, 0, 0, false}}, metric.name, dimension_of_own(metric));
  expression.terms = {std::make_shared<const OwnMetric>(std::move(metric))};
  return expression;
}

MetricExpression parse_side(std::string_view text) {
  MetricExpression expression;
  const FormulaNames names{
      [&](std::string_view reference, bool whole_text) -> FormulaName {
        const Term term = parse_term(reference, whole_text);
        return {long_text(term, reference), dimension_of(term), place_in(expression.terms, term)};
      },
      "expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'"};
  expression.formula = read_formula(text, names);
  const bool bare = expression.formula.is_name() && find_term(trimmed(text));
  expression.text = bare ? std::string(trimmed(text)) : expression.formula.text();
  return expression;
}

MetricExpression parse_metric(std::string_view text) {
  MetricExpression expression = parse_side(text);
  if (expression.terms.empty())
    throw ValueError(quoted(trimmed(text)) + " has no metric or parameter in it",
                     "expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'");
  return expression;
}

std::vector<MetricExpression> parse_metric_list(std::string_view text) {
  std::vector<MetricExpression> list;
  for (const std::string_view piece : split_list(text)) {
    const auto offset = static_cast<std::size_t>(piece.data() - text.data());
    try {
      list.push_back(parse_metric(piece));
    } catch (const ValueError& error) {
      throw ValueError(error.found(), error.expected(), offset + error.position());
    }
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      if (list[i].text == list.back().text) {
        throw ValueError(quoted(piece) + " is given twice", "leave one of them out", offset);
      }
    }
  }
  return list;
}

namespace {

// Says at which torque or frequency the given voltage stops to hold the wave.
bool needs_voltage(Metric metric) {
  return metric == Metric::pull_out_torque || metric == Metric::start_frequency ||
         metric == Metric::pull_out_frequency;
}

}  // namespace

std::vector<MetricExpression> plain_metrics(const MotorDesign& design) {
  std::vector<MetricExpression> list;
  for (const MetricInfo& row : metric_table()) {
    const bool meant = (!row.needs_modes || has_modal_data(design)) &&
                       (!row.needs_geometry || design.stator.geometry) &&
                       (!needs_voltage(row.metric) || design.stator.voltage);
    if (row.argument == Argument::none && meant) list.push_back(parse_metric(row.name));
  }
  return list;
}

MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction) {
  return {{get(design, parameter), MetricStatus::ok},
          parameter_jacobian(design, fixed_static_friction)[index_of(parameter)],
          Smoothness::smooth};
}

ExpressionEvaluator::ExpressionEvaluator(std::span<const MetricExpression> expressions) {
  for (const MetricExpression& expression : expressions) {
    Asked asked{expression.formula, {}};
    const Overloaded place{
        [&](const MetricRequest& request) { return Place(place_in(requests_, request)); },
        [](const auto& other) { return Place(other); }};
    for (const Term& term : expression.terms) asked.places.push_back(std::visit(place, term));
    asked_.push_back(std::move(asked));
  }
}

void ExpressionEvaluator::evaluate(const Motor& motor, std::span<MetricValue> values) const {
  combine(motor, twum::evaluate(motor, requests_), values);
}

std::vector<MetricDerivative> ExpressionEvaluator::differentiate(const Motor& motor,
                                                                 bool fixed_static_friction) const {
  return combine(motor, twum::differentiate(motor, requests_, fixed_static_friction),
                 fixed_static_friction);
}

// Calls combine(i, terms) with the terms of each expression.
template <typename Value, typename Find, typename Combine>
void ExpressionEvaluator::combine_terms(const Find& find, const Combine& combine) const {
  std::vector<Value> terms;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    terms.clear();
    for (const Place& place : asked_[i].places) terms.push_back(std::visit(find, place));
    combine(i, terms);
  }
}

void ExpressionEvaluator::combine(const Motor& motor, std::span<const MetricValue> metrics,
                                  std::span<MetricValue> values) const {
  const Overloaded find{[&](std::size_t metric) { return metrics[metric]; },
                        [&](Parameter p) {
                          return MetricValue{get(motor.design(), p), MetricStatus::ok};
                        },
                        [&](const OwnTerm& own) { return own_value(*own, motor); }};
  combine_terms<MetricValue>(find, [&](std::size_t i, std::span<const MetricValue> terms) {
    values[i] = value_of(asked_[i].formula, terms);
  });
}

std::vector<MetricDerivative> ExpressionEvaluator::combine(
    const Motor& motor, std::span<const MetricDerivative> metrics,
    bool fixed_static_friction) const {
  std::vector<MetricDerivative> result;
  const Overloaded find{
      [&](std::size_t metric) { return metrics[metric]; },
      [&](Parameter p) { return parameter_value(motor.design(), p, fixed_static_friction); },
      [&](const OwnTerm& own) { return own_derivative(*own, motor, fixed_static_friction); }};
  combine_terms<MetricDerivative>(find,
                                  [&](std::size_t i, std::span<const MetricDerivative> terms) {
                                    result.push_back(derivative_of(asked_[i].formula, terms));
                                  });
  return result;
}

void ExpressionEvaluator::combine(const MotorDesign& design, std::span<MetricValue> values) const {
  const auto find = [&](const auto& place) {
    return MetricValue{get(design, parameter_of(place)), MetricStatus::ok};
  };
  combine_terms<MetricValue>(find, [&](std::size_t i, std::span<const MetricValue> terms) {
    values[i] = value_of(asked_[i].formula, terms);
  });
}

std::vector<MetricDerivative> ExpressionEvaluator::combine(const MotorDesign& design,
                                                           bool fixed_static_friction) const {
  std::vector<MetricDerivative> result;
  const auto find = [&](const auto& place) {
    return parameter_value(design, parameter_of(place), fixed_static_friction);
  };
  combine_terms<MetricDerivative>(find,
                                  [&](std::size_t i, std::span<const MetricDerivative> terms) {
                                    result.push_back(derivative_of(asked_[i].formula, terms));
                                  });
  return result;
}

std::vector<MetricValue> ExpressionEvaluator::evaluate(const Motor& motor) const {
  std::vector<MetricValue> values(size());
  evaluate(motor, values);
  return values;
}

std::string unanswered(std::span<const MetricExpression> expressions,
                       std::span<const MetricValue> values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].status == MetricStatus::ok) continue;
    text += (text.empty() ? "" : "; ") + expressions[i].text + ": " + to_string(values[i].status);
  }
  return text;
}

}  // namespace twum::motors
