// SPDX-License-Identifier: Apache-2.0
#include "run/shared_executor.hpp"

#include "run/row_message.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <span>

namespace twum::inline v0_1::studies {
namespace {

// First byte of an answer: rows follow, or the text of an error.
constexpr char kRows = 'r';
constexpr char kError = 'e';

// Rows of a message should take this long to compute. A message takes some ten microseconds, a small share of that,
// and a stop request is not delayed for longer.
constexpr std::chrono::milliseconds kWorthAMessage{10};
constexpr std::size_t kMostAtATime = 256;

}  // namespace

SharedExecutor::SharedExecutor(const StudyKindRun& kind, unsigned jobs, Channel& channel,
                               std::vector<Lane> elsewhere)
    : here_(kind, jobs), channel_(channel), elsewhere_(std::move(elsewhere)) {
  for (std::size_t lane = 0; lane < lanes(); ++lane) free_.push_back(lane);
}

unsigned SharedExecutor::lanes() const {
  return here_.lanes() + static_cast<unsigned>(elsewhere_.size());
}

// Prefers threads of this process, which are at the end of the list.
std::size_t SharedExecutor::take_lane() {
  std::unique_lock lock(mutex_);
  returned_.wait(lock, [this] { return !free_.empty(); });
  const auto nearest = std::max_element(free_.begin(), free_.end());
  const std::size_t lane = *nearest;
  free_.erase(nearest);
  return lane;
}

void SharedExecutor::give_back(std::size_t lane) {
  const std::lock_guard lock(mutex_);
  free_.push_back(lane);
  returned_.notify_one();
}

std::vector<StoredRow> SharedExecutor::rows(const std::vector<StoredRow>& asked,
                                            const std::function<bool()>& proceed) {
  struct Taken {
    SharedExecutor& executor;
    std::size_t lane;
    ~Taken() { executor.give_back(lane); }
  };
  const Taken taken{*this, take_lane()};
  if (taken.lane >= elsewhere_.size()) return here_.rows(asked, proceed);
  return rows_of_lane(elsewhere_[taken.lane], asked, proceed);
}

std::vector<StoredRow> SharedExecutor::rows_of_lane(Lane& lane, const std::vector<StoredRow>& asked,
                                                    const std::function<bool()>& proceed) {
  using Clock = std::chrono::steady_clock;
  std::vector<StoredRow> made;
  while (made.size() < asked.size() && proceed()) {
    const std::size_t count = std::min(lane.at_a_time, asked.size() - made.size());
    const auto begin = Clock::now();
    channel_.send(lane.process, lane.number,
                  row_message(std::span(asked).subspan(made.size(), count)));
    const std::string answer = channel_.receive(lane.process, lane.number);
    if (answer.front() == kError)
      throw Error("process " + std::to_string(lane.process) + ": " + answer.substr(1));
    std::ranges::move(rows_of(answer.substr(1)), std::back_inserter(made));
    const auto lasted = Clock::now() - begin;
    if (2 * lasted < kWorthAMessage) lane.at_a_time = std::min(2 * lane.at_a_time, kMostAtATime);
    if (lasted > 2 * kWorthAMessage) lane.at_a_time = std::max<std::size_t>(lane.at_a_time / 2, 1);
  }
  return made;
}

std::string answer_of(const std::string& message, ThreadExecutor& executor) {
  try {
    return kRows + row_message(executor.rows(rows_of(message), [] { return true; }));
  } catch (const std::exception& error) {
    return kError + std::string(error.what());
  }
}

}  // namespace twum::inline v0_1::studies
