// SPDX-License-Identifier: Apache-2.0
// Which metrics of the program a study asks for.
#include <twum/base/error.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/study_file.hpp>

#include <algorithm>
#include <memory>
#include <variant>

namespace twum::inline v0_1::studies {
namespace {

class Collector {
 public:
  template <typename T>
  void add(const std::vector<T>& list) {
    for (const T& one : list) add(one);
  }
  void add(const DesignObjective& objective) {
    add(objective.metric);
    if (objective.statistic) add(objective.statistic->metric);
  }
  void add(const MotorLimit& limit) {
    add(limit.metric);
    add(limit.sides);
  }
  void add(const StatisticLimit& limit) { add(limit.statistic.metric); }
  void add(const MetricExpression& expression) {
    for (const Term& term : expression.terms)
      if (const auto* own = std::get_if<std::shared_ptr<const OwnMetric>>(&term)) keep(*own);
  }

  OwnMetrics found() && { return std::move(found_); }

 private:
  void keep(const std::shared_ptr<const OwnMetric>& own) {
    const auto same =
        std::ranges::find_if(found_, [&](const auto& known) { return known->name == own->name; });
    if (same == found_.end())
      found_.push_back(own);
    else if ((*same)->unit != own->unit)
      throw InputError(quoted(own->name) + ": two metrics of this name, one in " + (*same)->unit +
                       ", one in " + own->unit + "; give one of them another name");
  }

  OwnMetrics found_;
};

}  // namespace

OwnMetrics own_metrics(const Study& study) {
  Collector collector;
  std::visit(
      [&](const auto& asked) {
        if constexpr (requires { asked.objective; }) collector.add(asked.objective);
        if constexpr (requires { asked.objectives; }) collector.add(asked.objectives);
        if constexpr (requires { asked.prefer; }) collector.add(asked.prefer);
        if constexpr (requires { asked.metrics; }) collector.add(asked.metrics);
        if constexpr (requires { asked.constraints; }) collector.add(asked.constraints);
        if constexpr (requires { asked.limits; }) collector.add(asked.limits);
        if constexpr (requires { asked.statistics; }) collector.add(asked.statistics);
      },
      study);
  return std::move(collector).found();
}

}  // namespace twum::inline v0_1::studies
