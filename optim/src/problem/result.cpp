// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/result.hpp>

namespace twum::inline v0_1::optim {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::optimal: return "optimal";
    case Outcome::feasible: return "feasible";
    case Outcome::infeasible: return "infeasible";
    case Outcome::budget: return "budget";
    case Outcome::failed: return "failed";
  }
  return "unknown";
}

std::size_t Counters::failed() const {
  std::size_t sum = 0;
  for (const auto& [reason, count] : failures) sum += count;
  return sum;
}

void Counters::add(const Counters& other) {
  evaluations += other.evaluations;
  gradients += other.gradients;
  reused += other.reused;
  for (const auto& [reason, count] : other.failures) failures[reason] += count;
}

void Counters::subtract(const Counters& other) {
  evaluations -= other.evaluations;
  gradients -= other.gradients;
  reused -= other.reused;
  for (const auto& [reason, count] : other.failures) failures[reason] -= count;
}

const char* to_string(StopReason value) noexcept {
  switch (value) {
    case StopReason::finished: return "finished";
    case StopReason::evaluations: return "evaluations";
    case StopReason::seconds: return "seconds";
    case StopReason::requested: return "requested";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
