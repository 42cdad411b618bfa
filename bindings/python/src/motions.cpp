// SPDX-License-Identifier: Apache-2.0
// Motions in time and linear plants as arrays.
#include "conversions.hpp"
#include "entries/motion_columns.hpp"
#include "interruptible.hpp"
#include "motor_answers.hpp"
#include "telling/renderers.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/motion.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::python {
namespace {

using namespace motion;

constexpr std::uint64_t kParts = 100;  // that progress is told of

// A value, or rows (time, value).
Profile to_profile(const std::string& name, const py::object& value, const char* unit,
                   const char* example) {
  const auto finite = [&](const std::string& what, py::handle given, const char* its_unit,
                          const char* its_example) {
    const double number = to_quantity(what, given, its_unit, its_example);
    if (!std::isfinite(number)) throw InputError(what + ": expected a finite value");
    return number;
  };
  if (py::isinstance<py::str>(value) || number_of(value)) return finite(name, value, unit, example);
  std::vector<Profile::Row> rows;
  for (const py::handle row : py::iter(value)) {
    const auto pair = py::reinterpret_borrow<py::object>(row);
    if (py::isinstance<py::str>(pair) || !PySequence_Check(pair.ptr()) || py::len(pair) != 2)
      throw InputError(name + ": expected a value, or rows of a time and a value, such as [(0, '" +
                       example + "')]");
    rows.emplace_back(finite(name + ": time", pair[py::int_(0)], "s", "5 ms"),
                      finite(name, pair[py::int_(1)], unit, example));
  }
  return Profile(std::move(rows));
}

std::vector<Interval> to_intervals(const std::string& name, const py::object& value) {
  const Profile rows = to_profile(name, value, "s", "20 ms");
  std::vector<Interval> intervals;
  for (const auto& [begin, end] : rows.rows()) intervals.push_back({begin, end});
  return intervals;
}

// The value whose word is given, of two.
template <typename E>
E to_value(const std::string& argument, const std::string& word, E one, E other) {
  for (const E value : {one, other})
    if (word == motion::to_string(value)) return value;
  throw InputError(argument + ": expected '" + motion::to_string(one) + "' or '" +
                   motion::to_string(other) + "', but is '" + word + "'");
}

MotionEngine to_engine(const std::string& word) {
  return to_value("engine", word, MotionEngine::averaged, MotionEngine::oscillating);
}

AxialMotion to_axial(const std::string& word) {
  return to_value("axial", word, AxialMotion::balanced, AxialMotion::dynamic);
}

std::vector<double> equal_times(double duration, std::size_t points) {
  if (points < 2) throw InputError("points: expected at least 2");
  std::vector<double> times;
  for (std::size_t k = 0; k < points; ++k)
    times.push_back(duration * static_cast<double>(k) / static_cast<double>(points - 1));
  return times;
}

// What Motor.move() is given beside its duration.
struct MoveArguments {
  py::object voltage, amplitude, frequency, load_torque, switched_off, reversed, phase_difference;
  bool steady;
  std::string engine, axial;
  std::optional<double> accuracy;
  std::size_t points;
};

// Arguments that would change nothing.
void refuse_unused(const MotorDesign& design, const MoveArguments& given) {
  const bool driven = design.stator.voltage.has_value();
  if (driven && !given.amplitude.is_none())
    throw InputError("amplitude: this motor is driven by a voltage; give voltage");
  if (!driven && !given.voltage.is_none())
    throw InputError("voltage: the amplitude of this motor is given; give amplitude");
  if (given.accuracy && to_engine(given.engine) == MotionEngine::averaged)
    throw InputError("accuracy: only the oscillating engine has one; leave it out");
}

MotionTask to_task(const MotorDesign& design, const py::object& duration,
                   const MoveArguments& given) {
  refuse_unused(design, given);
  MotionTask task = steady_drive(design, to_quantity("duration", duration, "s", "20 ms"));
  const auto take = [](Profile& profile, const char* name, const py::object& value,
                       const char* unit, const char* example) {
    if (!value.is_none()) profile = to_profile(name, value, unit, example);
  };
  take(task.voltage, "voltage", given.voltage, "V", "140 V");
  take(task.amplitude, "amplitude", given.amplitude, "m", "1.4 um");
  take(task.frequency, "frequency", given.frequency, "Hz", "40.8 kHz");
  take(task.load_torque, "load_torque", given.load_torque, "N.m", "0.2 N.m");
  take(task.phase_difference, "phase_difference", given.phase_difference, "rad", "90 deg");
  if (py::len(given.switched_off) > 0)
    task.switched_off = to_intervals("switched_off", given.switched_off);
  if (py::len(given.reversed) > 0) task.reversed = to_intervals("reversed", given.reversed);
  task.initial.steady = given.steady;
  task.engine = to_engine(given.engine), task.accuracy = given.accuracy.value_or(1);
  task.axial = to_axial(given.axial);
  task.output_times = equal_times(task.duration, given.points);
  return task;
}

py::dict event_of(const MotionEvent& event) {
  py::dict one;
  one["event"] = to_string(event.kind), one["time"] = event.time, one["speed"] = event.speed;
  one["angle"] = event.angle, one["amplitude"] = event.amplitude;
  return one;
}

// The motion as the answer of a study, as a cell of a notebook shows it.
std::string motion_as_html(const PyMotor& motor, const MotionTask& task, const Motion& found) {
  studies::MotionResult::Member member;
  member.value = kNoValue;
  member.motion = found;
  member.opening_amplitude = opening_amplitude(motor.motor.design());
  if (!task.switched_off.empty()) member.off_at = task.switched_off.back().begin;
  studies::MotionResult answer;
  answer.engine = task.engine, answer.accuracy = task.accuracy, answer.duration = task.duration;
  answer.members = {member};
  studies::StudyResult result;
  result.kind = studies::StudyKind::motion, result.motor = motor.name, result.answer = answer;
  if (found.status == "stopped") result.outcome = studies::StudyOutcome::interrupted;
  return studies::telling::summary_html(result, {});
}

py::object move(const py::object& self, const py::object& duration, const MoveArguments& given,
                const py::object& stop, const py::object& progress) {
  const PyMotor& motor = py::cast<const PyMotor&>(self);
  const MotorDesign design = motor.motor.design();
  MotionTask task = to_task(design, duration, given);
  RunningCall call;
  Watch watch(stop, progress, kParts);
  std::uint64_t told = 0;
  const Motion found = run_interruptible(
      call,
      [&](const std::stop_token& asked) {
        task.go_on = [&](double time) {
          const auto part = static_cast<std::uint64_t>(kParts * time / task.duration);
          watch.count(part - std::exchange(told, part));
          return !asked.stop_requested();
        };
        Motion motion = simulate(design, task);
        if (task.engine == MotionEngine::averaged) add_what_is_left_out(design, task, motion);
        return motion;
      },
      [&] { watch.poll(call); });
  const auto column = [&](auto of) {
    std::vector<double> values;
    for (const MotionSample& sample : found.samples) values.push_back(of(sample));
    return to_array(values);
  };
  py::dict columns;
  columns["time"] = column([](const MotionSample& sample) { return sample.time; });
  for (const studies::MotionColumn& one : studies::motion_columns())
    columns[one.name] = column(one.of);
  return attribute_of_results("Motion")(self, columns, list_of(found.events, event_of),
                                        found.status, found.end,
                                        motion_as_html(motor, task, found));
}

py::object plant_of(const py::object& self, const py::object& load_torque,
                    const std::string& axial) {
  const MotorDesign design = py::cast<const PyMotor&>(self).motor.design();
  const LinearPlant plant =
      linearize(design, to_quantity("load_torque", load_torque, "N.m", "0.2 N.m"), to_axial(axial));
  const auto matrix = [](const LinearPlant::Matrix& rows) {
    Array numbers({rows.size(), rows.empty() ? 0 : rows.front().size()});
    for (std::size_t i = 0; i < rows.size(); ++i)
      std::ranges::copy(rows[i], numbers.mutable_data(static_cast<py::ssize_t>(i)));
    return numbers;
  };
  const auto signals = [](const std::vector<Signal>& list) {
    py::dict steady;
    for (const Signal& one : list) steady[one.name.c_str()] = one.steady;
    return steady;
  };
  py::object numpy = py::module_::import("numpy");
  return attribute_of_results("Plant")(
      self, signals(plant.states), signals(plant.inputs), signals(plant.outputs), matrix(plant.a),
      matrix(plant.b), matrix(plant.c), matrix(plant.d),
      numpy.attr("array")(list_of(plant.poles, [](const auto& p) { return py::cast(p); })),
      matrix(plant.gains));
}

}  // namespace

void add_motions(py::class_<PyMotor, std::shared_ptr<PyMotor>>& motor) {
  motor.def(
      "move",
      [](const py::object& self, const py::object& duration, const py::object& voltage,
         const py::object& amplitude, const py::object& frequency, const py::object& load_torque,
         const py::object& switched_off, const py::object& reversed,
         const py::object& phase_difference, bool steady, const std::string& engine,
         const std::string& axial, std::optional<double> accuracy, std::size_t points,
         const py::object& stop, const py::object& progress) {
        return move(self, duration,
                    {voltage, amplitude, frequency, load_torque, switched_off, reversed,
                     phase_difference, steady, engine, axial, accuracy, points},
                    stop, progress);
      },
      py::arg("duration"), py::kw_only(), py::arg("voltage") = py::none(),
      py::arg("amplitude") = py::none(), py::arg("frequency") = py::none(),
      py::arg("load_torque") = py::none(), py::arg("switched_off") = py::tuple(),
      py::arg("reversed") = py::tuple(), py::arg("phase_difference") = py::none(),
      py::arg("steady") = false, py::arg("engine") = "averaged", py::arg("axial") = "static",
      py::arg("accuracy") = py::none(), py::arg("points") = 401, py::arg("stop") = py::none(),
      py::arg("progress") = py::none(),
      "move(self, duration, *, voltage=None, amplitude=None, frequency=None, load_torque=None, "
      "switched_off=(), reversed=(), phase_difference=None, steady=False, "
      "engine='averaged', axial='static', accuracy=None, points=401, stop=None, "
      "progress=None)\n--\n\n"
      "A motion in time, a Motion: from rest, or from the steady state under the first values. "
      "Voltage, amplitude,\nfrequency, load torque and phase difference are values, by default "
      "the motor's, or rows (time, value), linear\nbetween rows; two rows of one time are a "
      "step. `switched_off` and `reversed` are intervals (from, to). Numbers\nare in SI units, "
      "texts carry their unit. `stop` and `progress` are those of evaluate().");
  motor.def("linearize", &plant_of, py::arg("load_torque") = 0.0, py::arg("axial") = "static",
            "linearize(self, load_torque=0.0, axial='static')\n--\n\nThe motor near its steady "
            "state under a load torque, as a controller sees it: a Plant. With axial='dynamic' the "
            "rotor's height\nand its rate are states, too.");
}

}  // namespace twum::inline v0_1::python
