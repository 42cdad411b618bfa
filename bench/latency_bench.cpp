// SPDX-License-Identifier: Apache-2.0
// Latency of one operating point, call by call: median, 99 of 100, and allocations from the heap. The ratio beside each
// median is to that of one slice.
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/workspace.hpp>
#include <twum/motors/motor_file.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace {
long taken = 0;
}

void* operator new(std::size_t size) {
  ++taken;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace twum;
using Clock = std::chrono::steady_clock;

constexpr int kCalls = 20000;

struct Latency {
  double median, slow;  // [us]
  double allocations;   // mean of a call
};

// Points between the first speed and 1.2 of the no-load speed, none twice.
template <typename Point>
Latency latency_of(const Motor& motor, Point point) {
  const double first = motor.first_speed();
  const double last = 1.2 * evaluate(motor, {Metric::no_load_speed}).value;
  std::vector<double> times;
  times.reserve(kCalls);
  double sum = point(first).speed;  // warm
  const long before = taken;
  for (int i = 0; i < kCalls; ++i) {
    const double share = static_cast<double>((i * 7919L) % kCalls) / kCalls;
    const auto begin = Clock::now();
    sum += point(first + share * (last - first)).speed;
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  const double allocations = static_cast<double>(taken - before) / kCalls;
  std::ranges::sort(times);
  if (!(sum > 0)) std::abort();
  return {times[kCalls / 2], times[kCalls / 100 * 99], allocations};
}

void print(const char* name, const char* memory, const Latency& found, double one) {
  std::printf("| %s | %s | %.3g us | %.3g us | %.3g | %.3g |\n", name, memory, found.median,
              found.slow, found.allocations, found.median / one);
}

}  // namespace

int main() {
  const auto design = [](const char* name) {
    return motors::read_motor_file(std::string(TWUM_SOURCE_DIR) + "/examples/motors/" + name)
        .design;
  };
  const MotorDesign ring = design("ring-60.yaml"), driven = design("drive-60.yaml");
  const auto sliced = [](const MotorDesign& motor, int slices) {
    return Motor(with(motor, Parameter::radial_slices, slices));
  };
  const std::vector<std::pair<const char*, Motor>> motors{
      {"ring-60, one slice", sliced(ring, 1)},
      {"ring-60, 8 slices", sliced(ring, 8)},
      {"ring-60, auto", sliced(ring, kAutoSlices)},
      {"drive-60, one slice", sliced(driven, 1)},
      {"drive-60, auto", sliced(driven, kAutoSlices)}};
  double one = 0;
  std::printf("| motor | memory | median | 99 of 100 | allocations | median, one slice = 1 |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [name, motor] : motors) {
    const auto on_heap = [&](double speed) { return motor.operating_point(speed); };
    const Latency found = latency_of(motor, on_heap);
    if (one == 0) one = found.median;
    print(name, "heap", found, one);
    Workspace workspace;
    const auto in_workspace = [&](double speed) { return motor.operating_point(speed, workspace); };
    print(name, "workspace", latency_of(motor, in_workspace), one);
  }
}
