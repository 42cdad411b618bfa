// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/study_kind.hpp"

#include <functional>
#include <vector>

namespace twum::studies {

/// Who computes the rows of a study: the threads of this process (ThreadExecutor), or those of all processes that were
/// started for it (Processes::executor()). The kinds do not see which.
class Executor {
 public:
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// How many rows can be computed at once: so many threads should ask.
  virtual unsigned lanes() const = 0;

  /// The rows asked for as StudyKindRun::recompute() has them, in order: all, or those before `proceed` said no. Waits for
  /// them; safe from any number of threads.
  /// @throws what recompute() throws, and Error if another process fails
  virtual std::vector<StoredRow> rows(const std::vector<StoredRow>& asked,
                                      const std::function<bool()>& proceed) = 0;

  /// One of them.
  StoredRow row(const StoredRow& asked) {
    return std::move(rows({asked}, [] { return true; }).front());
  }

 protected:
  Executor() = default;
};

/// Computes on the thread that asks.
class ThreadExecutor final : public Executor {
 public:
  /// Keeps a reference.
  /// @param jobs  threads; 0 takes one for each processor
  explicit ThreadExecutor(const StudyKindRun& kind, unsigned jobs = 1);

  unsigned lanes() const override { return jobs_; }
  std::vector<StoredRow> rows(const std::vector<StoredRow>& asked,
                              const std::function<bool()>& proceed) override;

 private:
  const StudyKindRun& kind_;
  unsigned jobs_;
};

}  // namespace twum::studies
