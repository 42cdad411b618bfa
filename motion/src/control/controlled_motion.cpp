// SPDX-License-Identifier: Apache-2.0
#include "control/speed_loop.hpp"
#include "engine.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::motion {
namespace {

constexpr double kMostSamples = 1e6;

Parameter parameter_of(Actuator actuator) {
  return actuator == Actuator::voltage ? Parameter::voltage : Parameter::frequency;
}

void require_loop(const MotionTask& task, const SpeedControl& c) {
  if (!(c.sample_time > 0 && std::isfinite(c.sample_time)))
    throw InputError("sample_time of a loop must be more than 0 s");
  if (task.duration / c.sample_time > kMostSamples)
    throw InputError("sample_time of a loop is too short: a motion may have a million samples");
  if (c.delay < 0 || c.delay > 100) throw InputError("delay of a loop must be 0 to 100 samples");
  if (c.encoder && !(*c.encoder >= 1 && *c.encoder <= 1e9))
    throw InputError("encoder of a loop must have 1 to 1e9 counts a turn");
  const auto [least, most] = c.range;
  if (!(least < most)) throw InputError("range of a loop must rise from its least to its largest output");
  for (const double end : {least, most}) require_admissible(parameter_of(c.actuator), end);
  if (!(c.start >= least && c.start <= most))
    throw InputError("a loop must start with an output within its range");
  if (c.slew && !(*c.slew > 0)) throw InputError("slew of a loop must be more than 0");
  for (const auto& [time, speed] : c.reference.rows())
    if (!(speed >= 0)) throw InputError("the reference of a speed loop must be 0 or more");
  if (!(c.reference.largest() > 0)) throw InputError("the reference of a speed loop must not be 0 at all times");
}

// The load torque at the time of the largest reference.
double torque_there(const MotionTask& task, const SpeedControl& c) {
  const auto row = std::ranges::max_element(c.reference.rows(), {}, &Profile::Row::second);
  return task.load_torque.after(row->first);
}

// The steady speeds over the range of the loop's output.
class SpeedMap {
 public:
  SpeedMap(const MotorDesign& design, const SpeedControl& c, double torque)
      : design_(design), actuator_(c.actuator), torque_(torque), range_(c.range) {
    constexpr int kPoints = 33;
    for (int k = 0; k < kPoints; ++k) {
      outputs_.push_back(std::lerp(range_.first, range_.second, k / (kPoints - 1.0)));
      speeds_.push_back(speed(outputs_.back()));
    }
  }

  // With all friction of the load; NaN where the motor does not run.
  double speed(double output) const {
    try {
      return loop_plant(linearize(with(design_, parameter_of(actuator_), output), torque_), actuator_)
          .speed;
    } catch (const InputError&) {
      return std::nan("");
    }
  }

  bool is_monotone() const {
    const bool rises = speeds_.back() > speeds_.front();
    for (std::size_t k = 1; k < speeds_.size(); ++k)
      if (!(rises ? speeds_[k] > speeds_[k - 1] : speeds_[k] < speeds_[k - 1])) return false;
    return true;
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
  const SpeedMap map(design, c, torque);
  if (!map.is_monotone())
    throw InputError(
        "the speed must rise or fall with the output on all of the loop's range, with a running "
        "wave at each; take a narrower range");
  const std::optional<double> output = map.output(c.reference.largest());
  if (!output)
    throw InputError("no output within the loop's range gives the largest reference speed");
  return linearize(with(design, parameter_of(c.actuator), *output), torque);
}

void require_sign(const LoopGains& gains, const LoopPlant& plant) {
  if (gains.proportional * plant.gain >= 0 && gains.integral * plant.gain > 0) return;
  throw InputError(plant.gain < 0 ? "gains of a loop must be negative where the speed falls with its output"
                                  : "gains of a loop must be positive where the speed rises with its output");
}

ControlledMotion prepared(const MotorDesign& design, const MotionTask& task, const SpeedControl& c) {
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

}  // namespace

void require_control(const MotorDesign& design, const MotionTask& task, const SpeedControl& control) {
  prepared(design, task, control);
  require_motion(design, with_start(task, control));
}

ControlledMotion simulate(const MotorDesign& design, const MotionTask& task,
                          const SpeedControl& control) {
  ControlledMotion result = prepared(design, task, control);
  const MotionTask started = with_start(task, control);
  const std::vector<double> samples = sample_times(started, control.sample_time);
  const std::unique_ptr<Engine> engine = engine_of(design, started);
  std::vector<Stretch> stretches =
      stretches_of(started, design.stator.voltage.has_value(), samples);
  engine->begin(started.initial.steady ? before_the_first(started) : stretches.front());
  SpeedLoop loop(control, result.gains, engine->angle(), engine->speed());
  std::size_t next = 0;
  for (Stretch& stretch : stretches) {
    if (next < samples.size() && stretch.begin >= samples[next] - kSameTime * task.duration)
      loop.sample(samples[next++], engine->angle());
    (control.actuator == Actuator::voltage ? stretch.voltage : stretch.frequency) =
        Ramp{stretch.begin, loop.output(), 0};
    if (!engine->follow(stretch)) break;
  }
  result.motion = engine->finish();
  return result;
}

}  // namespace twum::motion
