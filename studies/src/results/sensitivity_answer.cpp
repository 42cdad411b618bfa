// SPDX-License-Identifier: Apache-2.0
#include "results/estimate_json.hpp"
#include "results/search_words.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::studies {
namespace {

// A variable is negligible if the upper end of its total index, or of its share of the largest effect, is below this.
constexpr double kNegligible = 0.01;

Json effect_json(const SobolShares& shares) {
  Json json{{"first", estimate_json(shares.first)}, {"total", estimate_json(shares.total)}};
  if (std::isfinite(shares.derivative_bound.value))
    json["derivative_bound"] = estimate_json(shares.derivative_bound);
  return json;
}

Json effect_json(const ElementaryEffect& effect) {
  return {{"mu_star", number_json(effect.mu_star.value)},
          {"sigma", number_json(effect.sigma.value)},
          {"mu", number_json(effect.mu)},
          {"mu_star_interval", interval_json(effect.mu_star)},
          {"sigma_interval", interval_json(effect.sigma)}};
}

Json effect_json(const LocalEffect& effect) {
  return {{"gradient", number_json(effect.gradient)},
          {"elasticity", number_json(effect.elasticity)}};
}

Json effects_json(const SensitivityResult& result, const MetricSensitivity& metric) {
  return std::visit(
      [&](const auto& effects) {
        if (effects.empty()) return Json(nullptr);
        Json json = Json::object();
        for (std::size_t j = 0; j < effects.size(); ++j)
          json[result.variables[j].name] = effect_json(effects[j]);
        return json;
      },
      metric.effects);
}

Json metric_json(const SensitivityResult& result, const MetricSensitivity& metric) {
  Json json = Json::object();
  if (result.method == "local") {
    json["value"] = number_json(metric.value);
    json["smoothness"] = to_string(metric.smoothness);
  } else {
    json["mean"] = number_json(metric.value);
    json["sd"] = number_json(metric.sd);
    json["samples"] = metric.samples;
    json["dropped"] = metric.dropped;
  }
  if (!metric.note.empty()) json["note"] = metric.note;
  return json;
}

// Variables in the order of a size, the largest first; NaN last.
template <typename Size>
std::vector<std::size_t> ranking(std::size_t count, Size size) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto number = [&](std::size_t j) { return std::isnan(size(j)) ? -1.0 : size(j); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return number(a) > number(b); });
  return order;
}

std::string fixed(double value) {
  if (!std::isfinite(value)) return "-";
  const double rounded = std::round(value * 1000) / 1000;
  std::string text = number_text(rounded == 0 ? 0.0 : rounded);
  if (text.find('e') != std::string::npos) return text;
  if (text.find('.') == std::string::npos) text += '.';
  const std::size_t decimals = text.size() - text.find('.') - 1;
  return text.append(decimals < 3 ? 3 - decimals : 0, '0');
}

std::string fixed(const Estimate& e) {
  return fixed(e.value) + "  (" + fixed(e.low) + " to " + fixed(e.high) + ")";
}

std::string with_unit(const Estimate& e, const std::string& unit) {
  const auto text = [&](double v) { return std::isfinite(v) ? engineering(v, unit) : "-"; };
  return text(e.value) + "  (" + text(e.low) + " to " + text(e.high) + ")";
}

std::string without_influence_sentence(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return enumeration(names) + (names.size() == 1 ? " does" : " do") + " not matter.\n";
}

std::string share_text(double share) { return rounded_text(100 * share, 3) + " %"; }

// The text for one metric: a sorted table, then sentences.
class MetricText {
 public:
  MetricText(const SensitivityResult& result, const MetricSensitivity& metric)
      : result_(result), metric_(metric) {}

  std::string operator()(const MetricSensitivity::Sobol& shares) const {
    const auto order = ranking(shares.size(), [&](std::size_t j) { return shares[j].total.value; });
    TextTable table{{{"variable", "first order", "total"}}};
    std::vector<std::string> without_influence;
    double alone = 0;
    double doubt = 0;  // uncertainty of the sum of first indices
    for (const std::size_t j : order) {
      table.rows.push_back({name(j), fixed(shares[j].first), fixed(shares[j].total)});
      if (shares[j].total.high < kNegligible) without_influence.push_back(name(j));
      alone += shares[j].first.value;
      doubt += shares[j].first.high - shares[j].first.value;
    }
    const SobolShares& most = shares[order.front()];
    if (!std::isfinite(most.total.value)) return aligned(table);
    std::string text = aligned(table) + name(order.front()) + " matters most: alone it explains " +
                       share_text(std::max(0.0, most.first.value)) + " of the variance";
    if (most.total.low > most.first.high)  // else the difference may be noise
      text += ", with its interactions " + share_text(most.total.value);
    text += ".\n";
    if (1 - alone > std::max(kNegligible, doubt))
      text += "Interactions explain " + share_text(1 - alone) + ".\n";
    return text + without_influence_sentence(without_influence);
  }

  std::string operator()(const MetricSensitivity::Morris& effects) const {
    const auto order =
        ranking(effects.size(), [&](std::size_t j) { return effects[j].mu_star.value; });
    const ElementaryEffect& most = effects[order.front()];
    TextTable table{{{"variable", "mu*", "sigma"}}};
    std::vector<std::string> without_influence;
    for (const std::size_t j : order) {
      table.rows.push_back({name(j), with_unit(effects[j].mu_star, metric_.metric.unit),
                            with_unit(effects[j].sigma, metric_.metric.unit)});
      if (effects[j].mu_star.high <= kNegligible * most.mu_star.value)
        without_influence.push_back(name(j));
    }
    if (most.mu_star.value == 0) return aligned(table) + "No variable changes it.\n";
    return aligned(table) + name(order.front()) + " matters most: across its range it changes " +
           metric_.metric.name + " by " + engineering(most.mu_star.value, metric_.metric.unit, 3) +
           " on average.\n" + without_influence_sentence(without_influence);
  }

  std::string operator()(const MetricSensitivity::Local& effects) const {
    const auto size = [&](std::size_t j) { return std::abs(effects[j].elasticity); };
    const auto order = ranking(effects.size(), size);
    TextTable table{{{"variable", "at", "elasticity", "gradient"}}};
    for (const std::size_t j : order) {
      table.rows.push_back({name(j), engineering(result_.motor[j], result_.variables[j].unit),
                            fixed(effects[j].elasticity), gradient(effects[j].gradient, j)});
    }
    std::string text = aligned(table);
    if (size(order.front()) > 0) {
      text += name(order.front()) + " matters most: 1 % more of it changes " + metric_.metric.name +
              " by " + rounded_text(effects[order.front()].elasticity, 3) + " %.\n";
    }
    return text + smoothness_sentence();
  }

 private:
  const std::string& name(std::size_t j) const { return result_.variables[j].name; }

  std::string gradient(double value, std::size_t j) const {
    if (!std::isfinite(value)) return "-";
    return engineering(value, metric_.metric.unit) + " per " + result_.variables[j].unit;
  }

  std::string smoothness_sentence() const {
    switch (metric_.smoothness) {
      case Smoothness::smooth: return {};
      case Smoothness::flat:
        return "It sits on a plateau here: a gradient of zero holds nearby only.\n";
      case Smoothness::one_sided:
        return "It has a kink or jump here: gradients are those of one side.\n";
      case Smoothness::undefined: return "It has no derivative here.\n";
    }
    return {};
  }

  const SensitivityResult& result_;
  const MetricSensitivity& metric_;
};

std::string heading(const SensitivityResult& result, const MetricSensitivity& metric) {
  std::string text = metric.metric.name;
  if (!std::isfinite(metric.value)) return text + "\n";
  if (result.method == "local")
    return text + ": " + engineering(metric.value, metric.metric.unit) + "\n";
  text += ": mean " + engineering(metric.value, metric.metric.unit) + ", standard deviation " +
          engineering(metric.sd, metric.metric.unit);
  if (metric.dropped > 0 && metric.note.empty()) {
    text += "; " + std::to_string(metric.dropped) + " of " +
            std::to_string(metric.samples + metric.dropped) + " samples dropped for a failure";
  }
  return text + "\n";
}

std::string whole_numbers_text(const SensitivityResult& result) {
  std::string text;
  for (const StoredColumn& variable : result.variables) {
    const auto parameter = find_parameter(variable.name);
    if (parameter && info(*parameter).integer)
      text += variable.name + " takes whole numbers only; its derivative is that between them.\n";
  }
  return text;
}

std::string frame_text(const SensitivityResult& result) {
  if (result.method == "local") return "Derivatives at the motor\n" + whole_numbers_text(result);
  const std::string level = share_text(result.confidence) + " intervals";
  if (result.method == "morris") {
    return "Elementary effects across the ranges (Morris), " + std::to_string(result.samples) +
           " trajectories, " + level + "\n";
  }
  std::string text = "Shares of the variance (Sobol), " + std::to_string(result.samples) +
                     " base samples, " + level + "\n";
  if (!result.narrow) {
    text += "Some intervals are still wider than the " + rounded_text(result.width, 3) +
            " asked for: raise max_samples.\n";
  }
  return text;
}

}  // namespace

Json answer_json(const SensitivityResult& result) {
  Json json{{"method", result.method}};
  if (result.method != "local") {
    json["confidence"] = result.confidence;
    json["samples"] = result.samples;
  }
  if (result.width > 0) {
    json["width"] = result.width;
    json["narrow"] = result.narrow;
  }
  json["indices"] = Json::object();
  json["metrics"] = Json::object();
  json["units"] = Json::object();
  for (std::size_t j = 0; j < result.variables.size(); ++j) {
    json["units"][result.variables[j].name] = result.variables[j].unit;
    if (!result.motor.empty()) json["at"][result.variables[j].name] = result.motor[j];
  }
  for (const MetricSensitivity& metric : result.metrics) {
    json["units"][metric.metric.name] = metric.metric.unit;
    json["indices"][metric.metric.name] = effects_json(result, metric);
    json["metrics"][metric.metric.name] = metric_json(result, metric);
  }
  return json;
}

std::string answer_text(const SensitivityResult& result) {
  std::string text = frame_text(result);
  for (const MetricSensitivity& metric : result.metrics) {
    text += "\n" + heading(result, metric);
    if (!metric.note.empty()) text += metric.note + "\n";
    text += std::visit(
        [&](const auto& effects) {
          return effects.empty() ? std::string() : MetricText(result, metric)(effects);
        },
        metric.effects);
  }
  return text;
}

}  // namespace twum::studies
