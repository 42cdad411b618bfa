// SPDX-License-Identifier: Apache-2.0
#include "fuzz/targets.hpp"

#include "fuzz/readers.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace twum::fuzz {

std::span<const Target> targets() {
  static constexpr std::array<Target, 6> kTargets{{{"motor", feed_motor},
                                                   {"study", feed_study},
                                                   {"table", feed_table},
                                                   {"points", feed_points},
                                                   {"units", feed_units},
                                                   {"metrics", feed_metrics}}};
  return kTargets;
}

const Target& target(std::string_view name) {
  const auto all = targets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Target& one) { return one.name == name; });
  if (found == all.end()) throw std::out_of_range("no fuzz target " + std::string(name));
  return *found;
}

}  // namespace twum::fuzz
