// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <filesystem>
#include <fstream>
#include <string>

// Whole sampling studies of the 60 mm ring motor with one slice, evaluations stored in memory, on all processors. Real time
// counts; CPU time of the whole process stands beside it.
namespace {

using namespace twum::studies;

StudyFile study_of(const std::string& entries) {
  namespace fs = std::filesystem;
  const fs::path path = fs::temp_directory_path() / "twum-sampling-bench.yaml";
  std::ofstream(path) << "twum: 1\nmotor: " TWUM_SOURCE_DIR
                         "/tests/data/motors/ring-60.yaml\nstudy:\n"
                      << entries;
  StudyFile file = read_study_file(path.string());
  fs::remove(path);
  return file;
}

void run(benchmark::State& state, const std::string& entries) {
  const StudyFile file = study_of(entries);
  std::uint64_t evaluations = 0;
  for (auto _ : state) evaluations = run_study(file).evaluations;
  state.counters["designs"] = static_cast<double>(evaluations);
}

// 4096 base samples of 8 variables: 40,960 designs.
void sobol_of_eight(benchmark::State& state, const std::string& metrics) {
  run(state, "  kind: sensitivity\n  method: sobol\n  samples: 4096\n  metrics: [" + metrics +
                 "]\n  variables:\n"
                 "    amplitude: {min: 1.4 um, max: 2.0 um}\n"
                 "    preload: {min: 120 N, max: 200 N}\n"
                 "    kinetic_friction: {min: 0.15, max: 0.25}\n"
                 "    thickness: {min: 0.2 mm, max: 0.5 mm}\n"
                 "    youngs_modulus: {min: 2 GPa, max: 6 GPa}\n"
                 "    poisson_ratio: {min: 0.3, max: 0.45}\n"
                 "    density: {min: 1200 kg/m^3, max: 2400 kg/m^3}\n"
                 "    loss_factor: {min: 0.02, max: 0.1}\n");
}

void tolerances(benchmark::State& state) {
  run(state,
      "  kind: uncertainty\n  samples: 40000\n  metrics: [stall_torque, no_load_speed]\n"
      "  limits: [stall_torque >= 0.75 N.m]\n  variables:\n"
      "    preload: {distribution: normal, mean: 160 N, sd: 8 N}\n"
      "    kinetic_friction: {distribution: lognormal, mean: 0.2, sd: 0.015}\n");
}

}  // namespace

BENCHMARK_CAPTURE(sobol_of_eight, torque_and_speed, "stall_torque, no_load_speed")
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(sobol_of_eight, peak_power, "peak_power")
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(tolerances)->Unit(benchmark::kSecond)->MeasureProcessCPUTime()->UseRealTime();

BENCHMARK_MAIN();
