// SPDX-License-Identifier: Apache-2.0
#include "support/box_survey.hpp"

#include "support/deviations.hpp"
#include "support/point_checks.hpp"

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>

namespace twum::test {

namespace {

constexpr std::size_t kKept = 5;

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

// Keeps the points with the largest values, largest first.
void note(std::vector<NotablePoint>& kept, const NotablePoint& point) {
  const auto place =
      std::find_if(kept.begin(), kept.end(), [&](const auto& k) { return k.value < point.value; });
  if (place == kept.end() && kept.size() == kKept) return;
  kept.insert(place, point);
  if (kept.size() > kKept) kept.pop_back();
}

std::vector<MetricRequest> metrics_without_argument() {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
  return requests;
}

void survey_metrics(const Motor& motor, NotablePoint place, BoxSurvey& found) {
  static const auto requests = metrics_without_argument();
  const double start = processor_seconds();
  const auto values = evaluate(motor, requests);
  place.value = processor_seconds() - start;
  note(found.slowest_metrics, place);
  for (const MetricValue& value : values) {
    ++found.metrics[to_string(value.status)];
    if (std::isfinite(value.value) != (value.status == MetricStatus::ok)) ++found.metrics_broken;
  }
}

}  // namespace

std::string broken_law(const Motor& motor, const OperatingPoint& point) {
  if (point.status != PointStatus::ok)
    return std::isnan(point.torque) ? "" : "a number beside a reason";
  if (!all_finite(point)) return "a number is not finite";
  // 1e-10 of the scale: rounding of the zone integrals times the condition of the periodic state,
  // whose worst case over the box (loss factors of 1e-3 near resonance) is some 1e5.
  const double scale = power_scale(motor, point.speed);
  if (!(std::abs(imbalance(point)) <= 1e-10 * scale)) return "identity";
  if (!(std::abs(point.torque) <= motor.holding_torque() * (1 + 1e-12))) return "bound";
  if (point.friction_power < -1e-11 * scale) return "friction gives power";
  if (point.layer_loss < -1e-11 * scale) return "layer gives power";
  if (!(point.stick_fraction >= 0 && point.stick_fraction <= 1 + 1e-12)) return "stick fraction";
  return {};
}

BoxSurvey survey_box(const BoxSurveyOptions& options) {
  BoxSurvey found;
  Deviation identity("identity on " + std::to_string(options.count) + " points of the whole box",
                     1e-10);
  Uniform random(options.seed);
  for (std::int64_t i = 0; i < options.count; ++i) {
    const BoxPoint box = random_box_point(random);
    const double start = processor_seconds();
    const Motor motor(box.design);
    const OperatingPoint point = motor.operating_point(box.speed);
    note(found.slowest, {i, processor_seconds() - start, box});
    ++found.statuses[to_string(point.status)];
    if (point.status == PointStatus::ok) {
      const double scale = power_scale(motor, point.speed);
      note(found.strangest, {i, identity.add(imbalance(point), 0, scale), box});
    }
    if (const std::string law = broken_law(motor, point); !law.empty()) {
      ++found.broken[law];
      if (found.examples.size() < 20) found.examples.push_back(law + " at " + std::to_string(i));
    }
    if (options.metrics_every > 0 && i % options.metrics_every == 0)
      survey_metrics(motor, {i, 0, box}, found);
  }
  found.identity = identity.largest();
  return found;
}

std::string identity_case(const std::string& name, const BoxPoint& box) {
  std::ostringstream text;
  text.precision(17);
  text << "- {motor: " << name << ", set: {";
  const char* separator = "";
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(box.design, row.parameter)) continue;
    text << separator << row.name << ": " << get(box.design, row.parameter);
    separator = ", ";
  }
  text << "}, speeds: [" << box.speed / crest_speed_of(box.design) << "]}";
  return text.str();
}

}  // namespace twum::test
