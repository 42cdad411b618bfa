// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/robust_log.hpp"
#include "kinds/rows/executor.hpp"
#include "kinds/sample/drawn_motors.hpp"
#include "kinds/sensitivity/metric_gradients.hpp"
#include "results/answers.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/reliability.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr const char* kWaysFact = "ways-to-fail";

Json ways_json(const optim::WaysToFail& ways) {
  Json points = Json::array();
  for (const optim::DesignPoint& one : ways.points)
    points.push_back({{"limit", one.limit},
                      {"lower", one.side == optim::Side::lower},
                      {"beta", number_json(one.beta)},
                      {"normals", one.normals},
                      {"converged", one.converged}});
  return {{"points", points}, {"centres", ways.centres}};
}

optim::WaysToFail ways_of(const Json& json) {
  optim::WaysToFail ways;
  for (const Json& one : json.at("points")) {
    optim::DesignPoint point{one.at("limit").get<std::size_t>(),
                             one.at("lower").get<bool>() ? optim::Side::lower : optim::Side::upper};
    if (one.at("beta").is_number()) point.beta = one.at("beta").get<double>();
    point.normals = one.at("normals").get<std::vector<double>>();
    point.converged = one.at("converged").get<bool>();
    ways.points.push_back(std::move(point));
  }
  ways.centres = json.at("centres").get<std::vector<std::vector<double>>>();
  return ways;
}

// The limits as functions of the drawn parameters, with derivatives.
class LimitResponses {
 public:
  LimitResponses(const std::vector<LimitPlace>& limits, const VariedParameters& varied)
      : limits_(limits) {
    std::vector<MetricExpression> all;
    for (const LimitPlace& one : limits) {
      all.push_back(one.limit.metric);
      alone_.emplace_back(std::vector{one.limit.metric}, varied);
    }
    values_.emplace(varied, std::move(all));
  }

  optim::Evaluation at(std::span<const double> built, std::optional<std::size_t> only,
                       bool gradient) const {
    return only && gradient ? slopes(built, *only) : values(built);
  }

 private:
  // A metric without a value breaks its limit.
  optim::Evaluation values(std::span<const double> built) const {
    StoredRow row;
    values_->evaluate(built, row);
    optim::Evaluation answer;
    answer.values.assign(row.values.begin() + static_cast<std::ptrdiff_t>(built.size()),
                         row.values.end());
    for (std::size_t i = 0; i < limits_.size(); ++i)
      if (std::isnan(answer.values[i]))
        answer.values[i] =
            std::isfinite(limits_[i].limit.lower) ? -optim::kInfinity : optim::kInfinity;
    return answer;
  }

  optim::Evaluation slopes(std::span<const double> built, std::size_t limit) const {
    optim::Evaluation answer;
    StoredRow row;
    try {
      answer.jacobian = alone_[limit].at(built).front().values;
      answer.values = {values(built).values[limit]};
    } catch (const Error&) {
      answer.failure = "no such motor";
    }
    if (answer.ok() && !std::isfinite(answer.values.front())) answer.failure = "no value";
    return answer;
  }

  const std::vector<LimitPlace>& limits_;
  std::vector<MetricGradients> alone_;
  std::optional<RowEvaluator> values_;
};

// Motors drawn about the points where they are most likely to fail, one row each, with its weight behind the parameters.
class ReliabilityRun : public DrawnMotors {
 public:
  ReliabilityRun(const UncertaintyStudy& asked, const StudyFile& file)
      : DrawnMotors(asked, file), samples_(optim::WeightedProducts::balanced(asked.samples)) {}

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> list = evaluator_.columns();
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(variables_.size()), {"weight", "1"});
    return list;
  }
  std::size_t variables() const override { return variables_.size() + 1; }

  KindAnswer run(RunContext& context) override {
    const optim::WaysToFail ways = known_ways(context);
    if (context.stop.stop_requested() && context.store.rows() == 0) return {"interrupted", frame()};
    const optim::WeightedProducts products(variables_.size(), seed_, ways.centres);
    const bool complete = store_rows(
        context, samples_, [&](std::uint64_t index) { return asked_row(products, index); });
    return {complete ? "done" : "interrupted", answer(context.store, ways, products)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index >= samples_) return {};
    StoredRow row;
    row.index = asked.index;
    if (asked.values.size() < variables()) return row;  // its values follow from the ways to fail
    evaluator_.evaluate(std::span(asked.values).first(variables_.size()), row);
    row.values.insert(row.values.begin() + static_cast<std::ptrdiff_t>(variables_.size()),
                      asked.values[variables_.size()]);
    return row;
  }

 private:
  optim::RobustProblem problem(const LimitResponses& responses) const {
    optim::RobustProblem problem;
    for (const DrawnVariable& one : variables_) {
      optim::RandomInput input{std::string(info(one.parameter).name), optim::Law::given};
      input.transform = [law = one.distribution](double z) {
        const auto [value, slope] = law.of_normal(z);
        return optim::BuiltValue{value, 0, slope, 0};
      };
      problem.inputs.push_back(std::move(input));
    }
    problem.correlation = correlation_;
    optim::YieldTarget all{"yield"};
    for (const LimitPlace& one : limits_) {
      all.limits.push_back(problem.limits.size());
      problem.limits.push_back({one.limit.text, one.limit.lower, one.limit.upper});
    }
    problem.yields = {all};
    problem.built = [&responses](std::span<const double> built, std::optional<std::size_t> only,
                                 bool gradient) { return responses.at(built, only, gradient); };
    return problem;
  }

  // Searched once for all runs of this result.
  optim::WaysToFail known_ways(RunContext& context) const {
    const std::string known = context.store.fact(kWaysFact);
    if (!known.empty()) return ways_of(Json::parse(known));
    const LimitResponses responses(limits_, varied_);
    optim::WaysOptions options{seed_, context.executor.lanes()};
    options.proceed = [&] { return !context.stop.stop_requested(); };
    options.sampled = [&](std::uint64_t made, std::uint64_t most) {
      if (context.progress) context.progress(progress_of_sample(made, made, most));
    };
    optim::WaysToFail ways = optim::ways_to_fail(problem(responses), options);
    if (!context.stop.stop_requested()) context.store.set_fact(kWaysFact, ways_json(ways).dump());
    return ways;
  }

  std::vector<double> built(std::span<const double> normals) const {
    std::vector<double> values = correlation_.correlated({normals.begin(), normals.end()});
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = variables_[k].distribution.of_normal(values[k]).value;
    return values;
  }

  StoredRow asked_row(const optim::WeightedProducts& products, std::uint64_t index) const {
    const std::vector<double> normals = products.normals(index);
    StoredRow row;
    row.index = index;
    row.values = built(normals);
    row.values.push_back(products.weight(normals));
    return row;
  }

  UncertaintyResult answer(const ResultStore& store, const optim::WaysToFail& ways,
                           const optim::WeightedProducts& products) const {
    UncertaintyResult result = frame();
    Broken broken = nothing_broken();
    store.read(0, [&](const StoredRow& row) {
      ++result.samples;
      if (row.status != "ok") ++result.failed;
      count(broken, row.index, row.values[variables_.size()], row.values.data() + variables(),
            [&] { return products.normals(row.index); });
    });
    result.weighted = true;
    result.ways = ways.centres.size();
    result.sought = optim::kProductsOfWays;
    result.metrics.clear();  // weighted motors do not show how a metric scatters
    const auto tell = [](const optim::FailureShares& shares, Estimate& failing, Estimate& kept) {
      failing = shares.share(kConfidence);
      kept = {1 - failing.value, 1 - failing.high, 1 - failing.low};
    };
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      tell(broken.of_limit[i], result.limits[i].broken, result.limits[i].kept);
      tell_likeliest(ways, i, result.limits[i]);
    }
    tell(broken.any, result.broken, result.yield.emplace());
    tell_causes(broken, result);
    return result;
  }

  // Of the two ends of a limit the nearer one.
  void tell_likeliest(const optim::WaysToFail& ways, std::size_t limit,
                      UncertaintyResult::Limit& told) const {
    const optim::DesignPoint* nearest = nullptr;
    for (const optim::DesignPoint& point : ways.points)
      if (point.limit == limit && std::isfinite(point.beta) && !point.normals.empty() &&
          (nearest == nullptr || point.beta < nearest->beta))
        nearest = &point;
    if (nearest == nullptr) return;
    told.index = nearest->beta;
    told.likeliest = built(nearest->normals);
  }

  std::uint64_t samples_;
};

}  // namespace

std::unique_ptr<StudyKindRun> UncertaintyStudy::run(const StudyFile& file) const {
  if (method == DrawMethod::plain) return make_plain_uncertainty(*this, file);
  return std::make_unique<ReliabilityRun>(*this, file);
}

}  // namespace twum::inline v0_1::studies
