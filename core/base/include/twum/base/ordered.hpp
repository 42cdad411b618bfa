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

namespace twum {

/// Threads to use for a request: 0 means one for each processor.
unsigned job_count(unsigned requested);

/// Reads, works on, and writes items, the work on several threads, the writing in the order of the
/// reading. No more than a few items for each thread exist at a time.
///
///     bool read(Item&)   fills the next item, one call at a time; false if there is none
///     void work(Item&)   on any thread, several at a time
///     void write(Item&)  one call at a time, in the order of reading
///
/// When a callback throws, every item before that one is still written; then the exception comes out.
template <typename Item, typename Read, typename Work, typename Write>
class OrderedRun {
 public:
  /// @param jobs  threads, at least 1; the caller's is one of them
  OrderedRun(unsigned jobs, Read read, Work work, Write write)
      : jobs_(jobs), read_(std::move(read)), work_(std::move(work)), write_(std::move(write)) {}

  /// Goes through all items, once.
  /// @throws whatever the first callback to throw did, by the order of the items
  void run() {
    std::vector<std::thread> threads;
    try {
      for (unsigned i = 1; i < jobs_; ++i) threads.emplace_back([this] { serve(); });
    } catch (const std::exception&) {
      // No more threads, or no memory for them: those that are there do the work.
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
      fail(kNone);  // before another thread may read on
      return kNone;
    }
    const std::lock_guard lock(mutex_);
    if (!more) ended_ = true;
    return more ? next_read_++ : kNone;
  }

  // Parks the item, and writes what is due unless another thread is at it.
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

  // Ends reading; items from `index` on are not written any more.
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

/// OrderedRun in one call; of `jobs` 0 counts as 1.
template <typename Item, typename Read, typename Work, typename Write>
void run_ordered(unsigned jobs, Read read, Work work, Write write) {
  OrderedRun<Item, Read, Work, Write>(std::max(jobs, 1U), std::move(read), std::move(work),
                                      std::move(write))
      .run();
}

/// Items that run_indexed() is to make: those from `first` to before `end`.
struct IndexRange {
  std::uint64_t first{0};         ///< first item
  std::uint64_t end{0};           ///< past the last item
  unsigned jobs{0};               ///< threads; 0 takes one for each processor
  std::function<bool()> proceed;  ///< asked between items, on any thread; false ends the run
};

/// Makes items in blocks of indices on several threads, and takes them in the order of the indices, without gaps: the same
/// for any number of threads. No more than some hundred items for each thread exist at a time.
///
///     vector<Item> make(std::uint64_t first, std::uint64_t end)  on any thread, several at a time; fewer items than asked for
///                                                                 end the run behind them
///     void take(std::uint64_t first, vector<Item>& items)         one call at a time, of indices that follow one another
///
/// @return the first index not taken: `end`, unless the run was told to end
/// @throws whatever the first callback to throw did, once every block of items before is taken
template <typename Make, typename Take>
std::uint64_t run_blocks(const IndexRange& range, Make make, Take take) {
  struct Block {
    std::uint64_t first{0}, end{0};
    std::invoke_result_t<Make&, std::uint64_t, std::uint64_t> items;
  };
  // Enough blocks for every thread to have its share, and items enough in one to be worth the handing on.
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
        if (block.first != taken) return;  // behind a gap
        take(block.first, block.items);
        taken += block.items.size();
      });
  return taken;
}

/// run_blocks() for items that are made one by one:
///
///     Item make(std::uint64_t index)                      on any thread, several at a time
///     void take(std::uint64_t first, vector<Item>& items)  one call at a time, of indices that follow one another
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

}  // namespace twum
