// SPDX-License-Identifier: Apache-2.0
// Searches that compute only what is asked: one over the stator's geometry that asks for frequencies alone, a robust one of a motor
// under a voltage, one with mu_0 > mu; and a torque at one speed beside the same from the whole curve.
#include <benchmark/benchmark.h>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/source.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <string>
#include <vector>

namespace {

using namespace twum;
using namespace twum::studies;

StudyFile study_of(const std::string& motor, const std::string& study,
                   const std::string& set = "radial_slices: 1") {
  return read_study({"bench", "twum: 1\nmotor: " TWUM_SOURCE_DIR "/examples/motors/" + motor +
                                  "\nset: {" + set + "}\nstudy: " + study + "\n"},
                    ".");
}

void search(benchmark::State& state, const std::string& motor, const std::string& study,
            const std::string& set) {
  const StudyFile file = study_of(motor, study, set);
  std::uint64_t evaluations = 0;
  for (auto _ : state) evaluations = run_study(file).evaluations;
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

const std::string kFrequencies =
    "{kind: optimize, variables: {web_thickness: {min: 0.4 mm, max: 2 mm},"
    " substrate_thickness: {min: 1.5 mm, max: 3.5 mm}}, minimize: stator_mass,"
    " constraints: [resonance_frequency == 40 kHz +- 50 Hz, mode_separation >= 1 kHz]}";
const std::string kTolerances =
    "{kind: size, variables: {voltage: {min: 20 V, max: 120 V},"
    " frequency_ratio: {min: 1.01, max: 1.2}, preload: {min: 10 N, max: 60 N},"
    " thickness: {min: 0.1 mm, max: 0.4 mm}}, duty: [{torque: 50 mN.m, speed: 100 rpm}],"
    " tolerances: {preload: {range: 10 %}, kinetic_friction: {range: 15 %},"
    " thickness: {range: 5 %}}, limits: [hold_voltage <= voltage, layer_aspect <= 0.1,"
    " max_pressure <= 4 MPa, probability(torque_at(100 rpm) >= 50 mN.m) >= 99 %],"
    " prefer: electrical_power_at(100 rpm)}";
const std::string kStaticFriction =
    "{kind: optimize, variables: {preload: {min: 60 N, max: 280 N},"
    " thickness: {min: 0.15 mm, max: 1 mm}, voltage: {min: 40 V, max: 150 V}},"
    " minimize: electrical_power_at(0.4 N.m), constraints: [torque_at(60 rpm) >= 0.5 N.m]}";

// A motor whose running wave is not met at rest. With a number of the whole curve beside it, the curve is followed.
void torque_at_a_speed(benchmark::State& state, bool of_the_curve) {
  const MotorDesign design = with(study_of("plate-30.yaml", "{kind: curve}").motor.design,
                                  std::vector<ParameterValue>{{Parameter::voltage, 41},
                                                              {Parameter::frequency_ratio, 1.062},
                                                              {Parameter::preload, 26},
                                                              {Parameter::thickness, 1e-4}});
  std::vector<MetricRequest> requests{{Metric::torque_at, Argument::speed, 10.5}};
  if (of_the_curve) requests.push_back({Metric::no_load_speed});
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(Motor(design), requests));
}

}  // namespace

BENCHMARK_CAPTURE(torque_at_a_speed, alone, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(torque_at_a_speed, of_the_curve, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(search, frequencies_of_a_stator, "plate-60.yaml", kFrequencies,
                  "radial_slices: 1")
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(search, tolerances_under_a_voltage, "plate-30.yaml", kTolerances,
                  "radial_slices: 1")
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(search, static_friction, "drive-60.yaml", kStaticFriction,
                  "radial_slices: 1, static_friction: 0.32")
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

BENCHMARK_MAIN();
