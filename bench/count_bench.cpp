// SPDX-License-Identifier: Apache-2.0
// Calls of elementary functions for one operating point, counted: the linker puts these wrappers between
// the core and the mathematical library.
//
// The prediction beside them is what the closed forms of one lap need when every zone's end is known
// beforehand. With Z zones, Z_s of them slip zones:
//
//     sines and cosines   Z - 1 + Z_s + 1   phase at each inner end, the layer's own vibration at the end
//                                           of each slip zone and of the free flight
//     exponentials        Z_s + 1           its decay, likewise
//
// A layer without inertia does not vibrate, an elastic one does not decay either, and a free flight that
// leaves nothing is skipped. What is counted above that is the search for the ends, and further laps.
#include "layers.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace {

struct Counts {
  long sincos{0}, exp{0}, inverse{0};
};
Counts counts;

}  // namespace

extern "C" {
void __real_sincos(double, double*, double*);
double __real_sin(double);
double __real_cos(double);
double __real_exp(double);
double __real_acos(double);
double __real_atan2(double, double);

void __wrap_sincos(double x, double* s, double* c) {
  ++counts.sincos;
  __real_sincos(x, s, c);
}
double __wrap_sin(double x) {
  ++counts.sincos;
  return __real_sin(x);
}
double __wrap_cos(double x) {
  ++counts.sincos;
  return __real_cos(x);
}
double __wrap_exp(double x) {
  ++counts.exp;
  return __real_exp(x);
}
double __wrap_acos(double x) {
  ++counts.inverse;
  return __real_acos(x);
}
double __wrap_atan2(double y, double x) {
  ++counts.inverse;
  return __real_atan2(y, x);
}
}

namespace {

using namespace twum;
using bench::Layer;

void print_point(const Layer& layer, const Motor& motor, double share, double speed) {
  counts = {};
  const OperatingPoint point = motor.operating_point(speed);
  const Counts measured = counts;
  const std::vector<Zone> zones = motor.zones(speed);
  long slips = 0;
  for (const Zone& zone : zones) slips += zone.state != ZoneState::stick;
  const long all = static_cast<long>(zones.size()), own = slips + 1;
  std::printf("%-20s %6.2f %6ld %9ld %9ld %9ld %9ld %11ld%s\n", layer.name, share, all,
              all - 1 + (layer.vibrates ? own : 0), measured.sincos, layer.decays ? own : 0,
              measured.exp, measured.inverse, point.status == PointStatus::ok ? "" : "  no answer");
}

}  // namespace

int main() {
  MotorDesign light = test::ring_motor();
  light.layer.loss_factor = 0.005;
  std::vector<Layer> layers = bench::layers();
  layers.push_back({"loss factor 0.005", light, true, true});
  std::printf("%-20s %6s %6s %9s %9s %9s %9s %11s\n", "", "share of", "", "sine and", "", "exp,",
              "", "acos, atan,");
  std::printf("%-20s %6s %6s %9s %9s %9s %9s %11s\n", "layer", "no-load", "zones", "cosine",
              "counted", "one lap", "counted", "counted");
  for (const Layer& layer : layers) {
    const Motor motor(layer.design);
    const double free = evaluate(motor, {Metric::no_load_speed}).value;
    for (const double share : {0.0, 0.3, 0.85, 0.98, 1.4})
      print_point(layer, motor, share, share * free);
  }
  return 0;
}
