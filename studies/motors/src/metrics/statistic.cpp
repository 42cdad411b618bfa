// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/statistic.hpp>

#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>

namespace twum::inline v0_1::motors {
namespace {

using Kind = StatisticRequest::Kind;

constexpr std::array<std::string_view, 5> kStatisticNames{"mean", "sd", "quantile", "probability",
                                                          "yield"};
constexpr const char* kStatisticUsage =
    "expected a limit such as 'yield >= 99 %', 'probability(no_load_speed >= 100 rpm) >= 99 %' or "
    "'mean(peak_power) >= 5 W'";

// The word that a text begins with, if it is the name of a statistic.
std::optional<Kind> kind_of(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" (<>=+-*/^"));
  const auto found = std::find(kStatisticNames.begin(), kStatisticNames.end(), word);
  if (found == kStatisticNames.end()) return {};
  return static_cast<Kind>(found - kStatisticNames.begin());
}

// Length of a statistic at the beginning of the text: to the bracket that closes its first one.
std::size_t length_of(std::string_view text, Kind kind) {
  const std::size_t name = kStatisticNames[static_cast<std::size_t>(kind)].size();
  if (kind == Kind::yield) return name;
  if (name >= text.size() || text[name] != '(')
    throw ValueError(quoted(text) + " has no bracket after its name",
                     "expected one such as 'mean(peak_power)'", name);
  int depth = 0;
  for (std::size_t i = name; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  throw ValueError(quoted(text) + " has a bracket that does not close", "add a ')'", name);
}

// Reads a part of a text; the positions of errors refer to the whole text.
template <typename Read>
auto read_at(std::string_view part, std::size_t begin, Read read) {
  try {
    return read(part);
  } catch (const ValueError& error) {
    throw ValueError(error.found(), error.expected(), begin + error.position());
  }
}

// A quantity without a name in it, in SI, of the dimension of `like`.
double quantity_of(std::string_view text, std::size_t begin, const Formula* like,
                   const char* expected) {
  const MetricExpression side = read_at(text, begin, parse_side);
  if (!side.formula.constant())
    throw ValueError(quoted(text) + " is not a quantity", expected, begin);
  if (like != nullptr) require_same_dimension(*like, side.formula, ">=", begin);
  if (like == nullptr && side.unit() != "1")
    throw ValueError(quoted(text) + " is not a share of the motors", expected, begin);
  return side.formula.value({});
}

StatisticRequest quantile_of(std::string_view inside, std::size_t begin) {
  const auto parts = split_list(inside);
  if (parts.size() != 2)
    throw ValueError("a quantile of " + quoted(inside),
                     "expected a metric and a probability, such as 'quantile(peak_power, 5 %)'",
                     begin);
  StatisticRequest request;
  request.kind = Kind::quantile;
  request.metric = read_at(parts[0], begin, parse_metric);
  const auto place = begin + static_cast<std::size_t>(parts[1].data() - inside.data());
  request.probability =
      quantity_of(parts[1], place, nullptr, "expected a probability such as '5 %'");
  if (!(request.probability > 0 && request.probability < 1))
    throw ValueError("a probability of " + quoted(parts[1]), "must be between 0 and 100 %", place);
  return request;
}

}  // namespace

std::string StatisticRequest::unit() const {
  return kind == Kind::probability || kind == Kind::yield ? "1" : metric.unit();
}

bool is_statistic(std::string_view text) { return kind_of(trimmed(text)).has_value(); }

StatisticRequest parse_statistic(std::string_view text) {
  text = trimmed(text);
  const auto kind = kind_of(text);
  if (!kind) throw ValueError(quoted(text) + " is not a statistic", kStatisticUsage, 0);
  const std::size_t length = length_of(text, *kind);
  if (length != text.size())
    throw ValueError(quoted(text) + " is more than one statistic",
                     "a statistic stands alone; compute with metrics inside its brackets", length);
  StatisticRequest request;
  request.kind = *kind;
  if (*kind != Kind::yield) {
    const std::size_t begin = kStatisticNames[static_cast<std::size_t>(*kind)].size() + 1;
    const std::string_view inside = text.substr(begin, length - begin - 1);
    if (*kind == Kind::quantile)
      request = quantile_of(inside, begin);
    else if (*kind == Kind::probability)
      request.limit = read_at(inside, begin, parse_limit);
    else
      request.metric = read_at(inside, begin, parse_metric);
  }
  request.text = std::string(text);
  return request;
}

StatisticLimit parse_statistic_limit(std::string_view text) {
  text = trimmed(text);
  const auto kind = kind_of(text);
  if (!kind) throw ValueError(quoted(text) + " is not a limit on a statistic", kStatisticUsage, 0);
  const std::size_t length = length_of(text, *kind);
  StatisticLimit limit{std::string(text), parse_statistic(text.substr(0, length))};
  const std::size_t sign = text.find_first_not_of(' ', length);
  const std::string_view comparison =
      sign == std::string_view::npos ? std::string_view{} : text.substr(sign, 2);
  if (comparison != ">=" && comparison != "<=")
    throw ValueError(quoted(text) + " compares with nothing", kStatisticUsage,
                     std::min(sign, text.size()));
  const std::string_view right = trimmed(text.substr(sign + 2));
  const auto place = static_cast<std::size_t>(right.data() - text.data());
  const bool share = *kind == Kind::yield || *kind == Kind::probability;
  const double end =
      quantity_of(right, place, share ? nullptr : &limit.statistic.metric.formula, kStatisticUsage);
  if (share && comparison == "<=")
    throw ValueError(
        "an upper limit of a " + std::string(kStatisticNames[static_cast<std::size_t>(*kind)]),
        "expected a lower one, such as 'yield >= 99 %'", sign);
  if (share && !(end > 0 && end < 1))
    throw ValueError(quoted(right) + " is not a share of the motors",
                     "must be more than 0 and less than 100 %", place);
  (comparison == ">=" ? limit.lower : limit.upper) = end;
  return limit;
}

}  // namespace twum::inline v0_1::motors
