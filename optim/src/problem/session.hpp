// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

#include <array>
#include <chrono>

namespace twum::inline v0_1::optim {

/// Stages between the first ones of solves that run at the same time: more than one solve ever takes.
inline constexpr std::uint64_t kStagesOfASolve = 1000;

/// Thrown through a solver when the solve must end; never leaves the library.
struct Stop {
  StopReason reason;
};

/// The clock of one solve, shared by its stages.
class Deadline {
 public:
  explicit Deadline(double seconds) : begin_(Clock::now()), seconds_(seconds) {}
  double elapsed() const;
  bool passed() const { return seconds_ < kInfinity && elapsed() > seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_;
  double seconds_;
};

/// An observer whose calls a lock serializes: observers need not be thread-safe. Empty for none.
Observer serialized(const Observer& observer);

/// Access to the evaluator for one stage. Counts calls, caches the last points, enforces the budget and calls the
/// observer.
class Session {
 public:
  /// `quota` is the number of evaluator calls that this stage may make.
  Session(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
          std::uint64_t stage, std::size_t quota);

  /// The evaluation of a design, from the cache if it was one of the last. The reference is valid until the next
  /// call. Values that are not finite come back as a failure "not-finite".
  /// @throws Stop if the quota or the time is used up, or if a stop was requested.
  const Evaluation& at(std::span<const double> design, bool gradient);

  /// To be called in computations without evaluations. @throws Stop if the time is used up, or if a stop was
  /// requested.
  void heed() const;

  /// Puts a known evaluation into the cache.
  void remember(std::span<const double> design, const Evaluation& evaluation);

  const Problem& problem() const { return problem_; }
  const SolveOptions& options() const { return options_; }
  const Counters& counters() const { return counters_; }
  std::uint64_t stage() const { return stage_; }
  std::size_t left() const { return quota_ - counters_.evaluations; }

  /// Allows this many more calls, regardless of the earlier quota.
  void allow(std::size_t calls) { quota_ = counters_.evaluations + calls; }

 private:
  struct Memory {
    std::vector<double> design;
    Evaluation evaluation;
  };
  static constexpr std::size_t kMemory = 4;  // solvers return to the last points only

  const Memory* find(std::span<const double> design, bool gradient) const;
  Evaluation call(std::span<const double> design, bool gradient);

  const Problem& problem_;
  const SolveOptions& options_;
  const Deadline& deadline_;
  std::uint64_t stage_;
  std::size_t quota_;
  Counters counters_;
  std::array<Memory, kMemory> memory_;
  std::size_t next_{0};
};

}  // namespace twum::inline v0_1::optim
