// SPDX-License-Identifier: Apache-2.0
// Random designs and speeds over the whole box of theory section 10: does every one get an answer that
// keeps the laws, or a reason? Prints counts, and the slowest and the strangest points as entries for
// tests/core/identity_cases.yaml. Exits with 1 if a law is broken.
//
//   twum_box_survey [COUNT [SEED [METRICS_EVERY]]]      1000000 2 100 by default
//   twum_box_survey ranges [COUNT [SEED]]               20000 1: the ranges of `twum parameters` in place of the box
#include "support/box_survey.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace {

using namespace twum::test;

std::int64_t whole_number(const char* text) {
  char* end = nullptr;
  const long long value = std::strtoll(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < 0)
    throw std::invalid_argument(std::string("not a whole number from 0: ") + text);
  return value;
}

void print_counts(const char* what, const std::map<std::string, std::int64_t>& counts) {
  std::printf("%s:", what);
  for (const auto& [name, count] : counts)
    std::printf(" %s %lld", name.c_str(), static_cast<long long>(count));
  std::printf("%s\n", counts.empty() ? " none" : "");
}

void print_points(const char* what, double unit, const std::vector<NotablePoint>& points) {
  std::printf("%s\n", what);
  for (const NotablePoint& point : points) {
    std::printf("# %.3g, point %lld\n%s\n", point.value * unit, static_cast<long long>(point.index),
                identity_case("box", point.box).c_str());
  }
}

int run(int count, char** arguments) {
  const bool ranges = count > 1 && arguments[1] == std::string("ranges");
  if (ranges) --count, ++arguments;
  BoxSurveyOptions options{ranges ? 1U : 2U, ranges ? 20000 : 1000000, 100};
  if (count > 1) options.count = whole_number(arguments[1]);
  if (count > 2) options.seed = static_cast<std::uint64_t>(whole_number(arguments[2]));
  if (count > 3) options.metrics_every = whole_number(arguments[3]);
  const BoxSurvey found = ranges ? survey_ranges(options.seed, options.count) : survey_box(options);
  std::printf("%lld designs, seed %llu\n", static_cast<long long>(found.designs),
              static_cast<unsigned long long>(options.seed));
  print_counts("points", found.statuses);
  print_counts("metrics", found.metrics);
  print_counts("laws broken", found.broken);
  std::printf("metrics that break a law: %lld\n", static_cast<long long>(found.metrics_broken));
  std::printf("largest imbalance, of the scale of powers: %.2g\n", found.identity);
  for (const std::string& example : found.examples) std::printf("broken: %s\n", example.c_str());
  print_points("slowest points [ms]", 1e3, found.slowest);
  print_points("slowest in all metrics without argument [ms]", 1e3, found.slowest_metrics);
  print_points("largest imbalances", 1, found.strangest);
  return found.broken.empty() && found.metrics_broken == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "twum_box_survey: %s\n", error.what());
    return 2;
  }
}
