// SPDX-License-Identifier: Apache-2.0
#ifndef __wasm__  // the page has no workspaces
#include "design/workspace.hpp"

#include <algorithm>
#include <bit>

namespace twum::inline v0_1 {
namespace core {
namespace {

constexpr std::size_t kSmallest = 64, kSmallestSlab = 16 << 10;

std::size_t size_class(std::size_t bytes) {
  return static_cast<std::size_t>(std::countr_zero(std::bit_ceil(std::max(bytes, kSmallest))));
}

}  // namespace

constinit thread_local WorkBlocks* work_blocks = nullptr;

struct alignas(std::max_align_t) WorkBlocks::Slab {
  Slab* before;
  std::size_t size;

  std::byte* begin() { return reinterpret_cast<std::byte*>(this + 1); }
  std::byte* end() { return begin() + size; }
};

WorkBlocks::~WorkBlocks() {
  while (last_) ::operator delete(std::exchange(last_, last_->before));
}

void WorkBlocks::add_slab(std::size_t bytes) {
  last_ = new (::operator new(sizeof(Slab) + bytes)) Slab{last_, bytes};
  begin_ = last_->begin(), end_ = last_->end();
  size_ += bytes;
}

void* WorkBlocks::take(std::size_t bytes) {
  const std::size_t which = size_class(bytes), size = std::size_t{1} << which;
  if (Free* block = free_[which]) return free_[which] = block->next, block;
  if (static_cast<std::size_t>(end_ - begin_) < size)
    add_slab(std::max({size, size_, kSmallestSlab}));
  return std::exchange(begin_, begin_ + size);
}

void WorkBlocks::give_back(void* block, std::size_t bytes) noexcept {
  Free*& first = free_[size_class(bytes)];
  first = new (block) Free{first};
}

bool WorkBlocks::holds(const void* block) const noexcept {
  const std::less<const void*> below;  // that of any two places
  for (Slab* slab = last_; slab; slab = slab->before)
    if (!below(block, slab->begin()) && below(block, slab->end())) return true;
  return false;
}

}  // namespace core

Workspace::Workspace(std::size_t bytes) : blocks_(std::make_unique<core::WorkBlocks>()) {
  if (bytes > 0) blocks_->add_slab(bytes);
}
Workspace::Workspace(Workspace&& other) noexcept = default;
Workspace& Workspace::operator=(Workspace&& other) noexcept = default;
Workspace::~Workspace() = default;

std::size_t Workspace::size() const noexcept { return blocks_ ? blocks_->size() : 0; }

}  // namespace twum::inline v0_1
#endif
