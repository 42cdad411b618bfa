// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace twum::inline v0_1 {

/// Threads to use for a request: 0 means one for each processor.
unsigned job_count(unsigned requested);

/// Reads items, works on them on several threads, and writes them in the order in which they were read. At most a few
/// items for each thread exist at a time.
///
///     bool read(Item&)   fills the next item, one call at a time; false if there is none
///     void work(Item&)   on any thread, several at a time
///     void write(Item&)  one call at a time, in the order of reading
///
/// When a callback throws, all items read before that one are still written; then run() throws the exception.
template <typename Item, typename Read, typename Work, typename Write>
class OrderedRun {
 public:
  /// @param jobs  threads, at least 1; the caller's is one of them
  OrderedRun(unsigned jobs, Read read, Work work, Write write)
      : jobs_(jobs), read_(std::move(read)), work_(std::move(work)), write_(std::move(write)) {}

  /// Processes all items. To be called once.
  /// @throws the exception of the earliest item, in the order of reading, for which a callback threw
  void run() {
    std::vector<std::thread> threads;
    try {
      for (unsigned i = 1; i < jobs_; ++i) threads.emplace_back([this] { serve(); });
    } catch (const std::exception&) {
      // The system has no more threads or memory: the threads that have started do all the work.
    }
    serve();
    for (std::thread& thread : threads) thread.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void serve() {
    while (true) {
      std::size_t index = kNone;
      try {
        Item item;
        index = next(item);
        if (index == kNone) return;
        work_(item);
        deliver(index, std::move(item));
      } catch (...) {
        fail(index);
      }
    }
  }

  // Reads the next item; kNone at the end. Waits while too many are unwritten.
  std::size_t next(Item& item) {
    const std::lock_guard reading(read_mutex_);
    {
      std::unique_lock lock(mutex_);
      written_one_.wait(
          lock, [&] { return ended_ || next_read_ - next_write_ < 4 * std::size_t{jobs_}; });
      if (ended_) return kNone;
    }
    bool more = false;
    try {
      more = read_(item);
    } catch (...) {
      fail(kNone);  // before another thread reads the next item
      return kNone;
    }
    const std::lock_guard lock(mutex_);
    if (!more) ended_ = true;
    return more ? next_read_++ : kNone;
  }

  // Stores the finished item, then writes every item whose turn it is, unless another thread is writing.
  void deliver(std::size_t index, Item item) {
    std::unique_lock lock(mutex_);
    done_.emplace(index, std::move(item));
    if (writing_) return;
    writing_ = true;
    for (auto due = done_.find(next_write_); due != done_.end() && next_write_ < failed_;
         due = done_.find(next_write_)) {
      auto node = done_.extract(due);
      lock.unlock();
      try {
        write_(node.mapped());
      } catch (...) {
        fail(node.key());
      }
      lock.lock();
      ++next_write_;
      written_one_.notify_all();
    }
    writing_ = false;
  }

  // Ends reading. Item `index` and those after it are not written.
  void fail(std::size_t index) {
    const std::lock_guard lock(mutex_);
    const std::size_t at = index == kNone ? next_read_ : index;
    if (at < failed_) {
      failed_ = at;
      error_ = std::current_exception();
    }
    ended_ = true;
    written_one_.notify_all();
  }

  unsigned jobs_;
  Read read_;
  Work work_;
  Write write_;

  std::mutex read_mutex_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable written_one_;
  std::map<std::size_t, Item> done_;
  std::size_t next_read_{0};
  std::size_t next_write_{0};
  std::size_t failed_{kNone};
  bool writing_{false};
  bool ended_{false};
  std::exception_ptr error_;
};

/// OrderedRun in one call. 0 jobs count as 1.
template <typename Item, typename Read, typename Work, typename Write>
void run_ordered(unsigned jobs, Read read, Work work, Write write) {
  OrderedRun<Item, Read, Work, Write>(std::max(jobs, 1U), std::move(read), std::move(work),
                                      std::move(write))
      .run();
}

/// The items that run_indexed() makes: indices `first` to `end` - 1.
struct IndexRange {
  std::uint64_t first{0};         ///< first item
  std::uint64_t end{0};           ///< past the last item
  unsigned jobs{0};               ///< threads; 0 takes one for each processor
  std::function<bool()> proceed;  ///< called between items on any thread; false ends the run
};

/// Makes items in blocks of indices on several threads and hands them to take() in the order of their indices,
/// without gaps, so that the result does not depend on the number of threads. At most about a thousand items for each
/// thread exist at a time.
///
///     vector<Item> make(std::uint64_t first, std::uint64_t end)  on any thread, several at a time; a result with fewer
///                                                                 than end - first items ends the run after them
///     void take(std::uint64_t first, vector<Item>& items)         one call at a time; consecutive indices
///
/// @return the first index that was not taken: `end`, unless the run ended early
/// @throws the exception of the earliest block for which a callback threw, after all blocks before it were taken
template <typename Make, typename Take>
std::uint64_t run_blocks(const IndexRange& range, Make make, Take take) {
  struct Block {
    std::uint64_t first{0}, end{0};
    std::invoke_result_t<Make&, std::uint64_t, std::uint64_t> items;
  };
  // Blocks are small enough to share the items evenly among threads, and large enough to keep the cost of locking
  // low.
  constexpr std::uint64_t kMostAtATime = 256;
  const std::uint64_t count = range.end > range.first ? range.end - range.first : 0;
  const std::uint64_t threads = std::min<std::uint64_t>(job_count(range.jobs), count);
  const std::uint64_t at_a_time =
      std::clamp<std::uint64_t>(count / std::max<std::uint64_t>(8 * threads, 1), 1, kMostAtATime);
  std::uint64_t next = range.first, taken = range.first;
  run_ordered<Block>(
      static_cast<unsigned>(threads),
      [&](Block& block) {
        if (next >= range.end || (range.proceed && !range.proceed())) return false;
        block.first = next;
        next = block.end = std::min(next + at_a_time, range.end);
        return true;
      },
      [&](Block& block) { block.items = make(block.first, block.end); },
      [&](Block& block) {
        if (block.first != taken) return;  // an earlier block was short and ended the run
        take(block.first, block.items);
        taken += block.items.size();
      });
  return taken;
}

/// run_blocks() for items that are made one by one:
///
///     Item make(std::uint64_t index)                      on any thread, several at a time
///     void take(std::uint64_t first, vector<Item>& items)  one call at a time; consecutive indices
template <typename Make, typename Take>
std::uint64_t run_indexed(const IndexRange& range, Make make, Take take) {
  const auto made = [&](std::uint64_t first, std::uint64_t end) {
    std::vector<std::invoke_result_t<Make&, std::uint64_t>> items;
    for (std::uint64_t i = first; i < end && (!range.proceed || range.proceed()); ++i)
      items.push_back(make(i));
    return items;
  };
  return run_blocks(range, made, std::move(take));
}

}  // namespace twum::inline v0_1
