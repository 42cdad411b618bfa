// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>

#include <atomic>
#include <cstdlib>
#include <new>

// Counts what the program takes from the heap. Returning memory is never inlined: GCC 12 would see
// free() meet operator new in one function and take the pair for a mistake.
namespace {
std::atomic<long> taken{0};
}

void* operator new(std::size_t size) {
  taken.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return ::operator new(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  taken.fetch_add(1, std::memory_order_relaxed);
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace {

using namespace twum;
using namespace twum::test;

long taken_by_points(const Motor& motor) {
  double sum = 0;
  const long before = taken.load();
  for (int i = -20; i <= 150; ++i)
    sum += motor.operating_point(0.01 * i * motor.crest_speed()).speed;
  const long after = taken.load();
  CHECK(std::isfinite(sum));
  return after - before;
}

}  // namespace

TEST_CASE("the counter counts", "[core][point][work]") {
  const long before = taken.load();
  const auto box = std::make_unique<double>(1.0);
  CHECK(taken.load() > before);
  CHECK(*box == 1.0);
}

TEST_CASE("an operating point takes nothing from the heap", "[core][point][work]") {
  MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  const double load = GENERATE(0.0, 0.3, 0.95, 2.0);  // 0: the ring's own
  const double threshold = GENERATE(1.0, 1.6);
  if (load > 0) design.preload = load * full_contact_load(design);
  design.friction.threshold = threshold * design.friction.kinetic;
  CAPTURE(load, threshold);
  CHECK(taken_by_points(Motor(design)) == 0);
}

TEST_CASE("no design of the box makes an operating point take from the heap",
          "[core][point][work]") {
  Uniform random(11);
  long sum = 0;
  for (int i = 0; i < 500; ++i) {
    const BoxPoint box = random_box_point(random);
    const Motor motor(box.design);
    const long before = taken.load();
    motor.operating_point(box.speed);
    sum += taken.load() - before;
  }
  CHECK(sum == 0);
}

namespace {

// The last one is drive-60 as its file.
MotorDesign demanding_motor(int which, int slices) {
  MotorDesign design = which == 4   ? driven_motor_with_layer()
                       : which == 0 ? elastic(ring_motor())
                       : which == 1 ? damped(ring_motor())
                                    : ring_motor();  // with inertia
  if (which == 3) design.friction.threshold = 1.3 * design.friction.kinetic;
  if (which == 4) design.stator.quality_factor = 153;
  design.stator.radial_slices = slices;
  return design;
}

// All that follow from the torque-speed curve of the cold, new motor.
std::vector<MetricRequest> metrics_of_curve(double speed, double torque) {
  std::vector<MetricRequest> asked = every_metric(speed, torque);
  std::erase_if(asked, [](const MetricRequest& request) {
    const MetricInfo& row = info(request.metric);
    return row.needs_thermal || row.needs_operation || row.needs_wear || row.needs_motion ||
           row.needs_geometry || request.metric == Metric::voltage_reserve_at;
  });
  return asked;
}

}  // namespace

TEST_CASE("in a warm workspace an operating point takes nothing from the heap",
          "[core][point][work]") {
  const MotorDesign design =
      demanding_motor(GENERATE(range(0, 5)), GENERATE(1, 8, int{kAutoSlices}));
  CAPTURE(design.stator.radial_slices, design.stator.voltage.has_value());
  const Motor motor(design);
  Workspace workspace;
  motor.operating_point(motor.first_speed(), workspace);
  double sum = 0;
  const long before = taken.load();
  for (int i = -20; i <= 150; ++i)
    sum += motor.operating_point(0.01 * i * motor.crest_speed(), workspace).speed;
  CHECK(taken.load() == before);
  CHECK(std::isfinite(sum));
}

TEST_CASE("in a warm workspace all metrics of the curve take nothing from the heap",
          "[core][metrics][work]") {
  const MotorDesign design =
      demanding_motor(GENERATE(range(0, 5)), GENERATE(1, 8, int{kAutoSlices}));
  CAPTURE(design.stator.radial_slices, design.stator.voltage.has_value());
  const Motor motor(design);
  const std::vector<MetricRequest> asked = metrics_of_curve(0.4 * motor.crest_speed(), 0.2);
  std::vector<MetricValue> values(asked.size());
  Workspace workspace;
  evaluate(motor, asked, values, workspace);
  const long before = taken.load();
  evaluate(motor, asked, values, workspace);
  CHECK(taken.load() == before);
}

TEST_CASE("in a warm workspace held points take nothing from the heap", "[core][metrics][work]") {
  const MotorDesign design =
      demanding_motor(GENERATE(range(0, 5)), GENERATE(1, 8, int{kAutoSlices}));
  const Motor motor(design);
  const double speed = 0.4 * motor.crest_speed();
  int answered = 0;
  for (const MetricInfo& row : metric_table()) {
    const MetricRequest asked{row.metric, Argument::both, speed, 0.2};
    if (row.needs_thermal || row.needs_operation || row.needs_wear || row.needs_motion) continue;
    CAPTURE(row.name, design.stator.radial_slices, design.stator.voltage.has_value());
    MetricValue value;
    Workspace workspace;
    evaluate(motor, {&asked, 1}, {&value, 1}, workspace);
    const long before = taken.load();
    evaluate(motor, {&asked, 1}, {&value, 1}, workspace);
    CHECK(taken.load() == before);
    answered += value.status == MetricStatus::ok;
  }
  CHECK(answered > 0);
}
