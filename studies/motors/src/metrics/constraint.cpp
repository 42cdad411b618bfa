// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/metrics/constraint.hpp>

#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/units.hpp>

namespace twum::studies {
namespace {

constexpr const char* kUsage = "expected a limit such as 'stall_torque >= 0.8 N.m'";

// Length of the comparison at a place: 2 for ">=" and "<="; anything else is refused.
bool is_at_least(std::string_view text, std::size_t at) {
  const std::string_view sign = text.substr(at, 2);
  if (sign == ">=") return true;
  if (sign == "<=") return false;
  throw ValueError(quoted(text) + " compares with '" + std::string(text.substr(at, 1)) + "'",
                   "only '>=' and '<=' are known", at);
}

}  // namespace

Constraint parse_constraint(std::string_view text) {
  text = trimmed(text);
  const std::size_t at = text.find_first_of("<>=");
  if (at == std::string_view::npos)
    throw ValueError(quoted(text) + " limits nothing", kUsage, text.size());
  const bool at_least = is_at_least(text, at);
  MetricExpression metric = parse_metric(text.substr(0, at));
  const std::string_view limit = trimmed(text.substr(at + 2));
  try {
    const double value = parse_quantity(limit, Expected{metric.unit(), ""});
    return {std::string(text), std::move(metric), at_least, value};
  } catch (const ValueError& error) {
    const auto begin = static_cast<std::size_t>(limit.data() - text.data());
    throw ValueError(error.found(), error.expected(), begin + error.position());
  }
}

}  // namespace twum::studies
