// SPDX-License-Identifier: Apache-2.0
#include "stretches.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::motion {
namespace {

void require_values(const Profile& profile, Parameter parameter) {
  for (const auto& [time, value] : profile.rows()) require_admissible(parameter, value);
}

void require_intervals(const std::vector<Interval>& intervals, const char* name) {
  double last = -1;
  for (const auto& [begin, end] : intervals) {
    if (!(begin >= 0 && end > begin && begin > last))
      throw InputError(std::string(name) +
                       " must be intervals of rising times from 0 s on, apart from each other");
    last = end;
  }
}

void require_task(const MotionTask& task, bool driven) {
  if (!(task.duration > 0 && std::isfinite(task.duration)))
    throw InputError("the duration of a motion must be more than 0 s and finite");
  if (!(task.tolerance >= 1e-12 && task.tolerance <= 1e-3))
    throw InputError("the tolerance of a motion must be between 1e-12 and 1e-3");
  require_values(task.frequency, Parameter::frequency);
  if (driven) require_values(task.voltage, Parameter::voltage);
  if (!driven) require_values(task.amplitude, Parameter::amplitude);
  if (!driven && !task.switched_off.empty())
    throw InputError("a motor with a given amplitude has no drive that can be switched off");
  require_intervals(task.switched_off, "switched_off");
  require_intervals(task.reversed, "reversed");
  if (!std::ranges::is_sorted(task.output_times)) throw InputError("output times must rise");
}

void add_times(std::vector<double>& times, const Profile& profile) {
  for (const auto& [time, value] : profile.rows()) times.push_back(time);
}

void add_times(std::vector<double>& times, const std::vector<Interval>& intervals) {
  for (const auto& [begin, end] : intervals) times.push_back(begin), times.push_back(end);
}

// The ends of all stretches, each once.
std::vector<double> kinks(const MotionTask& task) {
  std::vector<double> times{0, task.duration};
  for (const Profile* profile :
       {&task.voltage, &task.amplitude, &task.frequency, &task.load_torque, &task.phase_difference})
    add_times(times, *profile);
  add_times(times, task.switched_off), add_times(times, task.reversed);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::erase_if(times, [&](double time) { return time < 0 || time > task.duration; });
  return times;
}

// Adds times but for those that are there.
void add_others(std::vector<double>& times, const std::vector<double>& more) {
  const double same = kSameTime * times.back();
  std::vector<double> others;
  for (const double time : more) {
    const auto next = std::ranges::lower_bound(times, time - same);
    if (next == times.end() || *next > time + same) others.push_back(time);
  }
  times.insert(times.end(), others.begin(), others.end());
  std::ranges::sort(times);
}

Ramp ramp(const Profile& profile, double begin, double end) {
  const double value = profile.after(begin);
  return {begin, value, (profile.before(end) - value) / (end - begin)};
}

bool covers(const std::vector<Interval>& intervals, double begin) {
  return std::ranges::any_of(
      intervals, [=](const Interval& one) { return one.begin <= begin && begin < one.end; });
}

}  // namespace

Stretch before_the_first(const MotionTask& task) {
  const auto value = [](const Profile& p) { return Ramp{0, p.before(0), 0}; };
  return {0,
          0,
          value(task.voltage),
          value(task.amplitude),
          value(task.frequency),
          value(task.load_torque),
          value(task.phase_difference),
          false,
          1};
}

std::vector<Stretch> stretches_of(const MotionTask& task, bool driven,
                                  const std::vector<double>& more) {
  require_task(task, driven);
  std::vector<double> times = kinks(task);
  add_others(times, more);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double a = times[i], b = times[i + 1];
    stretches.push_back({a, b, ramp(task.voltage, a, b), ramp(task.amplitude, a, b),
                         ramp(task.frequency, a, b), ramp(task.load_torque, a, b),
                         ramp(task.phase_difference, a, b), covers(task.switched_off, a),
                         covers(task.reversed, a) ? -1.0 : 1.0});
  }
  return stretches;
}

}  // namespace twum::inline v0_1::motion
