// SPDX-License-Identifier: Apache-2.0
#include "results/search_words.hpp"
#include "telling/failure_sections.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

using Look = Headline::Look;

/// A yield from here on is good, a lower one a warning.
constexpr double kGoodYield = 0.95;
/// Values that differ by less are the same but for rounding, of their size.
constexpr double kSame = 1e-9;

Headline plain_headline(std::vector<Phrase> sentences) {
  return {Look::plain, "", std::move(sentences), {}};
}
Headline bad_headline(std::vector<Phrase> sentences) {
  return {Look::bad, "", std::move(sentences), {}};
}

NamedValue metric_of(const CurveResult::Member& member, const std::string& name) {
  for (const NamedValue& metric : member.metrics)
    if (metric.name == name) return metric;
  return {name, "1", std::nan("")};
}

Part metric_part(const CurveResult::Member& member, const std::string& name) {
  const NamedValue metric = metric_of(member, name);
  return value_part(metric.value, metric.unit);
}

// Of a motor without a peak power: what else there is.
Phrase known_phrase(const CurveResult::Member& member) {
  Phrase phrase;
  for (const char* name : {"stall_torque", "no_load_speed"})
    if (std::isfinite(metric_of(member, name).value))
      append(phrase, {phrase.empty() ? "Its " : ", its ", name_part(name), " is ",
                      metric_part(member, name)});
  if (!phrase.empty()) phrase.push_back(".");
  return phrase;
}

Headline motor_headline(const CurveResult::Member& member) {
  const double peak = metric_of(member, "peak_power").value;
  if (std::isnan(peak)) {
    Phrase phrase{strong("This motor has no peak power that could be computed. ")};
    append(phrase, known_phrase(member));
    return bad_headline({phrase});
  }
  if (!(peak > 0))
    return bad_headline({{strong("This motor cannot drive a load: "), "its torque at stall is ",
                          metric_part(member, "stall_torque"), "."}});
  return plain_headline({{"This motor holds ", strong(metric_part(member, "stall_torque")),
                          " at stall and runs up to ", strong(metric_part(member, "no_load_speed")),
                          " without load."},
                         {"It gives at most ", strong(metric_part(member, "peak_power")), " (at ",
                          metric_part(member, "speed_at_peak_power"), ", ",
                          metric_part(member, "torque_at_peak_power"), ")."}});
}

Part member_part(const CurveResult& answer, const CurveResult::Member& member) {
  return value_part(member.value, answer.family->unit);
}

// The member with the most of a metric; empty if none has it.
Phrase most_phrase(const CurveResult& answer, const std::string& name) {
  const CurveResult::Member* top = nullptr;
  double most = 0, least = 0;
  for (const CurveResult::Member& member : answer.members) {
    const double value = metric_of(member, name).value;
    if (std::isnan(value)) continue;
    least = top == nullptr ? value : std::min(least, value);
    if (top != nullptr && !(value > most)) continue;
    top = &member;
    most = value;
  }
  if (top == nullptr) return {};
  Phrase phrase{name_part(name), " ", strong(metric_part(*top, name))};
  if (most - least <= kSame * std::fabs(most))
    append(phrase, {" (the same for all)"});
  else
    append(phrase, {" with ", name_part(answer.family->name), " ", member_part(answer, *top)});
  return phrase;
}

// Phrases that are there, with a sign between them.
Phrase joined(const std::vector<Phrase>& list, const std::string& sign) {
  Phrase phrase;
  for (const Phrase& one : list) {
    if (one.empty()) continue;
    if (!phrase.empty()) phrase.push_back(sign);
    append(phrase, one);
  }
  return phrase;
}

Headline family_headline(const CurveResult& answer) {
  const Phrase first{strong(std::to_string(answer.members.size()) + " motors"),
                     " that differ in ",
                     name_part(answer.family->name),
                     ", from ",
                     member_part(answer, answer.members.front()),
                     " to ",
                     member_part(answer, answer.members.back()),
                     "."};
  const Phrase tops =
      joined({most_phrase(answer, "peak_power"), most_phrase(answer, "stall_torque"),
              most_phrase(answer, "no_load_speed")},
             "; ");
  if (tops.empty()) return plain_headline({first});
  Phrase second{"Largest values: "};
  append(second, tops);
  second.push_back(".");
  return plain_headline({first, second});
}

// Size of an effect, by which variables are sorted; NaN: none.
double size_of(const LocalEffect& effect) {
  return std::isfinite(effect.spread) ? effect.spread : std::fabs(effect.elasticity);
}
double size_of(const ElementaryEffect& effect) { return effect.mu_star.value; }
double size_of(const SobolShares& effect) { return told_shares(effect).total.value; }

Phrase effect_phrase(const LocalEffect& effect, const std::string& unit) {
  if (std::isfinite(effect.spread))
    return {value_part(effect.spread, unit, 3), " for one standard deviation"};
  return {value_part(effect.elasticity, "1", 3), " % for 1 % more"};
}
Phrase effect_phrase(const ElementaryEffect& effect, const std::string& unit) {
  return {value_part(effect.mu_star.value, unit, 3), " across its range"};
}
Phrase effect_phrase(const SobolShares& effect, const std::string& /*unit*/) {
  return {share_part(size_of(effect), 3), " of its variance"};
}

/// Effects below this part of the largest one hardly matter.
constexpr double kHardly = 0.01;

struct Ranked {
  const MetricSensitivity* metric;
  Phrase effect;            // of the first
  std::vector<Part> names;  // of the largest effects, at most three that matter
  bool others{false};       // there are more variables
};

// The variables of a metric by their effect; without names where there are no effects.
Ranked ranked(const SensitivityResult& answer, const MetricSensitivity& metric) {
  return std::visit(
      [&](const auto& effects) {
        Ranked list{&metric, {}, {}, effects.size() > 1};
        std::vector<std::size_t> order(effects.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto size = [&](std::size_t i) {
          return std::isfinite(size_of(effects[i])) ? size_of(effects[i]) : -1.0;
        };
        std::ranges::stable_sort(order, std::greater<>(), size);
        for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 3); ++i)
          if (i == 0 || size(order[i]) > kHardly * size(order[0]))
            list.names.push_back(name_part(answer.variables[order[i]].name));
        if (!order.empty()) list.effect = effect_phrase(effects[order[0]], metric.metric.unit);
        return list;
      },
      metric.effects);
}

Phrase first_effects(const Ranked& one) {
  Phrase phrase{name_part(one.metric->metric.name), ": ", strong(one.names.front()),
                " has the largest influence ("};
  append(phrase, one.effect);
  phrase.push_back(")");
  if (one.names.size() > 1) {
    append(phrase, {", then "});
    append(phrase, listed({one.names.begin() + 1, one.names.end()}));
  } else if (one.others) {
    append(phrase, {"; the others have little"});
  }
  phrase.push_back(".");
  return phrase;
}

Phrase further_effects(const std::vector<Ranked>& list) {
  Phrase phrase;
  for (std::size_t k = 1; k < list.size(); ++k) {
    append(phrase,
           {k > 1 ? "; " : "The largest influence on the ", name_part(list[k].metric->metric.name),
            ": ", strong(list[k].names.front()), " ("});
    append(phrase, list[k].effect);
    phrase.push_back(")");
  }
  if (!phrase.empty()) phrase.push_back(".");
  return phrase;
}

Phrase spread_sentence(const UncertaintyResult& answer) {
  Phrase phrase{"Mean and standard deviation: "};
  for (const UncertaintyResult::Metric& metric : answer.metrics)
    append(phrase, {&metric == &answer.metrics.front() ? "" : "; ", name_part(metric.column.name),
                    " ", value_part(metric.mean.value, metric.column.unit), " ± ",
                    value_part(metric.sd.value, metric.column.unit, 2)});
  phrase.push_back(".");
  return phrase;
}

}  // namespace

Phrase design_phrase(const SweepResult& answer, const SweepResult::Design& design) {
  Phrase phrase;
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    const StoredColumn& variable = answer.variables[i];
    const std::string* word = variable.word(design.variables[i]);
    append(phrase, {i > 0 ? ", " : "", name_part(variable.name), " ",
                    word != nullptr ? Part(printable(*word))
                                    : value_part(design.variables[i], variable.unit, 3)});
  }
  return phrase;
}

Headline headline_of(const CurveResult& answer, const StudyResult& /*result*/) {
  if (answer.members.empty()) return bad_headline({{strong("No curve could be computed.")}});
  return answer.family ? family_headline(answer) : motor_headline(answer.members.front());
}

Headline headline_of(const SweepResult& answer, const StudyResult& /*result*/) {
  Phrase first{strong(counted(answer.stored, "design"))};
  append(first, {answer.failed == 0
                     ? std::string(".")
                     : ", " + std::to_string(answer.failed) + " of them failed or incomplete."});
  const auto metric =
      std::ranges::find_if(answer.metrics, [](const auto& one) { return one.count > 0; });
  if (metric == answer.metrics.end()) return bad_headline({first});
  const auto value = [&](double v) { return strong(value_part(v, metric->column.unit)); };
  const Part name = strong(name_part(metric->column.name));
  if (metric->min == metric->max)
    return plain_headline(
        {first, {"The ", name, " is the same in all: ", value(metric->max), "."}});
  Phrase second{"The ",  name, " ranges from ", value(metric->min), " to ", value(metric->max),
                " with "};
  append(second, design_phrase(answer, metric->highest));
  second.push_back(".");
  return plain_headline({first, second});
}

Headline headline_of(const SensitivityResult& answer, const StudyResult& /*result*/) {
  std::vector<Ranked> list;
  for (const MetricSensitivity& metric : answer.metrics)
    if (Ranked one = ranked(answer, metric); !one.names.empty()) list.push_back(std::move(one));
  if (list.empty()) return bad_headline({{strong("No effect could be computed.")}});
  const Phrase further = further_effects(list);
  return further.empty() ? plain_headline({first_effects(list[0])})
                         : plain_headline({first_effects(list[0]), further});
}

Headline headline_of(const UncertaintyResult& answer, const StudyResult& /*result*/) {
  if (answer.samples == 0) return bad_headline({{strong("No motor was computed.")}});
  if (!answer.yield) return plain_headline({spread_sentence(answer)});
  const Estimate& kept = *answer.yield;
  const Phrase yield{strong(share_part(kept.value)),
                     " of the motors keep every limit (between ",
                     share_part(kept.low),
                     " and ",
                     share_part(kept.high),
                     " with ",
                     share_part(answer.confidence, 3),
                     " confidence)."};
  const bool few = answer.broken.value > 0 && answer.broken.value < kFewViolate;
  const Phrase first = answer.weighted || few ? failing_phrase(answer) : yield;
  const auto worst = std::ranges::min_element(
      answer.limits, {}, [](const UncertaintyResult::Limit& limit) { return limit.kept.value; });
  const Phrase cost{"The limit that costs the most yield is ", strong(limit_part(worst->text)),
                    ": ", share_part(worst->kept.value), " keep it."};
  Headline told{kept.low >= kGoodYield ? Look::good : Look::bad, "", {first}, {}};
  if (worst->kept.value < 1)
    told.sentences.push_back(cost);
  else if (!answer.metrics.empty())
    told.sentences.push_back(spread_sentence(answer));
  return told;
}

Headline headline_of(const FrequencyResult& answer, const StudyResult& /*result*/) {
  if (answer.members.empty() || !answer.members.front().running)
    return bad_headline({{strong("There is no running wave"), " at the frequency of the drive."}});
  const FrequencyResult::Member& member = answer.members.front();
  Phrase first{"At its drive frequency of ", value_part(member.frequency, "Hz", 5), " the motor"};
  if (answer.family)
    append(first, {" with ", name_part(answer.family->name), " ",
                   value_part(member.value, answer.family->unit)});
  append(first,
         {" runs at ", strong(value_part(member.running->point.speed, "rad/s")), " with a wave of ",
          strong(value_part(member.running->point.amplitude, "m")), "."});
  if (!member.pull_out_below)
    return plain_headline({first, {"The wave does not pull out in the range."}});
  return plain_headline(
      {first,
       {"The wave pulls out below ", value_part(*member.pull_out_below, "Hz", 5), ", a margin of ",
        strong(value_part(member.frequency - *member.pull_out_below, "Hz", 3)), "."}});
}

}  // namespace twum::inline v0_1::studies::telling
