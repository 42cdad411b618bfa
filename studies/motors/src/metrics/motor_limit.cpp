// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/motor_limit.hpp>

#include <twum/io/number.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace twum::inline v0_1::motors {
namespace {

constexpr const char* kUsage = "expected a limit such as 'stall_torque >= 0.8 N.m'";
constexpr const char* kTolerance =
    "an equality has a tolerance, such as 'no_load_speed == 150 rpm +- 3 rpm'";

// A part of a text with its position.
struct Piece {
  std::string_view whole;
  std::size_t begin;
  std::size_t end;

  std::string_view text() const { return whole.substr(begin, end - begin); }
  // Reads the part; the positions of errors refer to the whole text.
  template <typename Read>
  auto read(const Read& read) const {
    try {
      return read(text());
    } catch (const ValueError& error) {
      throw ValueError(error.found(), error.expected(), begin + error.position());
    }
  }
  // "80 degC": an absolute temperature of its own, and where it stands.
  std::optional<double> celsius() const {
    const std::string_view typed = trimmed(text());
    if (!is_celsius(trimmed(typed.substr(std::min(typed.size(), number_prefix(typed)))))) return {};
    return read([](std::string_view part) { return parse_quantity(part, {"K", "80 degC", true}); });
  }
  MetricExpression side() const {
    if (const auto kelvin = celsius()) return parse_side(number_text(*kelvin) + " K");
    if (trimmed(text()).empty())
      throw ValueError("a part of the limit is empty",
                       "expected a metric or a quantity such as 'stall_torque' or '0.8 N.m'",
                       begin);
    return read(parse_side);
  }
};

struct Sign {
  std::string_view text;
  std::size_t at;
};

// Every comparison in the text.
std::vector<Sign> comparisons(std::string_view text) {
  std::vector<Sign> signs;
  for (std::size_t at = text.find_first_of("<>="); at != std::string_view::npos;
       at = text.find_first_of("<>=", at + 2)) {
    const std::string_view sign = text.substr(at, 2);
    if (sign != ">=" && sign != "<=" && sign != "==")
      throw ValueError(quoted(text) + " compares with '" + std::string(sign.substr(0, 1)) + "'",
                       "only '>=', '<=' and '== A +- B' are known", at);
    signs.push_back({sign, at});
  }
  return signs;
}

double constant(const MetricExpression& side) { return side.formula.value({}); }

// left - right, which is positive if left is larger.
MetricExpression difference(const MetricExpression& left, const MetricExpression& right) {
  return parse_metric(left.formula.text() + " - (" + right.formula.text() + ")");
}

MotorLimit between_sides(std::string_view text, const Sign& sign, MetricExpression left,
                         MetricExpression right) {
  require_same_dimension(left.formula, right.formula, sign.text, sign.at);
  bool at_least = sign.text == ">=";
  if (left.formula.constant()) {
    std::swap(left, right);
    at_least = !at_least;
  }
  if (left.formula.constant())
    throw ValueError(quoted(text) + " has no metric or parameter in it", kUsage, sign.at);
  MotorLimit limit{std::string(text), left};
  double end = 0;
  if (right.formula.constant()) {
    end = constant(right);
  } else {
    limit.metric = difference(left, right);
    limit.sides = {std::move(left), std::move(right)};
  }
  (at_least ? limit.lower : limit.upper) = end;
  return limit;
}

// "A <= EXPR <= B" or "B >= EXPR >= A".
MotorLimit two_sided(std::string_view text, const std::vector<Sign>& signs,
                     const MetricExpression& first, const MetricExpression& metric,
                     const MetricExpression& last) {
  if (signs[0].text != signs[1].text || signs[0].text == "==")
    throw ValueError(quoted(text) + " compares in two directions",
                     "expected one such as '145 rpm <= no_load_speed <= 155 rpm'", signs[1].at);
  if (!first.formula.constant() || !last.formula.constant() || metric.formula.constant())
    throw ValueError(
        "the ends of a limit with two signs are quantities, with a metric between them",
        "write two limits instead", signs[first.formula.constant() ? 1 : 0].at);
  require_same_dimension(first.formula, metric.formula, signs[0].text, signs[0].at);
  require_same_dimension(metric.formula, last.formula, signs[1].text, signs[1].at);
  MotorLimit limit{std::string(text), metric, constant(first), constant(last)};
  if (signs[0].text == ">=") std::swap(limit.lower, limit.upper);
  if (!(limit.lower <= limit.upper))
    throw ValueError(quoted(text) + " leaves no room",
                     "the smaller end must not exceed the larger one", signs[1].at);
  return limit;
}

// The tolerance in SI: a percentage is one of the target.
double tolerance_of(const Piece& piece, const MetricExpression& target) {
  const MetricExpression tolerance = piece.side();
  const std::size_t at = piece.begin;
  const bool relative = piece.text().find('%') != std::string_view::npos;
  if (!tolerance.formula.constant() || (relative && !target.formula.constant()))
    throw ValueError("a tolerance " + quoted(trimmed(piece.text())) + " that depends on the motor",
                     kTolerance, at);
  if (!relative) require_same_dimension(target.formula, tolerance.formula, "+-", at);
  const double size = constant(tolerance) * (relative ? std::fabs(constant(target)) : 1);
  if (!(size > 0)) throw ValueError("a tolerance that is not positive", kTolerance, at);
  return size;
}

// "EXPR == A +- B"
MotorLimit equality(std::string_view text, const Sign& sign) {
  const std::size_t begin = sign.at + sign.text.size();
  const std::size_t plus = text.find("+-", begin);
  if (plus == std::string_view::npos)
    throw ValueError(quoted(text) + " has no tolerance", kTolerance, text.size());
  const MetricExpression target = Piece{text, begin, plus}.side();
  MotorLimit limit = between_sides(text, sign, Piece{text, 0, sign.at}.side(), target);
  const double tolerance = tolerance_of({text, plus + 2, text.size()}, target);
  const double middle = std::isfinite(limit.lower) ? limit.lower : limit.upper;
  limit.lower = middle - tolerance;
  limit.upper = middle + tolerance;
  return limit;
}

constexpr const char* kSizeOfTolerance = "expected a quantity such as '1e-4 N.m'";

}  // namespace

double MotorLimit::excess(double value) const {
  if (std::isnan(value)) return value;
  return std::max({0.0, lower - value, value - upper});
}

bool MotorLimit::at_least(double value) const {
  if (std::isinf(lower) || std::isinf(upper)) return std::isinf(upper);
  return std::fabs(value - lower) < std::fabs(value - upper);
}

MotorLimit with_tolerance(MotorLimit limit, std::string_view tolerance) {
  const Piece piece{tolerance, 0, tolerance.size()};
  const MetricExpression amount = piece.side();
  if (!amount.formula.constant())
    throw ValueError(quoted(trimmed(tolerance)) + " depends on the motor", kSizeOfTolerance, 0);
  require_same_dimension(limit.metric.formula, amount.formula, "tolerance", 0);
  limit.tolerance = constant(amount);
  limit.tolerance_text = trimmed(tolerance);
  if (!(limit.tolerance >= 0))
    throw ValueError(quoted(trimmed(tolerance)) + " is negative", kSizeOfTolerance, 0);
  return limit;
}

namespace {

// A temperature in degC stands opposite an absolute temperature alone.
void check_celsius(std::string_view text, const std::vector<Sign>& signs) {
  std::vector<Piece> pieces{{text, 0, text.size()}};
  for (const Sign& sign : signs) {
    pieces.back().end = sign.at;
    pieces.push_back({text, sign.at + sign.text.size(), text.size()});
  }
  for (const Piece& typed : pieces) {
    if (!typed.celsius()) continue;
    const bool right = std::any_of(pieces.begin(), pieces.end(), [](const Piece& other) {
      return !other.celsius() && is_absolute(other.side());
    });
    if (!right)
      throw ValueError(quoted(trimmed(typed.text())) + " is an absolute temperature",
                       "compare it with a metric of a temperature alone, such as "
                       "'stator_temperature_at(0.5 N.m) <= 80 degC', or write a difference in K",
                       typed.begin);
  }
}

}  // namespace

MotorLimit parse_limit(std::string_view text) {
  text = trimmed(text);
  const std::vector<Sign> signs = comparisons(text);
  if (signs.empty()) throw ValueError(quoted(text) + " limits nothing", kUsage, text.size());
  if (signs.size() > 2)
    throw ValueError(quoted(text) + " has more than two signs", kUsage, signs[2].at);
  if (signs.size() == 1 && signs[0].text == "==") return equality(text, signs[0]);
  check_celsius(text, signs);
  const auto after = [](const Sign& sign) { return sign.at + sign.text.size(); };
  const MetricExpression first = Piece{text, 0, signs[0].at}.side();
  const MetricExpression last = Piece{text, after(signs.back()), text.size()}.side();
  if (signs.size() == 1) return between_sides(text, signs[0], first, last);
  const MetricExpression middle = Piece{text, after(signs[0]), signs[1].at}.side();
  return two_sided(text, signs, first, middle, last);
}

}  // namespace twum::inline v0_1::motors
