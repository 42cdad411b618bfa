// SPDX-License-Identifier: Apache-2.0
#include "problem/session.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>

namespace twum::inline v0_1::optim {
namespace {

bool same_bits(std::span<const double> a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

Evaluation failure(const std::string& reason) {
  Evaluation failed;
  failed.failure = reason.empty() ? "unnamed" : reason;
  return failed;
}

// A wrong size is a bug of the evaluator and must not count as a failed design.
void check_sizes(const Evaluation& e, const Problem& problem, bool gradient) {
  const std::size_t rows = problem.responses();
  const std::size_t entries = rows * problem.variables.size();
  if (e.values.size() != rows)
    throw InputError("the evaluator gave " + std::to_string(e.values.size()) + " values for " +
                     std::to_string(rows) + " responses");
  if ((gradient || !e.jacobian.empty()) && e.jacobian.size() != entries)
    throw InputError(
        "the evaluator gave " + std::to_string(e.jacobian.size()) + " derivatives where " +
        std::to_string(entries) + " were expected" +
        (e.jacobian.empty() ? "; if it has none, set Problem::derivatives to false" : ""));
}

// A derivative that is not finite does not fail the design. It is marked as undefined, which matters only if it is
// needed.
void mark_undefined(Evaluation& e, const Problem& problem, std::span<const double> design) {
  const std::size_t variables = problem.variables.size();
  for (KinkedEntry& kink : e.kinks) {
    if (kink.slope != Slope::one_sided) continue;
    // On a bound there is only one side.
    const Variable& v = problem.variables[kink.variable];
    const bool has_left = design[kink.variable] > v.lower,
               has_right = design[kink.variable] < v.upper;
    if ((has_left && !std::isfinite(kink.left)) || (has_right && !std::isfinite(kink.right)))
      kink.slope = Slope::undefined;
  }
  for (std::size_t k = 0; k < e.jacobian.size(); ++k)
    if (!std::isfinite(e.jacobian[k]))
      e.kinks.push_back({k / variables, k % variables, Slope::undefined, 0.0, 0.0});
}

}  // namespace

Observer serialized(const Observer& observer) {
  if (!observer) return {};
  auto lock = std::make_shared<std::mutex>();
  return [observer, lock](const Observation& o) {
    const std::lock_guard<std::mutex> guard(*lock);
    observer(o);
  };
}

double Deadline::elapsed() const {
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

Session::Session(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                 std::uint64_t stage, std::size_t quota)
    : problem_(problem), options_(options), deadline_(deadline), stage_(stage), quota_(quota) {}

const Session::Memory* Session::find(std::span<const double> design, bool gradient) const {
  for (const Memory& m : memory_)
    if (same_bits(design, m.design) &&
        (!gradient || !m.evaluation.ok() || !m.evaluation.jacobian.empty()))
      return &m;
  return nullptr;
}

void Session::heed() const {
  if (options_.stop.stop_requested()) throw Stop{StopReason::requested};
  if (deadline_.passed()) throw Stop{StopReason::seconds};
}

Evaluation Session::call(std::span<const double> design, bool gradient) {
  try {
    Evaluation e = problem_.evaluate(design, gradient);
    if (!e.ok()) return failure(e.failure);
    check_sizes(e, problem_, gradient);
    if (!std::all_of(e.values.begin(), e.values.end(), [](double v) { return std::isfinite(v); }))
      return failure("not-finite");
    mark_undefined(e, problem_, design);
    return e;
  } catch (const EvaluationError& error) {
    return failure(error.reason());
  }
}

const Evaluation& Session::at(std::span<const double> design, bool gradient) {
  if (const Memory* known = find(design, gradient)) {
    ++counters_.reused;
    return known->evaluation;
  }
  heed();
  if (counters_.evaluations >= quota_) throw Stop{StopReason::evaluations};
  const std::uint64_t index = counters_.evaluations++;
  if (gradient) ++counters_.gradients;
  Evaluation e = call(design, gradient);
  if (!e.ok()) ++counters_.failures[e.failure];
  if (options_.observer) options_.observer({stage_, index, design, gradient, e});
  Memory& slot = memory_[next_++ % kMemory];
  slot.design.assign(design.begin(), design.end());
  slot.evaluation = std::move(e);
  return slot.evaluation;
}

void Session::remember(std::span<const double> design, const Evaluation& evaluation) {
  Memory& slot = memory_[next_++ % kMemory];
  slot.design.assign(design.begin(), design.end());
  slot.evaluation = evaluation;
}

}  // namespace twum::inline v0_1::optim
