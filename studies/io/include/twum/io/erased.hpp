// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {

/// A function whose first argument is a T, kept as a function of an address. Code that reads and writes entries can
/// therefore be compiled once, not once for each struct.
template <typename T, typename Result, typename... Others>
class FunctionOf {
 public:
  /// What is kept.
  using Erased = std::function<Result(void*, Others...)>;

  FunctionOf() = default;
  /// Of a function object that takes a T& first. Implicit, as for std::function: lambdas are passed.
  template <std::invocable<T&, Others...> F>
  requires(!std::same_as<F, FunctionOf>) FunctionOf(F function)
      : erased_([function = std::move(function)](void* value, Others... others) -> Result {
          return function(*static_cast<T*>(value), std::forward<Others>(others)...);
        }) {}

  /// The function that `erased` keeps, which has to be one of a T.
  static FunctionOf from(Erased erased) {
    FunctionOf function;
    function.erased_ = std::move(erased);
    return function;
  }

  /// Calls it.
  Result operator()(T& value, Others... others) const {
    // The function takes a const T again if T is const.
    return erased_(const_cast<std::remove_const_t<T>*>(&value), std::forward<Others>(others)...);
  }
  /// The same as a function of an address, which has to be that of a T.
  const Erased& erased() const { return erased_; }

 private:
  Erased erased_;
};

/// A list by its address.
struct ErasedList {
  void (*clear)(void* list);                      ///< takes all items out
  void* (*add)(void* list);                       ///< a new item at the end
  void (*drop)(void* list);                       ///< takes the last item out
  std::size_t (*size)(void* list);                ///< number of items
  void* (*item)(void* list, std::size_t number);  ///< one of them, counted from 0
};

/// Of items of type V.
template <typename V>
constexpr ErasedList erased_list() {
  using List = std::vector<V>;
  return {
      [](void* list) { static_cast<List*>(list)->clear(); },
      [](void* list) -> void* { return &static_cast<List*>(list)->emplace_back(); },
      [](void* list) { static_cast<List*>(list)->pop_back(); },
      [](void* list) { return static_cast<List*>(list)->size(); },
      [](void* list, std::size_t number) -> void* { return &(*static_cast<List*>(list))[number]; }};
}

}  // namespace twum::inline v0_1::io
