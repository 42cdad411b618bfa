// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

#include <array>
#include <chrono>

namespace twum::optim {

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

/// The one door to the evaluator, for one stage: counts, remembers, enforces the budget, observes.
class Session {
 public:
  /// `quota` is the number of evaluator calls that this stage may make.
  Session(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
          std::uint64_t stage, std::size_t quota);

  /// The evaluation of a design; a design just evaluated is not evaluated again. The reference
  /// holds until the next call. Values that are not finite come back as a failure "not-finite".
  /// @throws Stop when the quota, the time or the caller's patience is used up.
  const Evaluation& at(std::span<const double> design, bool gradient);

  /// For whoever goes on without calls. @throws Stop when the time or the caller's patience is used up.
  void heed() const;

  /// Puts a known evaluation into the memory, so that asking for it costs nothing.
  void remember(std::span<const double> design, const Evaluation& evaluation);

  const Problem& problem() const { return problem_; }
  const SolveOptions& options() const { return options_; }
  const Counters& counters() const { return counters_; }
  std::uint64_t stage() const { return stage_; }
  std::size_t left() const { return quota_ - counters_.evaluations; }

  /// This many more calls may be made, whatever was allowed before.
  void allow(std::size_t calls) { quota_ = counters_.evaluations + calls; }

 private:
  struct Memory {
    std::vector<double> design;
    Evaluation evaluation;
  };
  static constexpr std::size_t kMemory = 4;  // solvers come back to the last points only

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

}  // namespace twum::optim
