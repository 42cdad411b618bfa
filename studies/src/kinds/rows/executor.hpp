// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"

#include <functional>
#include <vector>

namespace twum::inline v0_1::studies {

/// Computes the rows of a study, on the threads of this process (ThreadExecutor) or of all processes that were
/// started for it (Processes::executor()).
class Executor {
 public:
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// How many rows can be computed at once; callers should use as many threads.
  virtual unsigned lanes() const = 0;

  /// Computes the requested rows by StudyKindRun::recompute() and returns them in order: all, or those before
  /// `proceed` returned false. Blocks until they are done. Thread-safe.
  /// @throws the exceptions of recompute(), and Error if another process fails
  virtual std::vector<StoredRow> rows(const std::vector<StoredRow>& asked,
                                      const std::function<bool()>& proceed) = 0;

  /// Computes one row.
  StoredRow row(const StoredRow& asked) {
    return std::move(rows({asked}, [] { return true; }).front());
  }

 protected:
  Executor() = default;
};

/// Computes on the calling thread.
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

}  // namespace twum::inline v0_1::studies
