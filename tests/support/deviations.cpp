// SPDX-License-Identifier: Apache-2.0
#include "support/deviations.hpp"

#include <cstdio>
#include <cstdlib>

namespace twum::test {

Deviation::~Deviation() {
  const char* path = std::getenv("TWUM_DEVIATIONS");
  if (path == nullptr || count_ == 0) return;
  if (std::FILE* file = std::fopen(path, "a")) {
    std::fprintf(file, "%s,%.2e,%.2e,%ld\n", name_.c_str(), largest_, allowed_, count_);
    std::fclose(file);
  }
}

double Deviation::add(double found, double expected, double scale) {
  const double deviation = found == expected ? 0.0 : std::abs(found - expected) / scale;
  ++count_;
  if (std::isnan(deviation) || deviation > largest_) largest_ = deviation;
  return deviation;
}

}  // namespace twum::test
