// SPDX-License-Identifier: Apache-2.0
#include <twum/base/ordered.hpp>

namespace twum::inline v0_1 {

unsigned job_count(unsigned requested) {
  return requested > 0 ? requested : std::max(std::thread::hardware_concurrency(), 1U);
}

}  // namespace twum::inline v0_1
