// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.hpp"
#include "fuzz/targets.hpp"

#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/motor_limit.hpp>

#include <cmath>
#include <iterator>
#include <optional>
#include <string>

namespace twum::fuzz {
namespace {

using namespace twum::studies;

// Of different dimensions, each.
constexpr Expected kDimensions[] = {
    {"1", "2"},     {"m", "1 mm"},      {"Pa", "1 MPa"}, {"N", "1 N"},
    {"N.m", "1"},   {"rad/s", "1 rpm"}, {"Hz", "1 kHz"}, {"W", "1 W"},
    {"W/m^2", "1"}, {"kg/m^3", "1"},    {"N.s/m", "1"},  {"Pa.s", "1"},
    {"Pa.s^2", ""}, {"s", "1 ms"},      {"J", ""},       {"rad", "1 deg"}};

// What a reader makes of a text; nothing if it refuses it.
template <class Read>
auto accepted(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const ValueError&) {
    return {};
  }
}

void expect_same(const MetricExpression& metric) {
  const MetricExpression again = parse_metric(metric.text);
  if (again.text != metric.text || again.unit() != metric.unit() ||
      again.formula.text() != metric.formula.text() || again.terms.size() != metric.terms.size())
    throw BrokenLaw("another metric: " + metric.text);
}

bool names(const ValueError& error, const MetricExpression& side) {
  return error.found().find(quoted(side.formula.text())) != std::string::npos;
}

// Two sides that can be read, but not compared: the refusal names both.
void expect_refusal(std::string_view text, const MetricExpression& left,
                    const MetricExpression& right) {
  try {
    parse_limit(text);
  } catch (const ValueError& error) {
    if (names(error, left) && names(error, right)) return;
    throw BrokenLaw("a refusal that does not name both sides: " + std::string(error.what()));
  }
  throw BrokenLaw("a limit between two dimensions: " + std::string(text));
}

void expect_same_dimension(std::string_view text) {
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string_view::npos || text.find('=', sign) != sign + 1) return;
  const std::string_view rest = text.substr(sign + 2);
  if (rest.find_first_of("<>=") != std::string_view::npos) return;
  const auto left = accepted([&] { return parse_side(text.substr(0, sign)); });
  const auto right = accepted([&] { return parse_side(rest); });
  if (left && right && !(left->formula.dimension() == right->formula.dimension()))
    expect_refusal(text, *left, *right);
}

}  // namespace

void feed_units(std::string_view text) {
  // One of the dimensions, by the text; refusing all of them one by one would take too long.
  const Expected& one = kDimensions[text.size() % std::size(kDimensions)];
  const auto scale = accepted([&] { return parse_unit(text, one); });
  if (scale && !(std::isfinite(scale->factor()) && scale->factor() > 0))
    throw BrokenLaw("a unit of no size");
  const auto quantity =
      accepted([&] { return parse_quantity(text, std::span<const Expected>(kDimensions)); });
  if (!quantity) return;
  if (!std::isfinite(quantity->value)) throw BrokenLaw("not finite");
  for (std::size_t i = 0; i < std::size(kDimensions); ++i) {
    const auto value = accepted([&] { return parse_quantity(text, kDimensions[i]); });
    if (value.has_value() != (i == quantity->which)) throw BrokenLaw("of two dimensions");
  }
}

void feed_metrics(std::string_view text) {
  if (const auto metric = accepted([&] { return parse_metric(text); })) expect_same(*metric);
  if (const auto list = accepted([&] { return parse_metric_list(text); })) {
    for (const MetricExpression& metric : *list) expect_same(metric);
  }
  expect_same_dimension(text);
  const auto limit = accepted([&] { return parse_limit(text); });
  if (!limit) return;
  expect_same(limit->metric);
  const MotorLimit again = parse_limit(limit->text);
  if (std::isnan(limit->lower) || !(limit->lower <= limit->upper) || again.lower != limit->lower ||
      again.upper != limit->upper || again.metric.text != limit->metric.text)
    throw BrokenLaw("another limit: " + limit->text);
}

}  // namespace twum::fuzz
