// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/robust_report.hpp"

#include <twum/studies/estimate.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::size_t kBins = 60;

Estimate share_estimate(const optim::YieldEstimate& yield) {
  return {yield.value, yield.low, yield.high};
}

std::string target_name(const optim::RobustProblem& posed, std::size_t target) {
  return posed.yields[target].name;
}

std::string unit_of_statistic(const RobustQuestion& question, const std::string& name) {
  for (const DesignObjective& goal : question.design.objectives)
    if (goal.text() == name) return goal.unit();
  const auto asked =
      std::find_if(question.statistics.begin(), question.statistics.end(),
                   [&](const StatisticLimit& s) { return s.statistic.text == name; });
  return asked->statistic.unit();
}

std::vector<RobustStatistic> statistics_of(const RobustQuestion& question,
                                           const optim::RobustProblem& posed,
                                           const optim::Verification& seen) {
  std::vector<RobustStatistic> list;
  for (std::size_t s = 0; s < seen.statistics.size(); ++s) {
    const optim::StatisticTarget& target = posed.statistics[s];
    list.push_back({target.name, unit_of_statistic(question, target.name), target.lower,
                    target.upper, seen.statistics[s]});
  }
  return list;
}

std::vector<RobustLimit> risk_limits(const optim::RobustProblem& posed,
                                     const optim::RobustResult& found) {
  std::vector<RobustLimit> list;
  for (const optim::RiskShare& risk : found.risks) {
    RobustLimit limit{risk.limit, risk.side == optim::Side::lower, target_name(posed, risk.target)};
    limit.beta = risk.beta;
    limit.delta = risk.delta;
    limit.probability = risk.probability;
    limit.share = risk.share;
    limit.converged = risk.converged;
    for (std::size_t k = 0; k < risk.importance.size(); ++k)
      limit.importance.push_back({posed.inputs[k].name, "1", risk.importance[k]});
    list.push_back(std::move(limit));
  }
  return list;
}

Estimate sampled_gain(const optim::Verification& seen, std::size_t input) {
  if (seen.tighter.empty()) return {kNoValue, kNoValue, kNoValue};
  constexpr double kNormal95 = 1.959964;
  const auto [value, error] = seen.tighter[input];
  return {value, value - kNormal95 * error, value + kNormal95 * error};
}

std::vector<RobustTolerance> tolerances_of(const RobustQuestion& question,
                                           const optim::RobustProblem& posed,
                                           const optim::RobustResult& found) {
  std::vector<RobustTolerance> list;
  for (std::size_t k = 0; k < question.tolerances.size(); ++k) {
    const optim::RandomInput& input = posed.inputs[k];
    const std::string unit(info(question.tolerances[k].parameter).unit);
    RobustTolerance tolerance{input.name, input.relative ? "%" : unit,
                              input.relative ? 100 * input.spread : input.spread};
    if (k < found.prices.size()) {
      // For a largest yield, prices refer to the yield, not to the goal.
      const bool largest = std::isfinite(found.largest_yield);
      tolerance.gain = largest ? kNoValue : found.prices[k].gain_per_percent_tighter;
      tolerance.yield_gain = found.prices[k].yield_per_percent_tighter;
    }
    tolerance.sampled_gain = sampled_gain(found.verification, k);
    list.push_back(std::move(tolerance));
  }
  return list;
}

// Shares of the values in equal bins.
std::vector<double> binned(const std::vector<double>& values, double first, double width) {
  std::vector<double> shares(kBins, 0.0);
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    const double bin = std::floor((v - first) / width);
    if (bin >= 0 && bin < static_cast<double>(kBins))
      shares[static_cast<std::size_t>(bin)] += 1.0 / static_cast<double>(values.size());
  }
  return shares;
}

// From the 0.02 % to the 99.98 % quantile, extended to limits nearby.
std::pair<double, double> window_of(std::vector<double> values, const optim::RandomLimit& limit) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.size() < 2) return {0.0, 0.0};
  std::sort(values.begin(), values.end());
  const std::size_t cut = values.size() / 5000;
  double low = values[cut], high = values[values.size() - 1 - cut];
  const double span = high - low;
  for (const double end : {limit.lower, limit.upper}) {
    if (end > low - span && end < low) low = end - 0.05 * span;
    if (end < high + span && end > high) high = end + 0.05 * span;
  }
  return {low, high};
}

std::vector<RobustDensity> densities_of(const RobustQuestion& question,
                                        const optim::RobustProblem& posed,
                                        const optim::Verification& found,
                                        const optim::Verification& nominal) {
  std::vector<RobustDensity> list;
  for (std::size_t r = 0; r < posed.limits.size(); ++r) {
    const optim::RandomLimit& limit = posed.limits[r];
    const auto asked = std::find_if(question.design.limits.begin(), question.design.limits.end(),
                                    [&](const MotorLimit& c) { return c.text == limit.name; });
    if (asked == question.design.limits.end()) continue;
    const auto [low, high] = window_of(found.values[r], limit);
    if (!(high > low)) continue;
    const double width = (high - low) / static_cast<double>(kBins);
    list.push_back({asked->metric.text, asked->metric.unit(), limit.lower, limit.upper, low, width,
                    binned(found.values[r], low, width), binned(nominal.values[r], low, width)});
  }
  return list;
}

// The end of a limit that belongs to the margin of an activity.
struct MarginEnd {
  std::string limit;
  optim::Side side;
  double value;
};

std::optional<MarginEnd> end_of_margin(const optim::RobustProblem& posed, const std::string& name) {
  for (const optim::YieldTarget& target : posed.yields) {
    const std::string in = " in " + target.name;
    for (const std::size_t at : target.limits) {
      const optim::RandomLimit& limit = posed.limits[at];
      const bool lower = limit.lower > -optim::kInfinity, upper = limit.upper < optim::kInfinity;
      if (name == limit.name + (lower && upper ? " (lower end)" : "") + in && lower)
        return MarginEnd{limit.name, optim::Side::lower, limit.lower};
      if (name == limit.name + (lower && upper ? " (upper end)" : "") + in && upper)
        return MarginEnd{limit.name, optim::Side::upper, limit.upper};
    }
  }
  return {};
}

}  // namespace

std::vector<RobustYield> yields_of(const optim::RobustProblem& posed,
                                   const optim::Verification& seen) {
  std::vector<RobustYield> list;
  for (std::size_t s = 0; s < seen.yields.size(); ++s) {
    const optim::YieldEstimate& share = seen.yields[s];
    const double wanted = posed.yields[s].at_least;
    list.push_back({target_name(posed, s),
                    kNoValue,
                    share_estimate(share),
                    share.products,
                    seen.weighted,
                    {}});
    if (!std::isfinite(wanted)) continue;
    list.back().target = wanted;
    list.back().verdict = optim::to_string(optim::verdict_on(share, wanted));
  }
  return list;
}

std::vector<NamedValue> wanted_statistics(const RobustQuestion& question,
                                          const optim::RobustProblem& posed,
                                          const optim::Verification& seen) {
  std::vector<NamedValue> list;
  if (seen.values.empty()) return list;  // nothing was drawn
  for (std::size_t k = 0; k < posed.goals.size(); ++k) {
    const auto [kind, index, ignored] = posed.goals[k];
    const DesignObjective& goal = question.design.objectives[k];
    if (kind == optim::RobustGoal::nominal) continue;
    double value = kNoValue;
    if (kind == optim::RobustGoal::yield) {
      value = seen.yields[index].value;
    } else {
      value = seen.statistics[index].value;
    }
    list.push_back({goal.text(), goal.unit(), value});
  }
  return list;
}

optim::Certificate design_certificate(optim::Certificate certificate,
                                      const optim::RobustProblem& posed) {
  const auto of_index = [](const std::string& name) { return name.rfind("beta of ", 0) == 0; };
  std::erase_if(certificate.findings, [&](const optim::Finding& finding) {
    return std::any_of(finding.names.begin(), finding.names.end(), of_index);
  });
  std::erase_if(certificate.limits,
                [&](const optim::Activity& a) { return a.is_bound && of_index(a.name); });
  for (optim::Activity& activity : certificate.limits)
    if (const auto end = end_of_margin(posed, activity.name)) {
      activity.name = end->limit;
      activity.side = end->side;
      activity.limit = end->value;
      activity.value = kNoValue;
      activity.gain_per_percent = 0.01 * activity.multiplier * std::fabs(end->value);
    }
  return certificate;
}

optim::Certificate goal_certificate(const optim::RobustResult& found, bool maximize,
                                    const optim::RobustProblem& posed) {
  optim::Certificate certificate = design_certificate(found.last.certificate, posed);
  for (optim::Activity& activity : certificate.limits) {
    activity.multiplier *= found.goal_per_objective;
    activity.gain_per_percent =
        (maximize ? 1 : -1) * std::fabs(found.goal_per_objective * activity.gain_per_percent);
  }
  return certificate;
}

RobustReport robust_report(const RobustQuestion& question, const optim::RobustProblem& posed,
                           const optim::RobustResult& found, const NominalMotors& nominal) {
  RobustReport report;
  report.yields = yields_of(posed, found.verification);
  report.statistics = statistics_of(question, posed, found.verification);
  report.nominal_objective = nominal.objective;
  report.nominal_design = nominal.design;
  report.nominal_yield.value = kNoValue;
  if (!nominal.seen.yields.empty())
    report.nominal_yield = share_estimate(nominal.seen.yields.front());
  report.limits = risk_limits(posed, found);
  report.tolerances = tolerances_of(question, posed, found);
  report.price_of_yield = found.price_of_yield;
  report.prices_of_yields = found.prices_of_yields;
  report.largest_yield = found.largest_yield;
  report.rounds = found.rounds;
  report.aimed = found.aimed;
  report.lost = found.verification.lost;
  if (!found.verification.values.empty())
    report.densities = densities_of(question, posed, found.verification, nominal.seen);
  return report;
}

}  // namespace twum::inline v0_1::studies
