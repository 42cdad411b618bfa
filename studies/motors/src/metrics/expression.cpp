// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/metrics/expression.hpp>

#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/units.hpp>

#include <array>

namespace twum::studies {
namespace {

constexpr Expected kSpeed{"rad/s", "100 rpm"};
constexpr Expected kTorque{"N.m", "0.5 N.m"};

// "torque_at(100 rpm)": how a point metric is written.
std::string usage(const MetricInfo& metric) {
  const char* example = metric.argument == Argument::torque ? "0.5 N.m" : "100 rpm";
  return std::string(metric.name) + "(" + example + ")";
}

const char* argument_phrase(Argument argument) {
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

// What stands between the parentheses, as a request.
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

// The place of the closing parenthesis, which must end the text.
std::size_t closing(std::string_view text, std::size_t open) {
  const std::size_t close = text.rfind(')');
  if (close == std::string_view::npos || close < open) {
    throw ValueError(quoted(text) + " has no ')'", "close the parenthesis", text.size());
  }
  if (close + 1 != text.size()) {
    throw ValueError(quoted(text.substr(close + 1)) + " after the ')'", "nothing may follow it",
                     close + 1);
  }
  return close;
}

MetricRequest parse_request(const MetricInfo& metric, std::string_view text, std::size_t open) {
  if (open == std::string_view::npos) {
    if (metric.argument != Argument::none) {
      throw ValueError(quoted(text) + " needs " + argument_phrase(metric.argument),
                       "expected one such as '" + usage(metric) + "'", text.size());
    }
    return {metric.metric, Argument::none, 0};
  }
  if (metric.argument == Argument::none) {
    throw ValueError(quoted(metric.name) + " takes nothing in parentheses", "write it without them",
                     open);
  }
  const std::size_t close = closing(text, open);
  const std::string_view argument = trimmed(text.substr(open + 1, close - open - 1));
  return parse_argument(metric, argument, static_cast<std::size_t>(argument.data() - text.data()));
}

}  // namespace

std::string_view MetricExpression::unit() const {
  if (const auto* request = std::get_if<MetricRequest>(&what)) return info(request->metric).unit;
  return info(std::get<Parameter>(what)).unit;
}

MetricExpression parse_metric(std::string_view text) {
  text = trimmed(text);
  if (text.empty())
    throw ValueError("nothing", "expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'");
  const std::size_t open = text.find('(');
  const std::string_view name = trimmed(text.substr(0, open));
  if (const auto metric = find_metric(name)) {
    return {std::string(text), parse_request(info(*metric), text, open)};
  }
  const auto parameter = find_parameter(name);
  if (!parameter) unknown_name(name, 0);
  if (open != std::string_view::npos) {
    throw ValueError(quoted(name) + " is a parameter and takes nothing in parentheses",
                     "write it without them", open);
  }
  return {std::string(text), *parameter};
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
        throw ValueError(quoted(piece) + " is there twice", "leave one of them out", offset);
      }
    }
  }
  return list;
}

std::vector<MetricExpression> plain_metrics() {
  std::vector<MetricExpression> list;
  for (const MetricInfo& row : metric_table()) {
    if (row.argument != Argument::none) continue;
    list.push_back({std::string(row.name), MetricRequest{row.metric, Argument::none, 0}});
  }
  return list;
}

ExpressionEvaluator::ExpressionEvaluator(std::span<const MetricExpression> expressions) {
  for (const MetricExpression& expression : expressions) {
    if (const auto* request = std::get_if<MetricRequest>(&expression.what)) {
      places_.emplace_back(requests_.size());
      requests_.push_back(*request);
    } else {
      places_.emplace_back(std::get<Parameter>(expression.what));
    }
  }
}

void ExpressionEvaluator::evaluate(const Motor& motor, std::span<MetricValue> values) const {
  const std::vector<MetricValue> metrics = twum::evaluate(motor, requests_);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto* index = std::get_if<std::size_t>(&places_[i]);
    values[i] = index != nullptr ? metrics[*index]
                                 : MetricValue{get(motor.design(), std::get<Parameter>(places_[i])),
                                               MetricStatus::ok};
  }
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

}  // namespace twum::studies
