// SPDX-License-Identifier: Apache-2.0
#include "entries/motion_checks.hpp"

#include "entries/motion_task.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <numbers>
#include <string>

namespace twum::inline v0_1::studies {
namespace {

constexpr double kMostPeriods = 1e6, kMostRows = 1e6;

// The errors of one study with their places.
class MotionCheck {
 public:
  MotionCheck(const MotionStudy& study, const MotorDesign& motor, const YamlNode& root,
              Diagnostics& diagnostics)
      : study_(study), motor_(motor), root_(root), diagnostics_(diagnostics) {}

  void check() {
    check_motor();
    check_entries_of_drive();
    check_axial_motion();
    if (oscillates()) check_motor_of_two_waves();
    if (!oscillates()) check_one_wave();
    if (study_.control) check_control(*study_.control);
    check_values("voltage", study_.drive.voltage, Parameter::voltage);
    check_values("amplitude", study_.drive.amplitude, Parameter::amplitude);
    check_values("frequency", study_.drive.frequency, Parameter::frequency);
    if (diagnostics_.empty()) check_lengths();
    if (diagnostics_.empty()) check_beginning();
  }

 private:
  const YamlNode& asked() const { return *root_.find("study"); }

  // Of the entry that a path such as "drive.voltage" names, or of the last one above it that is there.
  SourceMark mark_of(std::string_view path) const {
    const YamlNode* node = &asked();
    for (std::size_t begin = 0; begin < path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      const YamlNode* next = node->find(path.substr(begin, end - begin));
      if (next == nullptr) break;
      node = next, begin = end + 1;
    }
    return node->mark;
  }

  void say(const std::string& path, std::string found, std::string expected) {
    diagnostics_.add(mark_of(path), "study." + path, std::move(found), std::move(expected));
  }
  void say_of_motor(std::string found, std::string expected) {
    const YamlNode* motor = root_.find("motor");
    diagnostics_.add(motor != nullptr ? motor->mark : SourceMark{1, 1}, "motor", std::move(found),
                     std::move(expected));
  }

  bool varies(Parameter parameter) const {
    return study_.family && study_.family->parameter == parameter;
  }

  void check_motor() {
    if (!motor_.rotor.inertia && !varies(Parameter::rotor_inertia))
      say_of_motor("rotor_inertia is missing, which a motion needs",
                   "give rotor.inertia, such as 7e-6 kg.m^2");
    if (!oscillates() && motor_.stator.imbalance && *motor_.stator.imbalance != Imbalance{})
      say_of_motor("phases or modes are unequal (stator.imbalance), but a motion has one wave",
                   "leave out voltage_ratio, phase_error and mode_splitting");
    if (oscillates() && motor_.stator.radial_motion)
      say_of_motor("its surface also moves radially, which the oscillating engine does not compute",
                   "write 'radial_motion: false' under stator, or leave out 'engine: oscillating'");
  }

  // What an axial motion of the averaged engine needs; the other engine has it anyway.
  void check_axial_motion() {
    if (study_.axial != motion::AxialMotion::dynamic) return;
    if (oscillates())
      return say("axial",
                 "given for the oscillating engine, which computes the axial motion if rotor_mass "
                 "is given",
                 "leave it out");
    if (!(motor_.rotor.mass.value_or(0) > 0) && !varies(Parameter::rotor_mass))
      say_of_motor("it has no rotor_mass, which 'axial: dynamic' needs",
                   "give rotor.mass in the motor file, such as 0.1 kg");
    if (motor_.stator.radial_slices != 1 && !varies(Parameter::radial_slices))
      say_of_motor("radial_slices is not 1, but 'axial: dynamic' has one contact radius",
                   "write 'radial_slices: 1' under stator");
  }

  bool oscillates() const { return study_.engine == motion::MotionEngine::oscillating; }

  // What the oscillating engine does not compute.
  void check_motor_of_two_waves() {
    if (!motor_.stator.voltage)
      say("engine",
          "the oscillating engine needs a motor under a voltage, but the amplitude of this motor "
          "is given",
          "give stator.voltage in the motor file, or write 'engine: averaged'");
    if (motor_.stator.radial_slices != 1 && !varies(Parameter::radial_slices))
      say_of_motor("radial_slices is not 1, but the oscillating engine has one contact radius",
                   "write 'radial_slices: 1' under stator");
    if (motor_.rotor.taper != 0)
      say_of_motor("rotor_taper is not 0, but the oscillating engine has one contact radius",
                   "leave it out");
    if (motor_.friction.threshold > motor_.friction.kinetic)
      say_of_motor("static_friction is above kinetic_friction; the oscillating engine has one",
                   "leave out friction.static");
    if (!motor_.rotor.mass && !varies(Parameter::rotor_mass) && mixes_waves())
      say_of_motor(
          "it has no rotor_mass, which determines how the rotor responds to two waves",
          "give rotor.mass, such as 0.1 kg, or 0 kg for a rotor that follows the larger wave");
  }

  bool mixes_waves() const {
    if (!study_.drive.reversed.empty()) return true;
    if (study_.control && study_.control->kind == MotionControl::Kind::position) return true;
    if (!study_.drive.phase_difference) return false;
    return std::ranges::any_of(
        study_.drive.phase_difference->rows(),
        [](const motion::Profile::Row& row) { return row.second != std::numbers::pi / 2; });
  }

  // What a loop and the entries beside it have to agree on. Its numbers are the engine's to check.
  void check_control(const MotionControl& control) {
    const motion::Actuator actuator = control.actuator_of(motor_);
    const bool by_voltage = actuator == motion::Actuator::voltage;
    if (!motor_.stator.voltage)
      say("control",
          "control needs a motor under a voltage, but the amplitude of this motor is given",
          "give stator.voltage in the motor file");
    if (by_voltage ? study_.drive.voltage.has_value() : study_.drive.frequency.has_value())
      say(by_voltage ? "drive.voltage" : "drive.frequency",
          "given, although 'control' changes this quantity", "leave it out, or leave out control");
    if (!study_.drive.reversed.empty())
      say("drive.reversed", "phases cannot be swapped while 'control' is active",
          "leave it out, or leave out control");
    if (control.range.empty() && (by_voltage || !motor_.stator.frequency_range))
      say("control", "the range of its output is missing",
          by_voltage ? "give range, such as [100 V, 160 V]"
                     : "give range, such as [39.7 kHz, 44.5 kHz], or stator.frequency_range");
    check_numbers_of(control);
    const auto check_unit = [&](const char* entry, const LoopValue& value) {
      if (value.unit == actuator) return true;
      say(std::string("control.") + entry,
          by_voltage ? "a frequency, but the controller changes the voltage"
                     : "a voltage, but the controller changes the frequency",
          by_voltage ? "give it in V, or write 'actuator: frequency'"
                     : "give it in Hz, or write 'actuator: voltage'");
      return false;
    };
    for (const LoopValue& end : control.range)
      if (!check_unit("range", end)) break;
    if (control.slew) check_unit("slew", *control.slew);
    if (control.gains)
      check_unit("gains", control.gains->kp) && check_unit("gains", control.gains->ki);
    if (by_voltage ? control.start_frequency.has_value() : control.start_voltage.has_value())
      say(by_voltage ? "control.start_frequency" : "control.start_voltage",
          by_voltage ? "a frequency, but the controller changes the voltage"
                     : "a voltage, but the controller changes the frequency",
          by_voltage ? "give start_voltage" : "give start_frequency");
  }

  // Numbers of a loop that are impossible whatever the motor.
  void check_numbers_of(const MotionControl& control) {
    const auto positive = [&](const char* entry, double value, const char* unit) {
      if (!(value > 0))
        say(std::string("control.") + entry, engineering(value, unit), "expected more than 0");
    };
    positive("sample_time", control.sample_time, "s");
    if (control.slew) positive("slew", control.slew->value, "1/s");
    if (control.gain) positive("gain", *control.gain, "1/s");
    if (!(control.braking > 0 && control.braking <= 1))
      say("control.braking", number_text_of(control.braking), "expected more than 0, at most 1");
    if (control.off_time < 0)
      say("control.off_time", engineering(control.off_time, "s"), "expected 0 s or more");
    const auto backward = [](const motion::Profile::Row& row) { return row.second < 0; };
    if (control.kind == MotionControl::Kind::speed &&
        std::ranges::any_of(control.reference.rows(), backward))
      say("control.reference", "a negative speed",
          "expected 0 or more; the speed controller does not swap the phases");
    if (control.range.size() != 2) return;
    const double least = control.range[0].value, most = control.range[1].value;
    if (!(least < most))
      return say("control.range", "the range does not rise",
                 "expected such as [39.7 kHz, 44.5 kHz]");
    const auto within = [&](const char* entry, const std::optional<double>& start) {
      if (start && !(*start >= least && *start <= most))
        say(std::string("control.") + entry, "the start is outside the range of the output",
            "give one within the range");
    };
    within("start_frequency", control.start_frequency);
    within("start_voltage", control.start_voltage);
  }

  void check_one_wave() {
    if (study_.accuracy)
      say("accuracy", "the averaged engine has no accuracy setting",
          "leave it out, or write 'engine: oscillating'");
    if (study_.drive.phase_difference)
      say("drive.phase_difference", "the averaged engine has one wave and no phase difference",
          "write 'engine: oscillating'");
  }

  void check_entries_of_drive() {
    const bool driven = motor_.stator.voltage.has_value();
    if (!driven && study_.drive.voltage)
      say("drive.voltage", "the amplitude of this motor is given, so it has no voltage",
          "give drive.amplitude, or stator.voltage in the motor file");
    if (driven && study_.drive.amplitude)
      say("drive.amplitude", "this motor has a voltage, so its amplitude cannot be given",
          "give drive.voltage");
    for (const motion::Interval& off : study_.drive.switched_off)
      if (off.begin >= study_.duration)
        say("drive.switched_off", "the interval begins after the end of the motion",
            "increase 'duration', or leave the interval out");
    if (!driven && !study_.drive.switched_off.empty())
      say("drive.switched_off", "a motor with a given amplitude has no drive to switch off",
          "give drive.amplitude over time, or stator.voltage in the motor file");
  }

  void check_values(const char* entry, const std::optional<motion::Profile>& profile,
                    Parameter parameter) {
    if (!profile) return;
    for (const auto& [time, value] : profile->rows()) {
      const std::string wrong = complaint(parameter, value);
      if (wrong.empty()) continue;
      say(std::string("drive.") + entry, std::string(info(parameter).name) + " " + wrong,
          "change it");
      return;
    }
  }

  void check_lengths() {
    const double frequency = motion_task(study_, motor_).frequency.largest();
    if (study_.duration * frequency > kMostPeriods)
      say("duration",
          engineering(study_.duration, "s") + " are " +
              number_text_of(study_.duration * frequency) + " periods of the drive",
          "expected at most 1e6, " + engineering(kMostPeriods / frequency, "s"));
    if (!(study_.step() > 0) || study_.duration / study_.step() > kMostRows)
      say("output.step", "the step gives more than a million rows",
          "expected at least " + engineering(study_.duration / kMostRows, "s"));
    for (const MotionMeasure& one : study_.measure)
      if (one.at > study_.duration && one.column.empty())
        say("measure", quoted(one.text) + " asks for a time after the end",
            "expected times up to " + engineering(study_.duration, "s"));
  }

  static std::string number_text_of(double number) { return engineering(number, "1"); }

  // What only the engine can tell: whether a steady wave runs, whether there is an integrator.
  void check_beginning() {
    if (study_.family) return;  // each of its motors says it when the study runs
    const MotorDesign motor = motion_motor(study_, motor_);
    try {
      const motion::MotionTask task = motion_task(study_, motor);
      if (study_.control && study_.control->kind == MotionControl::Kind::position)
        motion::require_control(motor, task, position_control(*study_.control, motor));
      else if (study_.control)
        motion::require_control(motor, task, speed_control(*study_.control, motor));
      else
        motion::require_motion(motor, task);
    } catch (const InputError& error) {
      const char* entry = study_.control ? "control" : study_.initial.steady ? "initial" : "kind";
      say(entry, error.what(),
          study_.initial.steady ? "begin at rest, or with another drive or load" : "");
    }
  }

  const MotionStudy& study_;
  const MotorDesign& motor_;
  const YamlNode& root_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_motion(const Study& study, const MotorDesign& motor, const YamlNode& root,
                  Diagnostics& diagnostics) {
  if (const auto* asked = std::get_if<MotionStudy>(&study))
    MotionCheck(*asked, motor, root, diagnostics).check();
}

}  // namespace twum::inline v0_1::studies
