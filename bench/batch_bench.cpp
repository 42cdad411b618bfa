// SPDX-License-Identifier: Apache-2.0
// Seconds of processor time that a batch of designs takes, for comparison with the Python module (python_bench.py):
//
//   twum_batch_bench DESIGNS JOBS
//
// prints the time, and the sum of every metric so that both sides can be seen to do the same.
#include <twum/core/batch.hpp>
#include <twum/core/metrics.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const unsigned jobs = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const std::vector<twum::MetricRequest> requests{
      {twum::Metric::stall_torque},
      {twum::Metric::no_load_speed},
      {twum::Metric::torque_at, twum::Argument::speed, 10.5}};

  const std::clock_t begin = std::clock();
  std::vector<twum::MotorDesign> designs;
  designs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double step = static_cast<double>(i);
    const std::array<twum::ParameterValue, 2> values{
        {{twum::Parameter::preload, 60 + 240 * std::fmod(0.618 * step, 1)},
         {twum::Parameter::amplitude, 0.8e-6 + 1.4e-6 * std::fmod(0.414 * step, 1)}}};
    designs.push_back(with(twum::MotorDesign{}, values));
  }
  const auto rows = evaluate_designs(designs, requests, jobs);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;

  std::printf("%.6f", seconds);
  for (std::size_t k = 0; k < requests.size(); ++k) {
    double sum = 0;
    for (const auto& row : rows) sum += row[k].value;
    std::printf(" %.17g", sum);
  }
  std::printf("\n");
}
