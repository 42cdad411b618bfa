// SPDX-License-Identifier: Apache-2.0
// Motions in time: what is done to the motor, what it drives, and what is asked.
#include "entries/entry_shapes.hpp"
#include "entries/motion_columns.hpp"
#include "entries/profile_shape.hpp"

#include <twum/io/words.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

Shape<motion::InitialState> initial_shape() {
  using I = motion::InitialState;
  const auto words = shape_as<I, std::size_t>(
      choice("rest: at rest with a relaxed layer; steady: running steadily at the first values of "
             "drive and load",
             {"rest", "steady"}),
      [](std::size_t number) { return I{.steady = number == 1}; },
      [](const I& state) { return state.steady ? std::size_t{1} : std::size_t{0}; });
  const auto state = mapping<I>(
      "a given state",
      {optional<I>("speed", quantity("of the rotor", "rad/s", "100 rpm"), &I::speed, "0 rad/s"),
       optional<I>("amplitude", quantity("of the wave", "m", "0 um"), &I::amplitude, "0 m"),
       optional<I>("angle", quantity("of the rotor", "rad", "0 rad"), &I::angle, "0 rad")});
  auto shape = one_of<I>("the state at the start of the motion", {words, state}, [](const I& from) {
    return from.speed == 0 && from.amplitude == 0 && from.angle == 0 ? std::size_t{0} : 1;
  });
  shape.schema.example = "rest";
  return shape;
}

Field<MotionStudy::Load> load_number(const char* name, Parameter parameter,
                                     std::optional<double> MotionStudy::Load::*member) {
  const ParameterInfo& row = info(parameter);
  return optional<MotionStudy::Load>(name, value_of(row, std::string(row.text)), member,
                                     "the motor's");
}

Shape<MotionStudy::Load> load_shape() {
  using L = MotionStudy::Load;
  return mapping<L>(
      "load on the shaft, instead of the motor's",
      {optional<L>("torque",
                   profile("load torque; positive against positive rotation", "N.m", "0.2 N.m"),
                   &L::torque, "0 N.m"),
       load_number("inertia", Parameter::load_inertia, &L::inertia),
       hidden(load_number("damping", Parameter::load_damping, &L::damping)),
       hidden(load_number("friction", Parameter::load_friction, &L::friction)),
       hidden(load_number("stiffness", Parameter::load_stiffness, &L::stiffness)),
       hidden(load_number("neutral", Parameter::load_neutral, &L::neutral))});
}

Shape<MotionStudy::Drive> drive_shape() {
  using D = MotionStudy::Drive;
  return mapping<D>(
      "drive over time",
      {optional<D>("voltage", profile("voltage of each phase, rms", "V", "120 V"), &D::voltage,
                   "the motor's"),
       hidden(optional<D>(
           "amplitude",
           profile("amplitude of the wave, for a motor with a given amplitude", "m", "1.6 um"),
           &D::amplitude, "the motor's")),
       optional<D>("frequency", profile("of the drive", "Hz", "40.8 kHz"), &D::frequency,
                   "the motor's"),
       optional<D>("switched_off", intervals("intervals in which the drive is off"),
                   &D::switched_off, "never"),
       hidden(optional<D>("reversed", intervals("intervals in which the phases are swapped"),
                          &D::reversed, "never")),
       hidden(optional<D>("phase_difference",
                          profile("lead of the first phase over the second; values other than 90 "
                                  "deg need the oscillating engine",
                                  "rad", "60 deg"),
                          &D::phase_difference, "90 deg"))});
}

Shape<MotionStudy::Output> output_shape() {
  using O = MotionStudy::Output;
  std::vector<std::string> words;
  for (const std::string_view name : motion_column_names()) words.emplace_back(name);
  auto columns = list("columns of the table", choice("a column", words));
  columns.schema.example = "[speed, angle, amplitude, torque]";
  return mapping<O>("stored time series",
                    {optional<O>("step", quantity("time between rows", "s", "50 us"), &O::step,
                                 "a thousandth of the duration"),
                     optional<O>("columns", columns, &O::columns, "all")});
}

Shape<double> accuracy_shape() {
  return shape_as<double, std::size_t>(
      choice(
          "oscillating engine: factor on the number of contact points and of time steps per period",
          {"1", "2", "4"}),
      [](std::size_t number) { return std::exp2(static_cast<double>(number)); },
      [](double factor) { return static_cast<std::size_t>(std::lround(std::log2(factor))); });
}

bool more_than_zero(const Given& given, const char* name, double value, Diagnostics& diagnostics) {
  const YamlNode* node = given.right(name);
  if (node == nullptr || value > 0) return true;
  diagnostics.add(node->mark, given.path(name), quoted(node->scalar), "expected more than 0 s");
  return false;
}

// A number in either of two units, of a loop that changes the frequency or the voltage.
Shape<LoopValue> loop_value(const std::string& text, const std::string& in_frequency,
                            const std::string& in_voltage, const std::string& example) {
  const auto frequency = quantity(text, in_frequency, example);
  const auto voltage = quantity(text, in_voltage, "1 " + in_voltage);
  Shape<LoopValue> shape;
  shape.schema = frequency.schema;
  shape.read = [=](LoopValue& into, const YamlNode& node, const Spot& spot,
                   Diagnostics& diagnostics) {
    Diagnostics of_voltage(diagnostics.source());
    into.unit = motion::Actuator::voltage;
    if (voltage.read(into.value, node, spot, of_voltage)) return true;
    into.unit = motion::Actuator::frequency;
    return frequency.read(into.value, node, spot, diagnostics);
  };
  shape.write = [=](const LoopValue& from) {
    return from.unit == motion::Actuator::voltage ? voltage.write(from.value)
                                                  : frequency.write(from.value);
  };
  return shape;
}

// 'auto', or both gains.
Shape<std::optional<MotionControl::Gains>> gains_shape() {
  using G = MotionControl::Gains;
  using Given = std::optional<G>;
  const auto automatic = shape_as<Given, std::size_t>(
      choice("computed from the motor's linear model at the largest reference, equation (M8.1)",
             {"auto"}),
      [](std::size_t) { return Given{}; }, [](const Given&) { return std::size_t{0}; });
  const auto numbers = mapping<G>(
      "gains of the controller",
      {required<G>("kp",
                   loop_value("proportional gain, in V.s/rad for a voltage", "Hz.s/rad", "V.s/rad",
                              "-12.6 Hz.s/rad"),
                   &G::kp),
       required<G>(
           "ki",
           loop_value("integral gain, in V/rad for a voltage", "Hz/rad", "V/rad", "-25253 Hz/rad"),
           &G::ki)});
  const auto given = shape_as<Given, G>(
      numbers, [](G gains) { return Given{gains}; }, [](const Given& gains) { return *gains; });
  auto shape = one_of<Given>("gains of the controller", {automatic, given},
                             [](const Given& gains) { return gains ? std::size_t{1} : 0; });
  shape.schema.example = "auto";
  return shape;
}

Shape<MotionControl> position_shape(const Shape<std::vector<LoopValue>>& range) {
  using C = MotionControl;
  C fresh;
  fresh.kind = C::Kind::position, fresh.encoder = 4000;
  return mapping<C>(
      "sampled position controller, with bursts near the goal",
      {selector<C>("kind", "controlled quantity", "position"),
       required<C>("reference", profile("requested angle", "rad", "0.5 rad"), &C::reference),
       standard<C>("sample_time", quantity("time between samples", "s", "1 ms"), &C::sample_time),
       standard<C>("delay",
                   count("delay from a measurement to its output, in whole samples", "1", 0, 100),
                   &C::delay),
       standard<C>("encoder", count("counts per revolution", "4000", 1, 1e9), &C::encoder),
       optional<C>("range", range, &C::range, "the motor's frequency_range"),
       hidden(optional<C>(
           "slew",
           loop_value("largest rate at which the frequency may fall", "Hz/s", "V/s", "200 kHz/s"),
           &C::slew, "not limited")),
       optional<C>("gain", quantity("requested speed per remaining angle", "1/s", "150 1/s"),
                   &C::gain, "1 / (3 dead times)"),
       hidden(standard<C>("braking",
                          quantity("share of the deceleration by friction that the requested speed "
                                   "uses; smaller for a motor that coasts",
                                   "1", "0.5"),
                          &C::braking)),
       standard<C>("window",
                   count("counts from the goal within which the drive stays off", "2", 1, 1e6),
                   &C::window),
       standard<C>("off_time",
                   quantity("time with the drive off before the phases are swapped", "s", "1.5 ms"),
                   &C::off_time)},
      {}, fresh);
}

Shape<MotionControl> control_shape() {
  using C = MotionControl;
  auto range = list("smallest and largest output, in Hz, or in V for a voltage",
                    loop_value("an end of the range", "Hz", "V", "39.7 kHz"), 2, 2);
  range.schema.example = "[39.7 kHz, 44.5 kHz]";
  const auto speed = mapping<C>(
      "sampled speed controller",
      {selector<C>("kind", "controlled quantity", "speed"),
       required<C>("reference", profile("requested speed", "rad/s", "100 rpm"), &C::reference),
       standard<C>("sample_time", quantity("time between samples", "s", "1 ms"), &C::sample_time),
       standard<C>("delay",
                   count("delay from a measurement to its output, in whole samples", "1", 0, 100),
                   &C::delay),
       optional<C>("encoder", count("counts per revolution", "4000", 1, 1e9), &C::encoder,
                   "an exact angle"),
       optional<C>("actuator",
                   word<motion::Actuator>("quantity that the controller adjusts",
                                          {motion::Actuator::frequency, motion::Actuator::voltage}),
                   &C::actuator, "the motor's control"),
       optional<C>("range", range, &C::range, "the motor's frequency_range"),
       optional<C>("start_frequency", quantity("at the start of the motion", "Hz", "43.6 kHz"),
                   &C::start_frequency, "the upper end of the range"),
       hidden(optional<C>("start_voltage", quantity("at the start of the motion", "V", "120 V"),
                          &C::start_voltage, "the motor's voltage")),
       hidden(optional<C>(
           "slew",
           loop_value("largest rate of change, in V/s for a voltage", "Hz/s", "V/s", "400 kHz/s"),
           &C::slew, "not limited")),
       standard<C>("gains", gains_shape(), &C::gains)});
  return one_of<C>("controller, instead of a given frequency or voltage",
                   {speed, position_shape(range)},
                   [](const C& control) { return static_cast<std::size_t>(control.kind); }, "kind",
                   {"speed", "position"});
}

bool has_duration(MotionStudy& study, const Given& given, Diagnostics& diagnostics) {
  return more_than_zero(given, "duration", study.duration, diagnostics);
}

}  // namespace

Shape<MotionStudy> MotionStudy::shape() {
  using M = MotionStudy;
  auto measures = list("quantities to report",
                       text_of<MotionMeasure>("a measure", "time_to(speed, 90 %)", motion_measure,
                                              [](const MotionMeasure& one) { return one.text; }));
  measures.schema.example = "[\"time_to(speed, 90 %)\", overshoot(speed), angle_after(30 ms)]";
  return mapping<M>(
      "starts, stops and changes of load and drive in time; of one motor or of a family over one "
      "parameter",
      {kind_field<M>(),
       optional<M>("family", shapes::family("rotor_inertia: [7e-6 kg.m^2, 1e-4 kg.m^2]"),
                   &M::family, "the motor alone"),
       required<M>("duration", quantity("how long the motion is followed", "s", "40 ms"),
                   &M::duration),
       hidden(standard<M>("engine",
                          word<motion::MotionEngine>(
                              "averaged: one wave, averaged over each vibration; oscillating: each "
                              "vibration of two waves",
                              {motion::MotionEngine::averaged, motion::MotionEngine::oscillating}),
                          &M::engine)),
       hidden(optional<M>("accuracy", accuracy_shape(), &M::accuracy, "1")),
       hidden(standard<M>(
           "axial",
           word<motion::AxialMotion>("averaged engine: axial position of the rotor in balance at "
                                     "each instant (static), or with its inertia (dynamic)",
                                     {motion::AxialMotion::balanced, motion::AxialMotion::dynamic}),
           &M::axial)),
       standard<M>("initial", initial_shape(), &M::initial),
       hidden(optional<M>("drive", drive_shape(), &M::drive, "the motor's at all times")),
       hidden(optional<M>("control", control_shape(), &M::control, "none")),
       optional<M>("load", load_shape(), &M::load, "the motor's"),
       optional<M>("output", output_shape(), &M::output, "a thousand rows"),
       optional<M>("measure", measures, &M::measure, "none")},
      has_duration);
}

}  // namespace twum::inline v0_1::studies
