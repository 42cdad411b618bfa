// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/executor.hpp"
#include "run/channel.hpp"

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Computes on the threads of this process and on those of others.
class SharedExecutor final : public Executor {
 public:
  /// A thread of another process.
  struct Lane {
    unsigned process;
    int number;  ///< number of its lane in the channel
    std::size_t at_a_time{1};
  };

  /// Keeps references.
  SharedExecutor(const StudyKindRun& kind, unsigned jobs, Channel& channel,
                 std::vector<Lane> elsewhere);

  unsigned lanes() const override;
  std::vector<StoredRow> rows(const std::vector<StoredRow>& asked,
                              const std::function<bool()>& proceed) override;

 private:
  std::vector<StoredRow> rows_of_lane(Lane& lane, const std::vector<StoredRow>& asked,
                                      const std::function<bool()>& proceed);
  std::size_t take_lane();
  void give_back(std::size_t lane);

  ThreadExecutor here_;
  Channel& channel_;
  std::vector<Lane> elsewhere_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable returned_;
  // indices into `elsewhere`; from its size on, threads of this process
  std::vector<std::size_t> free_;
};

/// The answer to a message of a SharedExecutor, at the other end of a lane. An exception is sent as a text and thrown
/// there.
std::string answer_of(const std::string& message, ThreadExecutor& executor);

}  // namespace twum::inline v0_1::studies
