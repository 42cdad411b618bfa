// SPDX-License-Identifier: Apache-2.0
#include "support/box_survey.hpp"

#include "support/deviations.hpp"
#include "support/point_checks.hpp"

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <span>
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

void note_broken(const std::string& law, const BoxPoint& box, BoxSurvey& found) {
  if (found.examples.size() < 20)
    found.examples.push_back(law + " " + identity_case("broken", box));
}

// From the mean radius to the edges; with one slice all of the contact is at the mean radius.
double reach_of(const Motor& motor) {
  return motor.radial_slices() == 1 ? 0 : 0.5 * motor.design().stator.contact_width;
}

// Over an annulus the pressure may move to its outer edge (W3.5).
double largest_torque(const Motor& motor) {
  const MotorDesign& d = motor.design();
  return d.friction.threshold * d.preload * (d.stator.contact_radius + reach_of(motor));
}

// The scale of powers (T7.11), with the crest's largest speed over the track: V0 / rho goes with R(rho) / rho^2.
double largest_power(const Motor& motor, double speed) {
  const Stator& s = motor.design().stator;
  double fastest = 1;
  for (const double side : {-1.0, 1.0}) {
    const double radius = s.contact_radius + side * reach_of(motor);
    const double along = (radius - s.radial_shape.root) / (s.contact_radius - s.radial_shape.root);
    fastest = std::max(
        fastest, std::pow(along, s.radial_shape.exponent) * std::pow(s.contact_radius / radius, 2));
  }
  return largest_torque(motor) * std::max(fastest * motor.crest_speed(), std::abs(speed));
}

// The largest value that a metric may have.
double bound_of(Metric metric, const Motor& motor) {
  switch (metric) {
    case Metric::stall_torque:
    case Metric::max_torque:
    case Metric::torque_at_peak_power: return largest_torque(motor) * (1 + 0.01 * kPromised);
    case Metric::contact_ratio: return 0.5;
    // an input power that balances to 1e-6 of itself, and the balance of all other points, of which T7.10 says 1e-10
    case Metric::max_efficiency:
    case Metric::contact_efficiency_at_peak_power: return 1 + 1.001e-6;
    default: return std::numeric_limits<double>::max();
  }
}

bool keeps_its_laws(const MetricValue& value, Metric metric, const Motor& motor) {
  if (value.status != MetricStatus::ok) return std::isnan(value.value);
  return std::isfinite(value.value) && value.value <= bound_of(metric, motor);
}

void survey_metrics(const Motor& motor, NotablePoint place, BoxSurvey& found) {
  static const auto requests = metrics_without_argument();
  const double start = processor_seconds();
  const auto values = evaluate(motor, requests);
  place.value = processor_seconds() - start;
  note(found.slowest_metrics, place);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ++found.metrics[to_string(values[i].status)];
    if (keeps_its_laws(values[i], requests[i].metric, motor)) continue;
    ++found.metrics_broken;
    note_broken(std::string(info(requests[i].metric).name), place.box, found);
  }
}

// One point, and what it breaks. Returns its imbalance as a share of the scale of powers, NaN without an answer.
double survey_point(const Motor& motor, const BoxPoint& box, std::int64_t index, BoxSurvey& found,
                    double slack = 1e-10) {
  const double start = processor_seconds();
  const OperatingPoint point = motor.operating_point(box.speed);
  note(found.slowest, {index, processor_seconds() - start, box});
  ++found.statuses[to_string(point.status)];
  double share = std::numeric_limits<double>::quiet_NaN();
  if (point.status == PointStatus::ok) {
    const double scale = largest_power(motor, point.speed);
    share = scale > 0 ? std::abs(imbalance(point)) / scale : 0;
    found.identity = std::max(found.identity, share);
    note(found.strangest, {index, share, box});
  }
  if (const std::string law = broken_law(motor, point, slack); !law.empty()) {
    ++found.broken[law];
    note_broken(law, box, found);
  }
  return share;
}

}  // namespace

std::string broken_law(const Motor& motor, const OperatingPoint& point, double slack) {
  if (point.status != PointStatus::ok)
    return std::isnan(point.torque) ? "" : "a number beside a reason";
  if (!all_finite(point)) return "a number is not finite";
  // 1e-10 of the scale: rounding of the zone integrals times the condition of the periodic state,
  // whose worst case over the box (loss factors of 1e-3 near resonance) is some 1e5.
  const double scale = largest_power(motor, point.speed);
  if (!(std::abs(imbalance(point)) <= slack * scale)) return "identity";
  if (!(std::abs(point.torque) <= largest_torque(motor) * (1 + 0.01 * slack))) return "bound";
  if (point.friction_power < -0.1 * slack * scale) return "friction gives power";
  if (point.layer_loss < -0.1 * slack * scale) return "layer gives power";
  if (!(point.stick_fraction >= 0 && point.stick_fraction <= 1 + 0.01 * slack))
    return "stick fraction";
  return {};
}

BoxSurvey survey_box(const BoxSurveyOptions& options) {
  BoxSurvey found;
  Deviation identity("identity on " + std::to_string(options.count) + " points of the whole box",
                     1e-10);
  Uniform random(options.seed);
  for (std::int64_t i = 0; i < options.count; ++i) {
    const BoxPoint box = random_box_point(random);
    const Motor motor(box.design);
    if (const double share = survey_point(motor, box, i, found); !std::isnan(share))
      identity.add(share, 0, 1);
    if (options.metrics_every > 0 && i % options.metrics_every == 0)
      survey_metrics(motor, {i, 0, box}, found);
  }
  found.designs = options.count;
  return found;
}

namespace {

constexpr double kBeside[] = {1e-12, 1e-6, 1e-2};

// Both ends of a range and what lies beside them; beside zero, small numbers down to the smallest.
std::vector<double> ends_of(const ParameterInfo& row) {
  if (row.integer) return {row.min, row.min + 1, row.max - 1, row.max};
  std::vector<double> values{row.min, row.max};
  for (const double share : kBeside) values.push_back(row.max * (1 - share));
  if (row.min != 0) {
    for (const double share : kBeside) values.push_back(row.min + share * std::abs(row.min));
  } else {
    for (const double small : {5e-324, 1e-299, 1e-100, 1e-30, 1e-12, 1e-6})
      values.push_back(small * row.max);
  }
  return values;
}

double inside(const ParameterInfo& row, Uniform& random) {
  const double low = row.min > 0 ? row.min : 1e-12 * row.max;
  const double value = row.min < 0 || random.chance(0.5) ? random(row.min, row.max)
                                                         : random.logarithmic(low, row.max);
  if (row.integer) return std::floor(value);
  return row.min == 0 && random.chance(0.1) ? 0 : value;
}

// The ring motor with every kind of layer and of friction.
std::vector<MotorDesign> bases() {
  std::vector<MotorDesign> all{ring_motor(), elastic(ring_motor()), damped(ring_motor())};
  for (std::size_t i = 0; i < 3; ++i) {
    all.push_back(all[i]);
    all.back().friction.threshold = 1.3 * all.back().friction.kinetic;
  }
  return all;
}

void survey_design(const MotorDesign& design, BoxSurvey& found) {
  if (!complaints(design).empty()) return;
  const Motor motor(design);
  const std::int64_t index = found.designs++;
  for (const double share : {-0.3, 0.0, 1e-3, 0.3, 0.8, 1.0, 1.2}) {
    const double speed = std::max(share * motor.crest_speed(), -0.9 * motor.wave_speed());
    survey_point(motor, {design, speed}, index, found, kPromised);
  }
  survey_metrics(motor, {index, 0, {design, 0}}, found);
}

// The design with these values; nothing asked where two of them say the same, or mu_0 < mu.
void survey_with(const MotorDesign& base, std::span<const ParameterValue> values,
                 BoxSurvey& found) {
  MotorDesign design;
  try {
    design = with(base, values);
  } catch (const InputError&) {
    return;
  }
  survey_design(design, found);
}

// All but those of a stator's geometry, which the surveyed motors do not have; they are the last of the table.
std::span<const ParameterInfo> contact_parameters() {
  return parameter_table().first(index_of(Parameter::substrate_inner_radius));
}

void survey_pairs(const MotorDesign& base, BoxSurvey& found) {
  for (const ParameterInfo& a : contact_parameters())
    for (const ParameterInfo& b : contact_parameters())
      for (const double at : {a.min, a.max})
        for (const double bt : {b.min, b.max})
          if (a.parameter < b.parameter)
            survey_with(base, std::array<ParameterValue, 2>{{{a.parameter, at}, {b.parameter, bt}}},
                        found);
}

}  // namespace

BoxSurvey survey_ranges(std::uint64_t seed, std::int64_t count) {
  BoxSurvey found;
  for (const MotorDesign& base : bases()) {
    for (const ParameterInfo& row : contact_parameters())
      for (const double value : ends_of(row))
        survey_with(base, std::array<ParameterValue, 1>{{{row.parameter, value}}}, found);
    survey_pairs(base, found);
  }
  Uniform random(seed);
  for (std::int64_t i = 0; i < count; ++i) {
    std::vector<ParameterValue> values;
    for (const ParameterInfo& row : contact_parameters()) {
      const double value = inside(row, random);
      const bool second_of_pair = row.alternative && *row.alternative < row.parameter;
      if (second_of_pair && random.chance(0.5)) continue;
      if (second_of_pair)
        std::erase_if(values, [&](const ParameterValue& v) { return v.first == *row.alternative; });
      values.emplace_back(row.parameter, value);
    }
    survey_with(ring_motor(), values, found);
  }
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
