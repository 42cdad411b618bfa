// SPDX-License-Identifier: Apache-2.0
#include "telling/failure_sections.hpp"

#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::inline v0_1::studies::telling {
namespace {

using BrokenLimit = UncertaintyResult::Limit;

/// A tolerance with less of the failures hardly causes any.
constexpr double kHardlyCauses = 0.05;

Phrase failing_interval(const Estimate& e, const auto& part) {
  if (!std::isfinite(e.value)) return {part(e.value)};
  return {part(e.low), " to ", part(e.high)};
}

Part share2(double share) { return share_part(share, 2); }

Part tolerance_name(const UncertaintyResult& answer, std::size_t k) {
  return name_part(answer.variables[k].name);
}

// Variables by their share in the failures.
std::vector<std::size_t> by_share(const UncertaintyResult& answer) {
  std::vector<std::size_t> order(answer.causes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](std::size_t k) { return answer.causes[k].value; });
  return order;
}

Table cause_table(const UncertaintyResult& answer, const std::vector<std::size_t>& order) {
  Table table{"causes",
              {{"tolerance"},
               {"of the failures"},
               {"at least"},
               {"at most"},
               {"yield gained if it is 1 % tighter"},
               {"interval"}},
              {}};
  for (const std::size_t k : order) {
    const Estimate& cause = answer.causes[k];
    const Estimate& gain = answer.tighter[k];
    table.rows.push_back({{tolerance_name(answer, k)},
                          {share2(cause.value)},
                          {share2(cause.low)},
                          {share2(cause.high)},
                          {share2(gain.value)},
                          failing_interval(gain, share2)});
  }
  return table;
}

Table limit_table(const UncertaintyResult& answer, const std::vector<std::size_t>& order) {
  Table table{"causes-by-limit", {{"limit"}}, {}};
  for (const std::size_t k : order) table.heads.push_back({tolerance_name(answer, k)});
  for (const BrokenLimit& limit : answer.limits) {
    if (limit.causes.empty()) continue;
    table.rows.push_back({{limit_part(limit.text)}});
    for (const std::size_t k : order)
      table.rows.back().push_back(
          {limit.causes[k].low > 0 ? share2(limit.causes[k].value) : Part("none found")});
  }
  return table;
}

std::vector<Phrase> cause_sentences(const UncertaintyResult& answer,
                                    const std::vector<std::size_t>& order) {
  const std::size_t first = order.front();
  std::vector<Phrase> list{{"The tolerance of ", strong(tolerance_name(answer, first)),
                            " causes most of the failures, ", share2(answer.causes[first].value),
                            ": tighten it first."}};
  std::vector<Part> hardly;
  for (const std::size_t k : order)
    if (answer.causes[k].high < kHardlyCauses) hardly.push_back(tolerance_name(answer, k));
  if (hardly.empty()) return list;
  Phrase phrase = listed(hardly);
  append(phrase, {hardly.size() == 1 ? " causes" : " each cause", " less than ",
                  share_part(kHardlyCauses), " of them: a wider tolerance may be sufficient."});
  list.push_back(capitalized(std::move(phrase)));
  return list;
}

// A thousand and more are whole numbers.
std::string in_a_million(double share) {
  const double count = 1e6 * share;
  return count < 1000 ? rounded_text(count, 3) : std::to_string(std::llround(count));
}

// "0.0123 in a million"
Phrase millions_phrase(double share) { return {in_a_million(share) + " in a million"}; }

}  // namespace

Phrase failing_phrase(const UncertaintyResult& answer) {
  const Estimate& failing = answer.broken;
  if (failing.value > 0) {
    Phrase phrase = strong(millions_phrase(failing.value));
    append(phrase, {" motors violate a limit (between " + in_a_million(failing.low) + " and " +
                        in_a_million(failing.high) + " with ",
                    share_part(answer.confidence, 3), " confidence)."});
    return phrase;
  }
  return {strong("No motor was found that violates a limit"), ": with ",
          share_part(answer.confidence, 3),
          " confidence fewer than " + in_a_million(failing.high) + " in a million do."};
}

Section failure_table_section(const UncertaintyResult& answer) {
  Section section{{"Limits"},
                  {"Motors in a million that violate each limit, with the ends of the ",
                   share_part(answer.confidence, 3),
                   " intervals. The index is the number of standard deviations between the design "
                   "and the most likely motor that violates the limit."}};
  Table table{"failures",
              {{"limit"},
               {"in a million violate it"},
               {"at least"},
               {"at most"},
               {"index"},
               {"most likely motor that violates it"}},
              {}};
  const auto add = [&](Part name, const Estimate& e, double index, Phrase likeliest) {
    std::vector<Phrase> row{{std::move(name)}};
    for (const double share : {e.value, e.low, e.high})
      row.push_back({value_part(1e6 * share, "1")});
    row.push_back({value_part(index, "1", 3)});
    row.push_back(std::move(likeliest));
    table.rows.push_back(std::move(row));
  };
  for (const BrokenLimit& limit : answer.limits) {
    Phrase likeliest{limit.likeliest.empty() ? "none found" : ""};
    for (std::size_t k = 0; k < limit.likeliest.size(); ++k)
      append(likeliest, {k == 0 ? "" : ", ", tolerance_name(answer, k), " ",
                         value_part(limit.likeliest[k], answer.variables[k].unit)});
    add(limit_part(limit.text), limit.broken, limit.index, std::move(likeliest));
  }
  add("any limit", answer.broken, std::nan(""), {""});
  section.tables = {table};
  return section;
}

std::vector<Section> cause_sections(const UncertaintyResult& answer) {
  if (!(answer.broken.value > 0) || !answer.parts.empty() || answer.variables.size() < 2) return {};
  Section section{{"Which tolerance causes the failures"}};
  if (answer.causes.empty()) {
    section.note = {answer.broken.value < 0.5 ? "The failing motors do not tell which tolerance is "
                                                "the cause: draw more, or use method 'importance'."
                                              : "So many motors violate a limit that no single "
                                                "tolerance is the cause: change the design."};
    return {section};
  }
  const std::vector<std::size_t> order = by_share(answer);
  section.note = {
      "Share of each tolerance in the failures, from the motors that violate a limit. It may "
      "differ from its share in the scatter of a metric."};
  section.bars.name = "causes";
  section.bars.title = {"which tolerance causes the failures"};
  section.bars.axis = {"of the failures"};
  section.bars.unit = "%";
  section.bars.of = 1;
  section.bars.low = 2;
  section.bars.high = 3;
  section.bars.full = 1;
  section.sentences = cause_sentences(answer, order);
  section.tables = {cause_table(answer, order)};
  if (Table limits = limit_table(answer, order); answer.limits.size() > 1 && !limits.rows.empty())
    section.tables.push_back(std::move(limits));
  return {section};
}

}  // namespace twum::inline v0_1::studies::telling
