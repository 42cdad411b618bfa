// SPDX-License-Identifier: Apache-2.0
// What a second, third, ... thread gains: a table of designs read, evaluated and written, on 1 thread and on all, and
// as many tables at once on a thread each, which is what the machine has to give. They take turns, so that
// a machine whose speed changes changes all of them.
//
//   twum_scaling_bench [DESIGNS [TURNS]]
#include "timing.hpp"

#include <twum/core/motor_design.hpp>
#include <twum/motors/design_table.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace twum;
using namespace twum::studies;
using bench::seconds;

std::string table_of(std::size_t designs) {
  std::string text = "preload [N],amplitude [um],thickness [mm]\n";
  char row[80];
  for (std::size_t i = 0; i < designs; ++i) {
    const auto share = [i](double step) { return std::fmod(step * static_cast<double>(i + 1), 1); };
    std::snprintf(row, sizeof row, "%.6g,%.6g,%.6g\n", 100 + 140 * share(0.618),
                  0.8 + 1.2 * share(0.414), 0.2 + 0.3 * share(0.732));
    text += row;
  }
  return text;
}

void evaluate_text(const std::string& text, unsigned jobs, std::string& result) {
  std::size_t at = 0;
  CsvReader reader("table", [&](char* to, std::size_t size) {
    const std::size_t taken = text.copy(to, size, at);
    at += taken;
    return taken;
  });
  CsvChunk header;
  reader.read(header, 1);
  const DesignTable table(reader, header, MotorDesign{},
                          parse_metric_list("stall_torque, no_load_speed, peak_power"));
  result.clear();
  evaluate_table(
      reader, table, jobs, [&](std::string_view piece) { result += piece; }, [] { return true; },
      [](const DesignCounts&) {});
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t designs = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20000;
  const int turns = argc > 2 ? std::atoi(argv[2]) : 9;
  if (argc > 3 || designs < 1 || turns < 1) {
    std::fprintf(stderr, "twum_scaling_bench [DESIGNS [TURNS]]: whole numbers from 1\n");
    return 2;
  }
  const unsigned cores = std::max(std::thread::hardware_concurrency(), 1U);
  const std::string text = table_of(designs);

  std::string alone, shared;
  std::vector<std::string> each(cores);
  std::vector<double> rates, gains, limits;
  for (int turn = 0; turn < turns; ++turn) {
    const auto on_one = [&] { return seconds([&] { evaluate_text(text, 1, alone); }); };
    const double before = on_one();
    const double on_all = seconds([&] { evaluate_text(text, cores, shared); });
    const double at_once = seconds([&] {
      std::vector<std::jthread> threads;
      for (std::string& result : each)
        threads.emplace_back([&text, &result] { evaluate_text(text, 1, result); });
    });
    const double one = 0.5 * (before + on_one());
    rates.push_back(static_cast<double>(designs) / one);
    gains.push_back(one / on_all);
    limits.push_back(cores * one / at_once);
  }
  std::printf("designs a second on one thread          %10.0f\n", median(rates));
  std::printf("times as many on %2u threads             %10.2f\n", cores, median(gains));
  std::printf("the same of %2u tables at once, one each %10.2f\n", cores, median(limits));
  std::printf("results %s\n", alone == shared ? "equal to the byte" : "DIFFER");
  return alone == shared ? 0 : 1;
}
