// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {

/// A list that its copies share until one of them changes: a schema is put together from parts, each of which is copied
/// once for every level above it.
template <typename T>
class SharedList {
 public:
  SharedList() = default;
  /// Of the items of a vector, in whose place it stands.
  SharedList(std::vector<T> items) : items_(std::make_shared<std::vector<T>>(std::move(items))) {}
  /// Of these items.
  SharedList(std::initializer_list<T> items) : SharedList(std::vector<T>(items)) {}

  /// As of a vector.
  /// @{
  bool empty() const { return size() == 0; }
  std::size_t size() const { return items_ ? items_->size() : 0; }
  const T* data() const { return items_ ? items_->data() : nullptr; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return (*items_)[i]; }
  const T& front() const { return items_->front(); }
  void push_back(T item) { own().push_back(std::move(item)); }
  /// @}

  /// The items to change, which no other list shares from here on.
  std::vector<T>& own() {
    if (!items_)
      items_ = std::make_shared<std::vector<T>>();
    else if (items_.use_count() > 1)
      items_ = std::make_shared<std::vector<T>>(*items_);
    return *items_;
  }

 private:
  std::shared_ptr<std::vector<T>> items_;
};

}  // namespace twum::inline v0_1::io
