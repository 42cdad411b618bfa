// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/jobs/ordered.hpp>

namespace twum::studies {

unsigned job_count(unsigned requested) {
  return requested > 0 ? requested : std::max(std::thread::hardware_concurrency(), 1U);
}

}  // namespace twum::studies
