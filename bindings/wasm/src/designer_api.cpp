// SPDX-License-Identifier: Apache-2.0
// The functions that the page calls. Numbers pass through two buffers of doubles, words through one text.
//
// Each function that can fail returns how many things it wrote, or -1 with the reason in the text. A call may move the
// buffers: ask where they are after it.
#include "wasm/src/page_plant.hpp"
#include "wasm/src/stated_design.hpp"

#include <twum/base/error.hpp>
#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/model_notes.hpp>

#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#define TWUM_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace twum::inline v0_1::wasm {
namespace {

std::vector<double> input;
std::vector<double> output;
std::string text;
std::optional<Motor> motor;
std::optional<PagePlant> plant;

const Motor& current() {
  TWUM_ASSERT(motor.has_value());
  return *motor;
}

void put(double value) { output.push_back(value); }

template <typename Task>
int attempt(const Task& task) {
  output.clear();
  try {
    return static_cast<int>(task());
  } catch (const std::exception& error) {
    text = error.what();
    return -1;
  }
}

struct MotorNumber {
  const char* name;
  double (*value)(const Motor&);
};

// Numbers of a motor that the page needs besides its metrics.
constexpr MotorNumber kMotorNumbers[] = {
    {"crest_speed", [](const Motor& m) { return m.crest_speed(); }},
    {"wave_speed", [](const Motor& m) { return m.wave_speed(); }},
    {"first_speed", [](const Motor& m) { return m.first_speed(); }},
    {"last_speed", [](const Motor& m) { return motors::last_curve_speed(m); }},
    {"slices", [](const Motor& m) { return static_cast<double>(m.radial_slices()); }},
    {"half_angle", [](const Motor& m) { return m.contact().half_angle; }},
    {"modal", [](const Motor& m) { return has_modal_data(m.design()) ? 1.0 : 0.0; }},
};

void append(const char* name) {
  if (!text.empty()) text += ' ';
  text += name;
}

// The columns of a curve: those of `twum curve`, those of the terminals, and others that the page draws.
void append_columns() {
  append("status");
  for (const motors::CurveColumn& one : motors::contact_columns()) append(one.name);
  for (const motors::CurveColumn& one : motors::terminal_columns()) append(one.name);
  append("efficiency");
}

void put_point(const OperatingPoint& point) {
  put(static_cast<double>(point.status));
  for (const motors::CurveColumn& one : motors::contact_columns()) put(one.value(point));
  for (const motors::CurveColumn& one : motors::terminal_columns()) put(one.value(point));
  put(point.efficiency());
}

std::vector<MetricRequest> requests(int count) {
  std::vector<MetricRequest> list;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    list.push_back({static_cast<Metric>(static_cast<int>(input[3 * i])),
                    static_cast<Argument>(static_cast<int>(input[3 * i + 1])), input[3 * i + 2]});
  return list;
}

}  // namespace

/// Room for so many numbers.
TWUM_EXPORT(input) double* input_room(int count) {
  input.resize(static_cast<std::size_t>(count));
  return input.data();
}
TWUM_EXPORT(output) const double* output_numbers() { return output.data(); }
TWUM_EXPORT(text) const char* text_bytes() { return text.data(); }
TWUM_EXPORT(text_size) int text_size() { return static_cast<int>(text.size()); }

/// Names of the numbers below, separated by blanks: 0 parameters, 1 metrics, 2 statuses of a metric, 3 statuses of a point,
/// 4 numbers of a motor, 5 columns of a curve, 6 statuses of a held point.
TWUM_EXPORT(names) void names(int kind) {
  text.clear();
  if (kind == 0)
    for (const ParameterInfo& row : parameter_table()) append(row.name.data());
  if (kind == 1)
    for (const MetricInfo& row : metric_table()) append(row.name.data());
  if (kind == 2)
    for (int i = 0; i <= static_cast<int>(MetricStatus::does_not_pull_out); ++i)
      append(to_string(static_cast<MetricStatus>(i)));
  if (kind == 3)
    for (int i = 0; i <= static_cast<int>(PointStatus::unstable_amplitude); ++i)
      append(to_string(static_cast<PointStatus>(i)));
  if (kind == 4)
    for (const MotorNumber& one : kMotorNumbers) append(one.name);
  if (kind == 5) append_columns();
  if (kind == 6)
    for (int i = 0; i <= static_cast<int>(HeldStatus::not_converged); ++i)
      append(to_string(static_cast<HeldStatus>(i)));
}

/// Takes the motor of the numbers in the input (design_of()); if they are not those of a valid motor, the previous
/// motor stays. Writes the numbers of a motor, the value of every parameter, and for each whether it is in use.
TWUM_EXPORT(motor) int take_motor() {
  return attempt([] {
    motor = Motor(design_of(input));
    const MotorDesign& design = motor->design();
    for (const MotorNumber& one : kMotorNumbers) put(one.value(*motor));
    for (const ParameterInfo& row : parameter_table()) put(get(design, row.parameter));
    for (const ParameterInfo& row : parameter_table()) put(in_use(design, row.parameter) ? 1 : 0);
    return output.size();
  });
}

/// The modal data of the circuit in the input, R_m, L_m, C_m, C_0 and Theta: a parameter and its value each.
TWUM_EXPORT(circuit) int circuit_data() {
  return attempt([] {
    const auto data = modal_data({input[0], input[1], input[2], input[3], input[4]});
    for (const auto& [parameter, value] : data)
      put(static_cast<double>(index_of(parameter))), put(value);
    return data.size();
  });
}

/// Operating points at equally spaced speeds from rest to `last` [rad/s], all columns of each.
TWUM_EXPORT(curve) int curve(int points, double last) {
  return attempt([=] {
    for (int i = 0; i < points; ++i)
      put_point(current().operating_point(motors::curve_speed(last, static_cast<std::uint64_t>(i),
                                                              static_cast<std::uint64_t>(points))));
    return points;
  });
}

/// Whether the motor squeals at a speed [rad/s]: 1, or 0 also where that is not known.
TWUM_EXPORT(squeals) int squeals_at(double speed) {
  return attempt([=] {
    const auto squeals = motors::squeals(current().design(), current().backward_wave(speed));
    return squeals.value_or(false) ? 1 : 0;
  });
}

/// Metrics of the motor. The input has a metric, an argument (Argument) and its value for each; the output value and status.
TWUM_EXPORT(metrics) int metrics(int count) {
  return attempt([=] {
    for (const MetricValue& one : evaluate(current(), requests(count)))
      put(one.value), put(static_cast<double>(one.status));
    return count;
  });
}

/// The same with derivatives: value, status, smoothness, and the derivative in every parameter.
TWUM_EXPORT(gradients) int gradients(int count) {
  return attempt([=] {
    for (const MetricDerivative& one : differentiate(current(), requests(count))) {
      put(one.value.value), put(static_cast<double>(one.value.status));
      put(static_cast<double>(one.smoothness));
      output.insert(output.end(), one.gradient.begin(), one.gradient.end());
    }
    return count;
  });
}

/// Fields at the contact radius: the point's columns, how many zones, state and ends of each, then the samples.
TWUM_EXPORT(fields) int fields(double speed, int samples) {
  return attempt([=] {
    const ContactFields found = current().fields(speed, samples);
    put_point(found.point);
    put(static_cast<double>(found.zones.size()));
    for (const Zone& zone : found.zones)
      put(static_cast<double>(zone.state)), put(zone.from), put(zone.to);
    for (const FieldSample& s : found.samples)
      for (const double value :
           {s.phase, s.pressure, s.traction, s.stator_velocity, s.layer_velocity})
        put(value);
    return found.samples.size();
  });
}

/// A torque [N m] held at a speed [rad/s] by a drive that follows with its frequency, between two ends [Hz] if both are numbers, or
/// with its voltage. Writes status, frequency, voltage, amplitude, what would do, whether only the control holds it, and the point.
TWUM_EXPORT(held) int held(double torque, double speed, int by_voltage, double low, double high) {
  return attempt([=] {
    MotorDesign design = current().design();
    design.stator.control = by_voltage != 0 ? DriveControl::voltage : DriveControl::frequency;
    if (!std::isnan(low) && !std::isnan(high)) design.stator.frequency_range = {low, high};
    const HeldPoint found = held_point(design, torque, speed);
    put(static_cast<double>(found.status));
    put(found.frequency), put(found.voltage), put(found.amplitude), put(found.needed);
    put(found.by_control_only ? 1 : 0);
    put_point(found.point);
    return output.size();
  });
}

/// The motor at rest, to be followed in time. Writes the longest step [s].
TWUM_EXPORT(rest) int at_rest() {
  return attempt([] {
    plant.emplace(current().design());
    put(plant->longest_step());
    return output.size();
  });
}

/// Follows it under a load torque [N m], with the drive on or off, for `duration` [s]: so many rows of speed, angle, amplitude, and
/// whether the rotor is held, at the end of each of as many equal parts.
TWUM_EXPORT(follow) int follow(double torque, int enabled, double duration, int rows) {
  return attempt([=] {
    for (int i = 0; i < rows; ++i) {
      plant->follow(torque, enabled != 0, duration / rows);
      const PlantState& state = plant->state();
      put(state.speed), put(state.angle), put(plant->amplitude()), put(state.held);
    }
    return rows;
  });
}

/// The notes of `twum check` on the motor, a line each; `at_length` those that take some milliseconds too.
TWUM_EXPORT(notes) int notes(int at_length) {
  return attempt([=] {
    const MotorDesign& design = current().design();
    const auto list =
        at_length != 0 ? motors::model_notes_at_length(design) : motors::model_notes(design);
    text.clear();
    for (const motors::ModelNote& note : list) text += (text.empty() ? "" : "\n") + note.text;
    return list.size();
  });
}

}  // namespace twum::inline v0_1::wasm
