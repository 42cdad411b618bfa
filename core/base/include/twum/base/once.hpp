// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>

namespace twum::inline v0_1 {

/// A value that is computed when it is first asked for. Threads that ask at once wait for one of them. If computing it throws,
/// the next one who asks computes it.
template <typename T>
class Once {
 public:
  /// @param make  computes the value
  template <typename Make>
  const T& get(Make make) const {
    struct Call {
      const Once* self;
      Make* make;
    } call{this, &make};
    // By a plain function: a template of the standard library for a type of ours is visible in programs.
    void (*const run)(void*) = [](void* at) {
      const Call& one = *static_cast<Call*>(at);
      one.self->value_.emplace((*one.make)());
    };
    std::call_once(asked_, run, static_cast<void*>(&call));
    return *value_;
  }

 private:
  mutable std::once_flag asked_;
  mutable std::optional<T> value_;
};

}  // namespace twum::inline v0_1
