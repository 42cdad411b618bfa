// SPDX-License-Identifier: Apache-2.0
#include "telling/curve_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

namespace twum::inline v0_1::studies::telling {
namespace {

// A variable is negligible if the upper end of its total index, or of its share of the largest effect, is below this.
constexpr double kNegligible = 0.01;
// What is smaller in parts of the largest effect is rounding.
constexpr double kRounding = 1e-9;

double or_zero(double value, double scale) {
  return std::fabs(value) <= kRounding * scale ? 0 : value;
}

// A share to 0.01 %, or to three digits from 10 % on: more is noise of the sample.
Part index_part(double share) {
  const double size = std::floor(std::log10(std::fabs(share)));
  const bool small = std::isfinite(size) && size < -2;
  return share_part(share, small ? static_cast<int>(std::fmax(5 + size, 1)) : 3);
}

// Variables in the order of a size, the largest first; NaN last.
std::vector<std::size_t> ranking(std::size_t count,
                                 const std::function<double(std::size_t)>& size) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto number = [&](std::size_t j) { return std::isnan(size(j)) ? -1.0 : size(j); };
  std::ranges::stable_sort(order, std::greater<>(), number);
  return order;
}

// The section of one metric: sorted bars with their numbers, and what follows from them.
class MetricSection {
 public:
  MetricSection(const SensitivityResult& answer, const MetricSensitivity& metric)
      : answer_(answer), metric_(metric), unit_(metric.metric.unit) {
    section_.heading = {name_part(metric.metric.name)};
    section_.wide = false;
    section_.folded = true;
    if (answer.method == SensitivityMethod::local && std::isfinite(metric.value))
      append(section_.heading, {": ", value_part(metric.value, unit_)});
    else if (std::isfinite(metric.value))
      section_.sentences.push_back(spread());
    if (!metric.note.empty()) section_.sentences.push_back({metric.note});
  }

  Section take() {
    const bool none =
        std::visit([](const auto& effects) { return effects.empty(); }, metric_.effects);
    if (!none)
      std::visit([&](const auto& effects) { add(effects); }, metric_.effects);
    else if (metric_.note.empty())
      section_.sentences.push_back({"No effect could be computed."});
    return std::move(section_);
  }

 private:
  Phrase spread() const {
    Phrase phrase{"Mean ", value_part(metric_.value, unit_), ", standard deviation ",
                  value_part(metric_.sd, unit_)};
    if (metric_.dropped > 0 && metric_.note.empty())
      append(phrase, {"; " + std::to_string(metric_.dropped) + " of " +
                      std::to_string(metric_.samples + metric_.dropped) +
                      " samples left out because they failed"});
    append(phrase, {"."});
    return phrase;
  }

  Part name(std::size_t j) const { return name_part(answer_.variables[j].name); }

  void say(Phrase phrase) { section_.sentences.push_back(std::move(phrase)); }

  void say_negligible(const std::vector<std::size_t>& list) {
    if (list.empty()) return;
    std::vector<Part> names;
    for (const std::size_t j : list) names.push_back(name(j));
    Phrase phrase = listed(names);
    append(phrase, {list.size() == 1 ? " has" : " have", " almost no influence (below 1 %)."});
    say(std::move(phrase));
  }

  void set_bars(const char* title, const char* axis, const std::string& unit) {
    section_.bars.name = "effects-" + metric_.metric.name;
    section_.bars.title = {name_part(metric_.metric.name), title};
    section_.bars.axis = {axis};
    section_.bars.unit = unit;
    section_.bars.of = 1;
  }

  void add(const MetricSensitivity::Sobol& estimates) {
    MetricSensitivity::Sobol shares;
    for (const SobolShares& one : estimates) shares.push_back(told_shares(one));
    section_.note = {
        "Share of the variance: alone (dark), with all interactions (light), and the interval of "
        "the latter. If the interactions do not exceed their interval, both are the same number."};
    Table table{"indices-" + metric_.metric.name,
                {{"variable"}, {"total"}, {"low"}, {"high"}, {"first order"}, {"low"}, {"high"}},
                {}};
    set_bars(", sources of its variance", "share of the variance", "%");
    section_.bars.low = 2;
    section_.bars.high = 3;
    section_.bars.inner = 4;
    section_.bars.inner_name = "alone";
    section_.bars.of_name = "with interactions";
    section_.bars.full = 1;
    const auto order = ranking(shares.size(), [&](std::size_t j) { return shares[j].total.value; });
    std::vector<std::size_t> negligible;
    double alone = 0;
    double doubt = 0;  // uncertainty of the sum of first indices
    for (const std::size_t j : order) {
      table.rows.push_back({{name(j)}});
      for (const Estimate& e : {shares[j].total, shares[j].first})
        for (const double value : {e.value, e.low, e.high})
          table.rows.back().push_back({index_part(value)});
      if (shares[j].total.high < kNegligible) negligible.push_back(j);
      section_.bars.full = std::fmax(section_.bars.full, shares[j].total.high);
      alone += shares[j].first.value;
      doubt += shares[j].first.high - shares[j].first.value;
    }
    section_.tables = {table};
    const SobolShares& most = shares[order.front()];
    if (!std::isfinite(most.total.value)) return;
    Phrase phrase{name(order.front()), " has the largest influence: alone it explains ",
                  share_part(std::max(0.0, most.first.value), 3), " of the variance"};
    if (most.interactions.low > 0)
      append(phrase, {", with its interactions ", share_part(most.total.value, 3)});
    append(phrase, {"."});
    say(std::move(phrase));
    if (1 - alone > std::max(kNegligible, doubt))
      say({"Interactions explain ", share_part(1 - alone, 3), "."});
    say_negligible(negligible);
  }

  void add(const MetricSensitivity::Morris& effects) {
    section_.note = {
        "Mean absolute change across each range (µ*), with its interval. A large σ indicates "
        "curvature or interaction."};
    Table table{"indices-" + metric_.metric.name,
                {{"variable"}, {"µ*"}, {"low"}, {"high"}, {"σ"}, {"low"}, {"high"}, {"µ"}},
                {}};
    set_bars(", change across each range", "change", unit_);
    section_.bars.low = 2;
    section_.bars.high = 3;
    const auto order =
        ranking(effects.size(), [&](std::size_t j) { return effects[j].mu_star.value; });
    const ElementaryEffect& most = effects[order.front()];
    std::vector<std::size_t> negligible;
    for (const std::size_t j : order) {
      const ElementaryEffect& e = effects[j];
      table.rows.push_back({{name(j)}});
      for (const double value : {e.mu_star.value, e.mu_star.low, e.mu_star.high, e.sigma.value,
                                 e.sigma.low, e.sigma.high, e.mu})
        table.rows.back().push_back({value_part(or_zero(value, most.mu_star.value), unit_)});
      section_.bars.full =
          std::fmax(section_.bars.full, std::fmax(e.mu_star.value, e.mu_star.high));
      if (e.mu_star.high <= kNegligible * most.mu_star.value) negligible.push_back(j);
    }
    section_.tables = {table};
    if (most.mu_star.value == 0) return say({"No variable has an influence."});
    say({name(order.front()), " has the largest influence: across its range it changes ",
         name_part(metric_.metric.name), " by ", value_part(most.mu_star.value, unit_, 3),
         " on average."});
    say_negligible(negligible);
  }

  // The scatter of the metric by each tolerance alone, to first order.
  void add_spreads(const MetricSensitivity::Local& effects) {
    section_.note = {
        "Standard deviation of the metric from each tolerance alone, to first order, and its share "
        "of the variance."};
    Table table{
        "indices-" + metric_.metric.name,
        {{"tolerance"}, {"of the variance"}, {"standard deviation"}, {"about"}, {"gradient"}},
        {}};
    set_bars(", sources of its variance to first order", "share of the variance", "%");
    section_.bars.full = 1;
    const auto order = ranking(effects.size(), [&](std::size_t j) { return effects[j].spread; });
    const double variance = metric_.sd * metric_.sd;
    for (const std::size_t j : order)
      table.rows.push_back({{name(j)},
                            {share_part(effects[j].spread * effects[j].spread / variance, 3)},
                            {value_part(effects[j].spread, unit_)},
                            {value_part(answer_.motor[j], answer_.variables[j].unit)},
                            gradient(effects[j].gradient, answer_.variables[j].unit)});
    section_.tables = {table};
    const double most = effects[order.front()].spread;
    if (most > 0)
      say({"The tolerance of ", name(order.front()), " has the largest influence: it explains ",
           share_part(most * most / variance, 3), " of the variance. The standard deviation is ",
           value_part(metric_.sd, unit_), " to first order."});
    say_smoothness();
  }

  void add(const MetricSensitivity::Local& effects) {
    if (answer_.tolerances) return add_spreads(effects);
    section_.note = {
        "Change of the metric for 1 % more of the variable: bars to the right where it rises, "
        "to the left where it falls."};
    Table table{
        "indices-" + metric_.metric.name, {{"variable"}, {"elasticity"}, {"at"}, {"gradient"}}, {}};
    set_bars(", change for 1 % more", "change", "%");
    section_.bars.both_ways = true;
    const auto size = [&](std::size_t j) { return std::fabs(effects[j].elasticity); };
    const auto order = ranking(effects.size(), size);
    const double most = size(order.front());
    for (const std::size_t j : order) {
      const StoredColumn& variable = answer_.variables[j];
      const double share = or_zero(effects[j].elasticity, most);
      const double slope = share == 0 ? 0 : effects[j].gradient;
      table.rows.push_back({{name(j)},
                            {share_part(0.01 * share, 3)},
                            {value_part(answer_.motor[j], variable.unit)},
                            gradient(slope, variable.unit)});
    }
    section_.tables = {table};
    if (most > 0)
      say({name(order.front()), " has the largest influence: 1 % more of it changes ",
           name_part(metric_.metric.name), " by ",
           share_part(0.01 * effects[order.front()].elasticity, 3), "."});
    say_smoothness();
  }

  Phrase gradient(double value, const std::string& unit) const {
    if (!std::isfinite(value)) return {value_part(value, unit_)};
    return {value_part(value, unit_), " per " + unit};
  }

  void say_smoothness() {
    switch (metric_.smoothness) {
      case Smoothness::smooth: return;
      case Smoothness::flat:
        return say(
            {"The metric is constant near this point: a gradient of zero holds only nearby."});
      case Smoothness::one_sided:
        return say({"The metric has a kink or a jump here: the gradients are those of one side."});
      case Smoothness::undefined: return say({"The metric has no derivative here."});
    }
  }

  const SensitivityResult& answer_;
  const MetricSensitivity& metric_;
  std::string unit_;
  Section section_;
};

Section method_section(const SensitivityResult& answer) {
  Section section{{"How the effects were computed"}};
  const Phrase level{"; intervals of ", share_part(answer.confidence, 3), "."};
  if (answer.method == SensitivityMethod::local) {
    section.sentences = {{"Derivatives at the given motor."}};
    for (const StoredColumn& variable : answer.variables)
      if (const auto p = find_parameter(variable.name); p && info(*p).integer)
        section.sentences.push_back({name_part(variable.name),
                                     " takes whole numbers only; its derivative is that of the "
                                     "continuous model between them."});
    return section;
  }
  const std::string count = std::to_string(answer.samples);
  section.sentences = {
      {answer.method == SensitivityMethod::morris
           ? "Elementary effects across the ranges (Morris), " + count + " trajectories"
           : std::string("Shares of the variance ") +
                 (answer.tolerances ? "from the tolerances, which are independent " : "") +
                 "(Sobol), " + count + " base samples"}};
  append(section.sentences.front(), level);
  if (!answer.narrow)
    section.sentences.push_back({"Some intervals are still wider than the ",
                                 value_part(answer.width, "1", 3),
                                 " requested: raise max_samples."});
  return section;
}

}  // namespace

SobolShares told_shares(const SobolShares& shares) {
  if (shares.interactions.low > 0 || !std::isfinite(shares.interactions.low)) return shares;
  const auto width = [](const Estimate& e) { return e.high - e.low; };
  SobolShares one = shares;
  one.first = one.total = width(shares.first) < width(shares.total) ? shares.first : shares.total;
  return one;
}

std::vector<Section> sections_of(const SensitivityResult& answer, const Sources& sources) {
  std::vector<Section> list;
  for (const MetricSensitivity& metric : answer.metrics)
    list.push_back(MetricSection(answer, metric).take());
  list.push_back(method_section(answer));
  std::ranges::move(motor_sections(sources), std::back_inserter(list));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
