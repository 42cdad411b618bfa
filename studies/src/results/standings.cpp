// SPDX-License-Identifier: Apache-2.0
#include "results/standings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace twum::inline v0_1::studies {
namespace {

constexpr double kNoGain = std::numeric_limits<double>::quiet_NaN();

struct Standing {
  Json json;
  bool active{false};
  double worth{0};
  double room{0};  // of the limit, relative
};

// Multipliers of a design that is no optimum are no prices. An end of a front is an optimum of its goal alone up to the accuracy of
// the front, which is less than a certificate asks for.
bool has_prices(const optim::Certificate& c) {
  constexpr double kClose = 1e-6;  // as (O3.2); NaN: not measured
  return c.passed ||
         (c.stationarity <= kClose && c.complementarity <= kClose && c.infeasibility <= kClose);
}

// What is the same for a limit and for an end of a range.
template <typename State>
Standing standing_of(const State& state, bool at_least, const DesignReport& report,
                     const std::vector<Goal>& goals, const std::vector<double>& gain) {
  const bool optimum = has_prices(report.certificate);
  const bool known = optimum && state.multiplier > 0 && state.gain_per_percent != 0 &&
                     std::isfinite(state.gain_per_percent);
  const double step =
      known ? std::fabs(state.gain_per_percent / state.multiplier) : 0.01 * std::fabs(state.limit);
  Standing standing;
  standing.worth = known ? std::fabs(state.gain_per_percent) : 0;
  standing.json = {{"side", at_least ? "at least" : "at most"},
                   {"limit", number_json(state.limit)},
                   {"step", number_json(step)},
                   {"moved", number_json(state.limit + (at_least ? -step : step))},
                   {"multiplier", number_json(optimum ? state.multiplier : kNoGain)},
                   {"worth", number_json(standing.worth)},
                   {"changes", Json::array()}};
  for (std::size_t k = 0; k < goals.size(); ++k)
    standing.json["changes"].push_back(
        number_json(optimum ? (goals[k].maximize ? 1 : -1) * gain[k] * step : kNoGain));
  return standing;
}

// Of one goal the multiplier itself; of several each gain while the others stay.
std::vector<double> gains_of(double multiplier, bool active, const DesignReport& report,
                             const std::vector<Goal>& goals) {
  if (goals.size() == 1) return {multiplier};
  std::vector<double> list;
  if (active) list = gains(multiplier, report.certificate);
  list.resize(goals.size(), kNoGain);
  return list;
}

Standing limit_standing(const LimitState& state, const DesignReport& report,
                        const std::vector<Goal>& goals) {
  const bool breaks = broken(state);
  const double millionth = 1e-6 * std::fabs(state.limit);
  const double allowance = breaks ? millionth : std::max(millionth, state.violation);
  const double distance = (state.at_least ? -1 : 1) * (state.limit - state.value);
  const double slack = std::fabs(distance) <= allowance ? 0 : distance;
  Standing standing = standing_of(state, state.at_least, report, goals,
                                  gains_of(state.multiplier, state.active, report, goals));
  standing.active = state.active && !breaks;
  standing.room = slack / (state.limit == 0 ? 1 : std::fabs(state.limit));
  const char* word = std::isnan(state.violation) ? "unreachable"
                     : std::isnan(state.value)   ? "unknown"
                     : breaks                    ? "broken"
                     : state.active              ? "binds"
                                                 : "holds";
  standing.json.update({{"text", state.text},
                        {"metric", state.metric},
                        {"unit", state.unit},
                        {"lower", number_json(state.lower)},
                        {"upper", number_json(state.upper)},
                        {"state", word},
                        {"value", number_json(state.value)},
                        {"slack", number_json(slack)},
                        {"violation", number_json(state.violation)},
                        {"tolerance", number_json(state.tolerance)},
                        {"allowance", number_json(allowance)}});
  return standing;
}

Standing bound_standing(const BoundState& state, const DesignReport& report,
                        const std::vector<Goal>& goals) {
  Standing standing = standing_of(state, !state.upper, report, goals,
                                  gains_of(state.multiplier, true, report, goals));
  standing.active = true;
  standing.json.update({{"variable", state.variable.name},
                        {"unit", state.variable.unit},
                        {"state", "binds"},
                        {"value", number_json(state.limit)},
                        {"slack", 0},
                        {"violation", 0},
                        {"tolerance", nullptr},
                        {"allowance", 0}});
  return standing;
}

// A limit that the others imply says nothing beside a stricter one of the user's.
bool is_told(const LimitState& state, const DesignReport& report) {
  const auto is_stricter = [&](const LimitState& other) {
    const double stricter = (state.at_least ? 1 : -1) * (other.limit - state.limit);
    return !other.implied && other.metric == state.metric && other.at_least == state.at_least &&
           stricter >= 0;
  };
  return !state.implied || std::ranges::none_of(report.constraints, is_stricter);
}

}  // namespace

Json standings_json(const DesignReport& report, const std::vector<Goal>& goals) {
  std::vector<Standing> list;
  for (const LimitState& state : report.constraints)
    if (is_told(state, report)) list.push_back(limit_standing(state, report, goals));
  for (const BoundState& state : report.bounds)
    list.push_back(bound_standing(state, report, goals));
  const auto rank = [](const Standing& s) {
    return std::tuple(!s.active, -s.worth, std::isnan(s.room) ? 0 : s.room);
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const Standing& a, const Standing& b) { return rank(a) < rank(b); });
  Json json = Json::array();
  for (Standing& standing : list) json.push_back(std::move(standing.json));
  return json;
}

}  // namespace twum::inline v0_1::studies
