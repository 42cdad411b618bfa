// SPDX-License-Identifier: Apache-2.0
// Memory of what lives no longer than an evaluation: from the Workspace that the evaluation was given, else from the heap.
#pragma once

#include <twum/core/workspace.hpp>

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace twum::inline v0_1::core {

#ifdef __wasm__  // the page has no workspaces
struct WorkIn {
  static WorkIn heap() noexcept { return {}; }
};
struct InWorkspace {};
template <typename T>
using FromWorkspace = std::allocator<T>;
#else

/// Blocks of powers of two, out of slabs from the heap. A block that is given back serves the next request of its size, so that an
/// evaluation needs no more memory the second time.
class WorkBlocks {
 public:
  WorkBlocks() = default;
  ~WorkBlocks();
  WorkBlocks(const WorkBlocks&) = delete;
  WorkBlocks& operator=(const WorkBlocks&) = delete;

  void* take(std::size_t bytes);
  /// @param bytes  as it was taken
  void give_back(void* block, std::size_t bytes) noexcept;
  bool holds(const void* block) const noexcept;

  void add_slab(std::size_t bytes);
  /// All slabs [byte].
  std::size_t size() const noexcept { return size_; }

 private:
  struct Slab;
  struct Free {
    Free* next;
  };

  Slab* last_{nullptr};
  std::byte *begin_{nullptr}, *end_{nullptr};  // what is left of it
  std::size_t size_{0};
  std::array<Free*, 64> free_{};
};

/// Of the evaluation in which this thread is; null: none was given.
extern constinit thread_local WorkBlocks* work_blocks;

/// In its scope the evaluations of this thread take their memory from a workspace.
class WorkIn {
 public:
  explicit WorkIn(Workspace& workspace) noexcept : WorkIn(workspace.blocks_.get()) {}
  /// From the heap again: for what outlives the evaluation.
  static WorkIn heap() noexcept { return WorkIn(nullptr); }
  ~WorkIn() { work_blocks = before_; }
  WorkIn(const WorkIn&) = delete;
  WorkIn& operator=(const WorkIn&) = delete;

 private:
  explicit WorkIn(WorkBlocks* blocks) noexcept : before_(std::exchange(work_blocks, blocks)) {}
  WorkBlocks* before_;
};

/// A block for so many bytes.
inline void* take_block(std::size_t bytes) {
  return work_blocks ? work_blocks->take(bytes) : ::operator new(bytes);
}

/// Gives it back, in the same scope of WorkIn.
inline void give_block_back(void* block, std::size_t bytes) noexcept {
  if (work_blocks && work_blocks->holds(block))
    work_blocks->give_back(block, bytes);
  else
    ::operator delete(block, bytes);
}

/// Base of classes whose objects are made by `new` in an evaluation.
struct InWorkspace {
  static void* operator new(std::size_t bytes) { return take_block(bytes); }
  static void operator delete(void* block, std::size_t bytes) noexcept {
    give_block_back(block, bytes);
  }
};

/// Allocator of the containers below.
template <typename T>
struct FromWorkspace {
  static_assert(alignof(T) <= alignof(std::max_align_t));
  using value_type = T;

  FromWorkspace() = default;
  template <typename U>
  FromWorkspace(const FromWorkspace<U>&) noexcept {}  // NOLINT: any is as good as another one

  T* allocate(std::size_t count) { return static_cast<T*>(take_block(count * sizeof(T))); }
  void deallocate(T* block, std::size_t count) noexcept {
    give_block_back(block, count * sizeof(T));
  }
  friend bool operator==(const FromWorkspace&, const FromWorkspace&) { return true; }
};
#endif

template <typename T>
using Vector = std::vector<T, FromWorkspace<T>>;
template <typename T>
using Deque = std::deque<T, FromWorkspace<T>>;
template <typename Key, typename T>
using Map = std::map<Key, T, std::less<Key>, FromWorkspace<std::pair<const Key, T>>>;

}  // namespace twum::inline v0_1::core
