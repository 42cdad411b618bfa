// SPDX-License-Identifier: Apache-2.0
#include "telling/load_parts.hpp"

#include <twum/studies/telling.hpp>

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/plain_name.hpp>
#include <twum/motors/statistic.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace twum::inline v0_1::studies::telling {
namespace {

constexpr const char* kNoBreak = "\u00a0";

// "1.2 · 10⁻¹⁰" of "1.2e-10"
std::string raised(const std::string& text, std::size_t exponent, const std::string& blank) {
  constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int power = std::atoi(text.c_str() + exponent + 1);
  std::string up = power < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(power))) up += kRaised[digit - '0'];
  return text.substr(0, exponent) + blank + "·" + blank + "10" + up;
}

// Without an exponent where the number is short without one: 290, not 2.9e+02.
std::string short_number(double value, int digits, Writing writing) {
  const std::string text = rounded_text(value, digits);
  const double size = std::fabs(value);
  const auto again = parse_number(text);
  const std::size_t exponent = text.find('e');
  if (!again || exponent == std::string::npos) return text;
  if (size >= 1e-4 && size < 1e7) return number_text(*again);
  return writing == Writing::typed
             ? text
             : raised(text, exponent, writing == Writing::page ? kNoBreak : " ");
}

std::string with_unit(const std::string& number, const std::string& unit, Writing writing) {
  if (unit.empty()) return number;
  return number + (writing == Writing::page ? kNoBreak : " ") +
         (writing == Writing::typed ? unit : printed_unit(unit));
}

// Of a share near one, what is missing has two digits: 99.9985 %.
int share_digits(double share, int digits) {
  constexpr int kMost = 12;  // as many as are not rounding
  if (share > 0.9 && share < 1)
    digits = std::max(digits, 2 + static_cast<int>(std::floor(-std::log10(1 - share))));
  return std::min(digits, kMost);
}

std::string written_share(double share, int digits, Writing writing) {
  if (!std::isfinite(share)) return "-";
  return with_unit(short_number(100 * share, share_digits(share, digits), writing), "%", writing);
}

std::string written_value(double value, const std::string& si_unit, int digits, Writing writing) {
  if (std::isinf(value)) return "unlimited";
  if (!std::isfinite(value)) return "-";
  const DisplayUnit unit = display_unit(value, si_unit);
  return with_unit(short_number(value / unit.divisor, digits, writing), unit.text, writing);
}

// "+1.2 W", "-3 %", "nothing"
std::string written_number(const Part& part, Writing writing) {
  if (part.change && part.value == 0) return "nothing";
  return (part.change && part.value > 0 ? "+" : "") +
         (part.kind == Part::Kind::share
              ? written_share(part.value, part.digits, writing)
              : written_value(part.value, part.text, part.digits, writing));
}

// Signs that a keyboard does not have.
std::string typed_words(std::string text) {
  for (const auto& [read, typed] :
       {std::pair{"≥", ">="}, std::pair{"≤", "<="}, std::pair{"±", "+-"}})
    for (std::size_t at = text.find(read); at != std::string::npos; at = text.find(read))
      text.replace(at, std::string_view(read).size(), typed);
  return text;
}

std::string read_limit(const std::string& text, Writing writing);

std::string read_statistic(const StatisticRequest& statistic, Writing writing) {
  const auto of = [&] { return written(name_part(statistic.metric.text), writing); };
  switch (statistic.kind) {
    case StatisticRequest::Kind::mean: return "mean " + of();
    case StatisticRequest::Kind::sd: return "standard deviation of the " + of();
    case StatisticRequest::Kind::quantile:
      return written_share(statistic.probability, 3, writing) + " quantile of the " + of();
    case StatisticRequest::Kind::probability:
      return "probability of " + read_limit(statistic.limit->text, writing);
    case StatisticRequest::Kind::yield: return "yield";
  }
  return "yield";
}

std::string read_request(const MetricRequest& request, const std::string& metric, Writing writing);

// "torque at 80 rpm" of a metric at a point, whose unit is as typed in the file.
std::string read_load(const LoadPoint& load, Writing writing) {
  const auto value = [&](double number, const char* unit) {
    return written_value(number, unit, 4, writing);
  };
  if (load.argument == Argument::torque) return value(load.at, "N.m");
  if (load.argument == Argument::speed) return value(load.at, "rad/s");
  return value(load.torque, "N.m") + ", " + value(load.at, "rad/s");
}

// "speed at 0.5 N.m, warm" at the temperatures of the metric's own point, or "warm at" those of another one; likewise "worn".
std::string read_aged(MetricRequest request, std::optional<LoadPoint> MetricRequest::*aged,
                      const char* word, const std::string& metric, Writing writing) {
  const LoadPoint load = *(request.*aged), own{request.argument, request.at, request.torque};
  (request.*aged).reset();
  const bool plain = load == own || load.argument == Argument::none;
  return read_request(request, metric, writing) + ", " + word +
         (plain ? "" : " at " + read_load(load, writing));
}

std::string read_request(const MetricRequest& request, const std::string& metric, Writing writing) {
  if (request.after) {
    MetricRequest steady = request;
    steady.after.reset();
    return read_request(steady, metric, writing) + " after " +
           written_value(*request.after, "s", 4, writing);
  }
  if (request.worn_at) return read_aged(request, &MetricRequest::worn_at, "worn", metric, writing);
  if (request.warm_at) return read_aged(request, &MetricRequest::warm_at, "warm", metric, writing);
  const std::string name = plain_name(metric);
  const auto at = [&](double value, const char* unit) {
    return " " + written_value(value, unit, 4, writing);
  };
  switch (request.argument) {
    case Argument::torque: return name + at(request.at, "N.m");
    case Argument::speed: return name + at(request.at, "rad/s");
    case Argument::both: return name + at(request.torque, "N.m") + "," + at(request.at, "rad/s");
    case Argument::angle: return name + at(request.at, "rad");
    case Argument::periods: return name + at(request.at, "1") + " periods";
    case Argument::none:
    case Argument::either:
    case Argument::speed_or_torque: break;
  }
  const bool counted = metric == "efficiency" || metric == "max_efficiency";
  return name + (counted ? " (including stator loss)" : "");
}

std::string read_name(const std::string& name, Writing writing) {
  try {
    if (is_statistic(name)) return read_statistic(parse_statistic(name), writing);
    const MetricExpression expression = parse_metric(name);
    if (const MetricRequest* request = expression.request())
      return read_request(*request, std::string(info(request->metric).name), writing);
  } catch (const ValueError&) {
    return plain_name(name);  // a choice, such as the lining
  }
  return plain_name(name);  // a parameter or a formula
}

std::string with_article(const std::string& words) {
  return (std::string_view("aeioAEIO").find(words.front()) == std::string_view::npos ? "a "
                                                                                     : "an ") +
         words;
}

std::string between(const std::string& name, const std::string& unit, double lower, double upper,
                    Writing writing) {
  const auto end = [&](double value) {
    return unit == "%" ? written_share(value, 4, writing) : written_value(value, unit, 4, writing);
  };
  if (!std::isfinite(lower)) return name + " ≤ " + end(upper);
  if (!std::isfinite(upper)) return name + " ≥ " + end(lower);
  return end(lower) + " ≤ " + name + " ≤ " + end(upper);
}

std::string read_motor_limit(const MotorLimit& limit, Writing writing) {
  if (limit.sides.empty()) {
    const std::string name = read_name(limit.metric.text, writing);
    if (is_absolute(limit.metric))
      return between(name, "degC", in_celsius(limit.lower), in_celsius(limit.upper), writing);
    return between(name, limit.metric.unit(), limit.lower, limit.upper, writing);
  }
  std::string text;
  for (const MetricExpression& side : limit.sides)
    text += (text.empty()                 ? ""
             : std::isfinite(limit.lower) ? " ≥ "
                                          : " ≤ ") +
            read_name(side.text, writing);
  return text;
}

std::string read_statistic_limit(const StatisticLimit& limit, Writing writing) {
  using Kind = StatisticRequest::Kind;
  const StatisticRequest& statistic = limit.statistic;
  const bool share = statistic.kind == Kind::yield || statistic.kind == Kind::probability;
  return between(read_statistic(statistic, writing), share ? "%" : statistic.unit(), limit.lower,
                 limit.upper, writing);
}

std::string read_limit(const std::string& text, Writing writing) {
  const std::size_t end = text.rfind(')');
  const std::string outside = end == std::string::npos ? text : text.substr(end);
  try {
    if (outside.find_first_of("<>=") == std::string::npos && is_statistic(text))
      return read_name(text, writing);
    return is_statistic(text) ? read_statistic_limit(parse_statistic_limit(text), writing)
                              : read_motor_limit(parse_limit(text), writing);
  } catch (const ValueError&) {
    return plain_limit(text);
  }
}

}  // namespace

Part name_part(const std::string& name) { return {Part::Kind::name, name}; }
Part a_name_part(const std::string& name) { return {Part::Kind::a_name, name}; }
Part limit_part(const std::string& text) { return {Part::Kind::limit, text}; }
Part value_part(double value, const std::string& unit, int digits) {
  return {Part::Kind::value, unit, value, digits};
}
Part share_part(double share, int digits) { return {Part::Kind::share, "%", share, digits}; }

Part strong(Part part) {
  part.strong = true;
  return part;
}

Part change(Part part) {
  part.change = true;
  return part;
}

Part good(Part part) {
  part.tone = Tone::good;
  return part;
}

Part bad(Part part) {
  part.tone = Tone::bad;
  return part;
}

std::string written(const Part& part, Writing writing) {
  const bool typed = writing == Writing::typed;
  switch (part.kind) {
    case Part::Kind::words: return typed ? typed_words(part.text) : part.text;
    case Part::Kind::name: return typed ? part.text : read_name(part.text, writing);
    case Part::Kind::a_name: return with_article(typed ? part.text : read_name(part.text, writing));
    case Part::Kind::limit: return typed ? part.text : read_limit(part.text, writing);
    case Part::Kind::value:
    case Part::Kind::share: return written_number(part, writing);
  }
  return part.text;
}

std::string written(const Phrase& phrase, Writing writing) {
  std::string text;
  for (const Part& part : phrase) text += written(part, writing);
  return text;
}

}  // namespace twum::inline v0_1::studies::telling
