// SPDX-License-Identifier: Apache-2.0
// Calibrations with the table of a logger: how the time grows with the rows, and a fit with all residuals beside one with
// condensed ones (L1.2).
#include <benchmark/benchmark.h>
#include <twum/core/motor.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace twum;
using namespace twum::studies;
namespace fs = std::filesystem;

// Speeds as a logger writes them, with two places behind the point, and torques with errors of 30 mN m.
void write_log(const fs::path& path, int rows) {
  optim::Random random(3, 0, 0);
  std::ofstream csv(path);
  csv << "speed [rpm],torque [N.m]\n";
  for (int i = 0; i < rows; ++i) {
    const double rpm = 85 + std::round(5300.0 * i / (rows - 1)) / 100;
    const double torque = 0.77 * (1 - std::pow(rpm / 140, 8));
    csv << rpm << ',' << torque + 0.06 * (random.uniform() - 0.5) << '\n';
  }
}

StudyFile study_of(const fs::path& folder, int rows) {
  write_log(folder / "log.csv", rows);
  std::ofstream(folder / "fit.yaml")
      << "twum: 1\nmotor: " TWUM_SOURCE_DIR
         "/tests/data/motors/ring-60.yaml\nset: {radial_slices: 1}\nstudy:\n"
         "  kind: calibrate\n  data: log.csv\n  variables:\n"
         "    kinetic_friction: {min: 0.05, max: 0.5}\n"
         "    youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}\n";
  return read_study_file((folder / "fit.yaml").string());
}

void table_of_a_logger(benchmark::State& state) {
  const fs::path folder = fs::temp_directory_path() / "twum-fit-bench";
  fs::create_directories(folder);
  const StudyFile file = study_of(folder, static_cast<int>(state.range(0)));
  std::uint64_t evaluations = 0;
  for (auto _ : state) evaluations = run_study(file).evaluations;
  fs::remove_all(folder);
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

// A decay over time with errors, which costs little, so that the fit itself is what counts.
optim::Residuals decay(std::span<const double> b, std::size_t count) {
  optim::Residuals r;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 3.0 * static_cast<double>(i) / static_cast<double>(count);
    const double e = std::exp(-b[1] * x);
    r.values.push_back(b[0] * e - 2.0 * std::exp(-0.7 * x) - 0.05 * std::sin(1e4 * x));
    r.jacobian.insert(r.jacobian.end(), {e, -b[0] * x * e});
  }
  return r;
}

void fit(benchmark::State& state, bool few) {
  constexpr std::size_t kCount = 20000;
  for (auto _ : state)
    benchmark::DoNotOptimize(optim::least_squares(
        {{"size", 0.1, 10.0, 1.0}, {"rate", 0.01, 10.0, 1.0, optim::Scale::log}},
        [&](auto b) { return few ? optim::condensed(decay(b, kCount)) : decay(b, kCount); }));
}

}  // namespace

BENCHMARK(table_of_a_logger)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, all_residuals, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, condensed_residuals, true)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
