// SPDX-License-Identifier: Apache-2.0
#include "entries/motion_task.hpp"
#include "kinds/sample/family_run.hpp"
#include "kinds/sample/motion_measures.hpp"

#include <twum/base/no_value.hpp>
#include <twum/motion/left_out.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

using motion::MotionSample;
using motion::MotionTask;

std::vector<double> times_with(std::vector<double> times,
                               const std::vector<MotionMeasure>& measures, double duration) {
  for (const MotionMeasure& one : measures)
    for (const double time : times_of(one))
      if (time <= duration) times.push_back(time);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// A row for each time.
class MotionRun : public FamilyRun<MotionResult> {
 public:
  MotionRun(const MotionStudy& asked, const MotorDesign& base)
      : FamilyRun(asked.family, motion_motor(asked, base), motion_times(asked).size()),
        asked_(asked),
        times_(motion_times(asked)) {
    for (const std::size_t column : asked.output.columns)
      columns_.push_back(&motion_columns()[column]);
    if (columns_.empty())
      for (const MotionColumn& one : motion_columns())
        if (!one.of_two_waves || is_oscillating()) columns_.push_back(&one);
  }

 private:
  std::vector<StoredColumn> own_columns() const override {
    std::vector<StoredColumn> columns{{"time", "s"}};
    for (const MotionColumn* one : columns_) columns.push_back({one->name, one->unit});
    return columns;
  }

  MotionResult frame() const override {
    MotionResult result;
    result.duration = asked_.duration, result.step = asked_.step();
    result.engine = asked_.engine, result.accuracy = asked_.accuracy.value_or(1);
    result.reference = reference_at(asked_.duration);
    return result;
  }

  // A motion that ends early is an answer.
  bool has_answer(const Member& one) const override { return one.motion.end > 0; }

  // NaN behind the time at which the motion ended.
  void add_numbers(const Member& one, StoredRow& row) const override {
    const double time = times_[row.index];
    row.values.push_back(time);
    const auto& samples = one.motion.samples;
    const auto at = std::ranges::lower_bound(samples, time, {}, &MotionSample::time);
    const bool known = at != samples.end() && at->time == time;
    for (const MotionColumn* column : columns_)
      row.values.push_back(known ? column->of(*at) : kNoValue);
    if (!known) row.status = one.motion.status;
  }

  Member computed(const FamilyMotor& motor) const override {
    MotionTask task = motion_task(asked_, motor.design);
    task.output_times = times_with(times_, asked_.measure, asked_.duration);
    task.go_on = [this, told = 0.0](double time) mutable { return goes_on(time, 0, told); };
    Member one;
    one.motion = moved(motor.design, task, &one.loop);
    if (!is_oscillating() && !may_swap())
      motion::add_what_is_left_out(motor.design, task, one.motion);
    const std::vector<motion::Interval>& off = task.switched_off;
    const double last_on = off.empty() ? asked_.duration : off.front().begin;
    if (!off.empty()) one.off_at = off.back().begin;
    one.measures = measured(asked_.measure, one.motion, {last_on, reference_at(last_on)});
    one.opening_amplitude = motion::opening_amplitude(motor.design);
    if (is_oscillating()) add_step_errors(one, motor.design, task, last_on);
    return one;
  }

  // Of the time for both accuracies, that of the finer one: a quarter of the points and steps takes a quarter of the time.
  static constexpr double kFineShare = 0.8;

  // Tells each thousandth of a motion.
  bool goes_on(double time, double from, double& told) const {
    const double first = is_oscillating() ? kFineShare : 1;
    const double share = from + (from == 0 ? first : 1 - kFineShare) * time / asked_.duration;
    if (share >= told + 0.001) tell(told = share);
    return !asked_to_stop();
  }

  motion::Motion moved(const MotorDesign& design, const MotionTask& task,
                       std::optional<MotionResult::Loop>* loop) const {
    if (!asked_.control) return motion::simulate(design, task);
    if (asked_.control->kind == MotionControl::Kind::position)
      return motion::simulate(design, task, position_control(*asked_.control, design));
    const motion::SpeedControl control = speed_control(*asked_.control, design);
    motion::ControlledMotion result = motion::simulate(design, task, control);
    if (loop != nullptr)
      *loop = MotionResult::Loop{control.actuator, result.gains, result.plant, result.margins};
    return std::move(result.motion);
  }

  std::optional<MotionResult::Reference> reference_at(double time) const {
    if (!asked_.control) return {};
    return MotionResult::Reference{asked_.control->kind, asked_.control->reference.before(time)};
  }

  // A loop of the position swaps phases where it needs to.
  bool may_swap() const {
    return asked_.control && asked_.control->kind == MotionControl::Kind::position;
  }

  bool is_oscillating() const { return asked_.engine == motion::MotionEngine::oscillating; }

  // The engine is of first order: half as many points and steps have twice the error, so the difference is the error.
  void add_step_errors(Member& one, const MotorDesign& design, MotionTask task,
                       double last_on) const {
    task.accuracy /= 2;
    task.go_on = [this, told = kFineShare](double time) mutable {
      return goes_on(time, kFineShare, told);
    };
    const motion::Motion coarse = moved(design, task, nullptr);
    if (one.motion.status != "ok" || coarse.status != "ok") return;  // nothing to compare
    one.step_error = step_error(one.motion.samples, coarse.samples);
    const auto measures = measured(asked_.measure, coarse, {last_on, reference_at(last_on)});
    for (std::size_t i = 0; i < measures.size(); ++i)
      one.measures[i].step_error = std::abs(one.measures[i].value - measures[i].value);
  }

  MotionStudy asked_;
  std::vector<double> times_;
  std::vector<const MotionColumn*> columns_;
};

}  // namespace

std::unique_ptr<StudyKindRun> MotionStudy::run(const StudyFile& file) const {
  return std::make_unique<MotionRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
