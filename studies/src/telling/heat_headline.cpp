// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/heat_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

using Motor = HeatResult::Member;
using Steady = HeatResult::Steady;

// The motor that is nearest to a limit, or has no answer, is told.
const Motor& hottest(const HeatResult& answer) {
  const auto left = [](const Motor& motor) {
    if (motor.steady && !is_steady(motor)) return -std::numeric_limits<double>::infinity();
    const double steady = is_steady(motor) ? nearest_limit(motor, motor.steady->temperatures).margin
                                           : std::numeric_limits<double>::infinity();
    const double cycle = has_cycle(motor) ? nearest_limit(motor, motor.cycle->found.peak).margin
                                          : std::numeric_limits<double>::infinity();
    return std::min(steady, cycle);
  };
  return *std::ranges::min_element(answer.members, {}, left);
}

Phrase temperature_sentence(const Motor& motor, const PartTemperatures& temperatures,
                            const char* verb) {
  const Nearest near = nearest_limit(motor, temperatures);
  const std::size_t part = std::isfinite(near.margin) ? near.part : 0;
  Phrase phrase{"the " + part_name(motor, part) + " " + verb + " ",
                strong(celsius_part(at(temperatures, kHeated[part].part)))};
  if (!std::isfinite(near.margin))
    append(phrase, {"; no temperature limit is given"});
  else if (near.margin < 0)
    append(phrase, {", ", bad("too hot"), " by ", value_part(-near.margin, "K", 3)});
  else
    append(phrase, {", ", value_part(near.margin, "K", 3), " below its limit"});
  return phrase;
}

Phrase steady_sentence(const HeatResult& answer, const Motor& motor) {
  Phrase phrase{"Under "};
  append(phrase, load_phrase(*answer.load));
  if (answer.family) append(phrase, {" and with "}), append(phrase, heated_phrase(answer, motor));
  const Steady& steady = *motor.steady;
  append(phrase, {" "});
  if (steady.status == "ok") {
    append(phrase, temperature_sentence(motor, steady.temperatures, "reaches"));
    if (steady.on_time_status == "ok")
      append(phrase, {"; from cold it may run for ", strong(time_part(steady.on_time))});
  } else if (steady.lost_after > 0) {
    append(phrase,
           {"the motor ", bad("loses its load"), " after ", strong(time_part(steady.lost_after))});
  } else {
    append(phrase,
           {"the motor has ", bad("no steady temperature"), ": " + reason_of(steady.status)});
  }
  append(phrase, {"."});
  return phrase;
}

Phrase cycle_sentence(const HeatResult& answer, const Motor& motor) {
  Phrase phrase{"Over its operation "};
  if (answer.family)
    append(phrase, {"and with "}), append(phrase, heated_phrase(answer, motor)),
        append(phrase, {" "});
  if (motor.cycle->status == "ok")
    append(phrase, temperature_sentence(motor, motor.cycle->found.peak, "peaks at"));
  else
    append(phrase,
           {"the motor has ", bad("no temperatures"), ": " + reason_of(motor.cycle->status)});
  append(phrase, {"."});
  return phrase;
}

bool keeps_limits(const Motor& motor) {
  if (motor.steady && !is_steady(motor)) return false;
  if (motor.cycle && !has_cycle(motor)) return false;
  if (is_steady(motor) && nearest_limit(motor, motor.steady->temperatures).margin < 0) return false;
  return !has_cycle(motor) || !(nearest_limit(motor, motor.cycle->found.peak).margin < 0);
}

}  // namespace

Headline headline_of(const HeatResult& answer, const StudyResult& /*result*/) {
  const Motor& motor = hottest(answer);
  std::vector<Phrase> sentences;
  if (motor.steady) sentences.push_back(steady_sentence(answer, motor));
  if (motor.cycle) sentences.push_back(cycle_sentence(answer, motor));
  return {keeps_limits(motor) ? Headline::Look::plain : Headline::Look::bad,
          "",
          sentences,
          {},
          {},
          "points",
          "without a temperature"};
}

}  // namespace twum::inline v0_1::studies::telling
