// SPDX-License-Identifier: Apache-2.0
#include "control/position_loop.hpp"
#include "control/speed_loop.hpp"
#include "engine.hpp"

#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kMostSamples = 1e6;

Parameter parameter_of(Actuator actuator) {
  return actuator == Actuator::voltage ? Parameter::voltage : Parameter::frequency;
}

void require_samples(const MotionTask& task, double sample_time, int delay) {
  if (!(sample_time > 0 && std::isfinite(sample_time)))
    throw InputError("sample_time of a loop must be more than 0 s");
  if (task.duration / sample_time > kMostSamples)
    throw InputError("sample_time of a loop is too short: a motion may have a million samples");
  if (delay < 0 || delay > 100) throw InputError("delay of a loop must be 0 to 100 samples");
}

void require_counts(double encoder) {
  if (!(encoder >= 1 && encoder <= 1e9))
    throw InputError("encoder of a loop must have 1 to 1e9 counts a turn");
}

void require_range(const std::pair<double, double>& range, Actuator actuator) {
  if (!(range.first < range.second))
    throw InputError("range of a loop must rise from its least to its largest output");
  for (const double end : {range.first, range.second})
    require_admissible(parameter_of(actuator), end);
}

void require_loop(const MotionTask& task, const SpeedControl& c) {
  require_samples(task, c.sample_time, c.delay);
  if (c.encoder) require_counts(*c.encoder);
  require_range(c.range, c.actuator);
  if (!(c.start >= c.range.first && c.start <= c.range.second))
    throw InputError("a loop must start with an output within its range");
  if (c.slew && !(*c.slew > 0)) throw InputError("slew of a loop must be more than 0");
  for (const auto& [time, speed] : c.reference.rows())
    if (!(speed >= 0)) throw InputError("the reference of a speed loop must be 0 or more");
  if (!(c.reference.largest() > 0))
    throw InputError("the reference of a speed loop must not be 0 at all times");
}

void require_loop(const MotorDesign& design, const MotionTask& task, const PositionControl& c) {
  require_samples(task, c.sample_time, c.delay);
  require_counts(c.encoder);
  require_range(c.range, Actuator::frequency);
  if (c.slew && !(*c.slew > 0)) throw InputError("slew of a loop must be more than 0");
  if (c.gain && !(*c.gain > 0)) throw InputError("gain of a position loop must be more than 0");
  if (!(c.braking > 0 && c.braking <= 1))
    throw InputError("braking of a position loop must be more than 0 and at most 1");
  if (!(c.window >= 1)) throw InputError("window of a position loop must be 1 count or more");
  if (!(c.off_time >= 0)) throw InputError("off_time of a position loop must be 0 s or more");
  if (task.engine == MotionEngine::oscillating && !design.rotor.mass)
    throw InputError(
        "rotor_mass is missing; when a position loop swaps phases, it decides how both waves share "
        "the rotor: give rotor.mass, such as 0.1 kg, or 0 kg for a rotor that follows the wave");
}

// The load torque at the time of the largest reference.
double torque_there(const MotionTask& task, const SpeedControl& c) {
  const auto row = std::ranges::max_element(c.reference.rows(), {}, &Profile::Row::second);
  return task.load_torque.after(row->first);
}

// The steady speeds over the range of the loop's output.
class SpeedMap {
 public:
  SpeedMap(const MotorDesign& design, Actuator actuator, const std::pair<double, double>& range,
           double torque)
      : design_(design), actuator_(actuator), torque_(torque), range_(range) {
    constexpr int kPoints = 33;
    for (int k = 0; k < kPoints; ++k) {
      outputs_.push_back(std::lerp(range_.first, range_.second, k / (kPoints - 1.0)));
      speeds_.push_back(speed(outputs_.back()));
    }
  }

  // With all friction of the load; NaN where the motor does not run.
  double speed(double output) const {
    try {
      return loop_plant(linearize(with(design_, parameter_of(actuator_), output), torque_),
                        actuator_)
          .speed;
    } catch (const InputError&) {
      return std::nan("");
    }
  }

  void require_monotone() const {
    const bool rises = speeds_.back() > speeds_.front();
    for (std::size_t k = 1; k < speeds_.size(); ++k)
      if (!(rises ? speeds_[k] > speeds_[k - 1] : speeds_[k] < speeds_[k - 1]))
        throw InputError(
            "the speed must rise or fall with the output on all of the loop's range, with a "
            "running wave at each; take a narrower range");
  }

  // The output that gives a speed; none outside the range.
  std::optional<double> output(double asked) const {
    double low = range_.first, high = range_.second;
    const bool rises = speeds_.back() > speeds_.front();
    const auto [least, most] = std::minmax(speeds_.front(), speeds_.back());
    if (!(asked >= least && asked <= most)) return {};
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      ((speed(middle) < asked) == rises ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  const MotorDesign& design_;
  Actuator actuator_;
  double torque_;
  std::pair<double, double> range_;
  std::vector<double> outputs_{}, speeds_{};
};

// The linear plant at the operating point of a loop.
LinearPlant plant_of(const MotorDesign& design, const MotionTask& task, const SpeedControl& c) {
  const double torque = torque_there(task, c);
  const SpeedMap map(design, c.actuator, c.range, torque);
  map.require_monotone();
  const std::optional<double> output = map.output(c.reference.largest());
  if (!output)
    throw InputError("no output within the loop's range gives the largest reference speed");
  return linearize(with(design, parameter_of(c.actuator), *output), torque);
}

void require_sign(const LoopGains& gains, const LoopPlant& plant) {
  if (gains.proportional * plant.gain >= 0 && gains.integral * plant.gain > 0) return;
  throw InputError(plant.gain < 0
                       ? "gains of a loop must be negative where the speed falls with its output"
                       : "gains of a loop must be positive where the speed rises with its output");
}

ControlledMotion prepared(const MotorDesign& design, const MotionTask& task,
                          const SpeedControl& c) {
  require_loop(task, c);
  const LinearPlant plant = plant_of(design, task, c);
  ControlledMotion motion;
  motion.plant = loop_plant(plant, c.actuator);
  motion.gains = c.gains.value_or(loop_gains(motion.plant, c.sample_time, c.delay));
  require_sign(motion.gains, motion.plant);
  motion.margins = loop_margins(plant, c, motion.gains);
  return motion;
}

MotionTask with_start(MotionTask task, const SpeedControl& c) {
  (c.actuator == Actuator::voltage ? task.voltage : task.frequency) = c.start;
  return task;
}

std::vector<double> sample_times(const MotionTask& task, double sample) {
  std::vector<double> times;
  for (int k = 0; k * sample < task.duration; ++k) times.push_back(k * sample);
  return times;
}

// Follows a motor under a loop, which sees its angle at each sample.
Motion followed(const MotorDesign& design, const MotionTask& task, double sample_time, Loop& loop) {
  const std::vector<double> samples = sample_times(task, sample_time);
  const std::unique_ptr<Engine> engine = engine_of(design, task);
  const std::vector<Stretch> stretches =
      stretches_of(task, design.stator.voltage.has_value(), samples);
  engine->begin(task.initial.steady ? before_the_first(task) : stretches.front());
  loop.begin(engine->angle(), engine->speed());
  std::size_t next = 0;
  for (const Stretch& stretch : stretches) {
    if (next < samples.size() && stretch.begin >= samples[next] - kSameTime * task.duration)
      loop.sample(samples[next++], engine->angle());
    for (const Stretch& part : loop.applied(stretch))
      if (!engine->follow(part)) return engine->finish();
  }
  return engine->finish();
}

// mu_0 F_N r / J
double friction_deceleration(const MotorDesign& design) {
  const double inertia =
      design.rotor.inertia.value_or(1) + design.load.value_or(ShaftLoad{}).inertia;
  return Motor(design).holding_torque() / inertia;
}

// With the gain, and the task with the drive of the beginning.
struct PreparedPosition {
  PositionControl control;
  MotionTask task;
  SpeedMap map;

  PreparedPosition(const MotorDesign& design, const MotionTask& asked, const PositionControl& c)
      : control(c), task(asked), map(design, Actuator::frequency, c.range, 0) {
    map.require_monotone();
    if (!control.gain) control.gain = 1 / (3 * (c.delay + 1) * c.sample_time);
    task.frequency = c.range.second;
  }
};

}  // namespace

void require_control(const MotorDesign& design, const MotionTask& task,
                     const SpeedControl& control) {
  prepared(design, task, control);
  require_motion(design, with_start(task, control));
}

void require_control(const MotorDesign& design, const MotionTask& task,
                     const PositionControl& control) {
  require_loop(design, task, control);
  require_motion(design, PreparedPosition(design, task, control).task);
}

ControlledMotion simulate(const MotorDesign& design, const MotionTask& task,
                          const SpeedControl& control) {
  ControlledMotion result = prepared(design, task, control);
  SpeedLoop loop(control, result.gains);
  result.motion = followed(design, with_start(task, control), control.sample_time, loop);
  return result;
}

Motion simulate(const MotorDesign& design, const MotionTask& task, const PositionControl& control) {
  require_loop(design, task, control);
  const PreparedPosition ready(design, task, control);
  const auto [least, most] = control.range;
  const double slowest = std::min(ready.map.speed(least), ready.map.speed(most));
  // Speeds beyond the range are those of its fast end.
  const double fast_end = ready.map.speed(least) > ready.map.speed(most) ? least : most;
  const auto output = [&](double speed) { return ready.map.output(speed).value_or(fast_end); };
  PositionLoop loop(ready.control, output, slowest, friction_deceleration(design));
  return followed(design, ready.task, control.sample_time, loop);
}

std::vector<ScheduleRow> gain_schedule(const MotorDesign& design, double load_torque,
                                       Actuator actuator, const std::vector<double>& outputs,
                                       double sample_time, int delay) {
  if (!design.stator.voltage)
    throw InputError("a gain schedule needs a motor under a voltage; give stator.voltage");
  if (!design.rotor.inertia) throw InputError("rotor_inertia is missing; a gain schedule needs it");
  require_samples({.duration = sample_time}, sample_time, delay);
  std::vector<ScheduleRow> rows;
  for (const double output : outputs) {
    rows.emplace_back().output = output;
    try {
      rows.back().plant = loop_plant(
          linearize(with(design, parameter_of(actuator), output), load_torque), actuator);
      rows.back().gains = loop_gains(*rows.back().plant, sample_time, delay);
    } catch (const InputError&) {  // the motor does not run there
    }
  }
  return rows;
}

}  // namespace twum::inline v0_1::motion
