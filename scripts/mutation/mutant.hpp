// SPDX-License-Identifier: Apache-2.0
// What scripts/mutate.py puts in the place of operators and numbers: each does what it stood for, unless its
// change is switched on by TWUM_MUTANT=NUMBER. With TWUM_MUTANT_RECORD=FILE the program does what it always
// does and writes, at exit, one byte for each change: what was seen of it. Included before everything else.
#pragma once

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

#include <sys/prctl.h>

namespace mutant {

// Of type short, so that no store of a number can be taken for a store here.
inline constexpr int kMost = 32768;
inline constexpr short kOn = 1, kRecorded = 2;
inline short state[kMost];
// Bits: reached, would have given another value, has no changed form for these types.
inline constexpr unsigned char kReached = 1, kDiffered = 2, kFormless = 4;
inline unsigned char seen[kMost];

inline void write_record() {
  std::FILE* file = std::fopen(std::getenv("TWUM_MUTANT_RECORD"), "wb");
  if (!file) return;
  std::fwrite(seen, 1, kMost, file);
  std::fclose(file);
}

inline bool begun = false;
[[gnu::constructor(101)]] static void begin() {
  if (begun) return;
  begun = true;
  if (const char* number = std::getenv("TWUM_MUTANT")) {
    state[std::atoi(number) % kMost] = kOn;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // it may run for ever
  }
  if (std::getenv("TWUM_MUTANT_RECORD")) {
    for (short& each : state) each = kRecorded;
    std::atexit(write_record);
  }
}

[[gnu::noinline, gnu::cold]] inline void note(int id, bool differs) {
  seen[id] |= differs ? kReached | kDiffered : kReached;
  if (differs) state[id] = 0;  // there is no more to see
}
[[gnu::noinline, gnu::cold]] inline void note_formless(int id) { seen[id] |= kFormless; }

template <int id>
[[gnu::always_inline]] inline bool is_quiet() {
  return __builtin_expect(state[id] == 0, 1);
}

// ---- types --------------------------------------------------------------------------------------

template <typename T>
inline constexpr bool is_number = std::is_arithmetic_v<T>;
template <typename T>
concept Dual = requires(const T& x) {
  x.v;
  x.d[0];
};
template <typename T>
concept Matrix = requires(const T& x) {
  typename T::PlainObject;
  x.eval();
};

template <typename T>
bool differ(const T& a, const T& b) {
  if constexpr (std::is_floating_point_v<T>) {
    return !(std::isnan(a) && std::isnan(b)) && (a != b || std::signbit(a) != std::signbit(b));
  } else if constexpr (is_number<T>) {
    return a != b;
  } else if constexpr (Dual<T>) {
    bool found = differ(a.v, b.v);
    for (unsigned i = 0; i < sizeof(a.d) / sizeof(a.d[0]); ++i) found |= differ(a.d[i], b.d[i]);
    return found;
  } else {
    return true;
  }
}

// Expressions of matrices differ in type and become what they stand for.
template <typename T>
struct ValueOf {
  using type = T;
};
template <Matrix T>
struct ValueOf<T> {
  using type = typename T::PlainObject;
};
template <typename T>
using Value = typename ValueOf<std::remove_cvref_t<T>>::type;

// Numbers go by value, so that their addresses stay unknown.
template <typename T>
using Pass =
    std::conditional_t<std::is_scalar_v<std::remove_cvref_t<T>>, std::remove_cvref_t<T>, T&&>;

// ---- operators ----------------------------------------------------------------------------------

#define MUTANT_OPERATOR(Name, op)                               \
  struct Name {                                                 \
    template <typename A, typename B>                           \
    [[gnu::always_inline]] static auto of(A&& a, B&& b)         \
        -> decltype(std::forward<A>(a) op std::forward<B>(b)) { \
      return std::forward<A>(a) op std::forward<B>(b);          \
    }                                                           \
  };
MUTANT_OPERATOR(Plus, +)
MUTANT_OPERATOR(Minus, -)
MUTANT_OPERATOR(Times, *)
MUTANT_OPERATOR(Over, /)
MUTANT_OPERATOR(Less, <)
MUTANT_OPERATOR(LessEqual, <=)
MUTANT_OPERATOR(Greater, >)
MUTANT_OPERATOR(GreaterEqual, >=)
MUTANT_OPERATOR(Equal, ==)
MUTANT_OPERATOR(Unequal, !=)
MUTANT_OPERATOR(AddTo, +=)
MUTANT_OPERATOR(TakeFrom, -=)
MUTANT_OPERATOR(MultiplyBy, *=)
MUTANT_OPERATOR(DivideBy, /=)
#undef MUTANT_OPERATOR

template <typename Op, typename A, typename B>
concept Possible = requires(A&& a, B&& b) {
  Op::of(std::forward<A>(a), std::forward<B>(b));
};
template <typename Op, typename A, typename B>
using Result = decltype(Op::of(std::declval<A>(), std::declval<B>()));

// A change whose value can stand where the original's does.
template <typename Op, typename Other, typename A, typename B>
constexpr bool is_replaceable() {
  if constexpr (Possible<Other, A, B>) {
    return std::is_convertible_v<Value<Result<Other, A, B>>, Value<Result<Op, A, B>>>;
  } else {
    return false;
  }
}

template <typename Op, typename Other, typename A, typename B>
bool would_differ(A& a, B& b) {
  using R = Value<Result<Op, A&, B&>>;
  using P = std::remove_cvref_t<A>;
  using Q = std::remove_cvref_t<B>;
  if constexpr ((is_number<P> || Dual<P>)&&(is_number<Q> || Dual<Q>)) {
    if constexpr (std::is_integral_v<P> && std::is_integral_v<Q> && std::is_same_v<Other, Over>)
      if (b == 0) return true;
    return differ<R>(Op::of(a, b), static_cast<R>(Other::of(a, b)));
  } else if constexpr (std::is_same_v<R, bool>) {
    return static_cast<bool>(Op::of(a, b)) != static_cast<bool>(Other::of(a, b));
  } else {
    return true;
  }
}

template <typename Op, typename Other, typename A, typename B>
[[gnu::noinline, gnu::cold]] auto rarely(int id, A a, B b) -> Value<Result<Op, A, B>> {
  if (state[id] == kOn)
    return static_cast<Value<Result<Op, A, B>>>(Other::of(std::forward<A>(a), std::forward<B>(b)));
  note(id, would_differ<Op, Other>(a, b));
  return Op::of(std::forward<A>(a), std::forward<B>(b));
}

template <int id, typename Op, typename Other, typename A, typename B>
[[gnu::always_inline]] inline auto binary(A&& a, B&& b) {
  if constexpr (is_replaceable<Op, Other, A, B>()) {
    using R = Value<Result<Op, A, B>>;
    if (is_quiet<id>()) return R(Op::of(std::forward<A>(a), std::forward<B>(b)));
    return R(rarely<Op, Other, Pass<A>, Pass<B>>(id, std::forward<A>(a), std::forward<B>(b)));
  } else {
    if (!is_quiet<id>()) note_formless(id);
    return Op::of(std::forward<A>(a), std::forward<B>(b));
  }
}

#define MUTANT_BINARY(name, Op, Other)                                    \
  template <int id, typename A, typename B>                               \
  [[gnu::always_inline]] inline auto name(A&& a, B&& b) {                 \
    return binary<id, Op, Other>(std::forward<A>(a), std::forward<B>(b)); \
  }
MUTANT_BINARY(plus, Plus, Minus)
MUTANT_BINARY(minus, Minus, Plus)
MUTANT_BINARY(times, Times, Over)
MUTANT_BINARY(over, Over, Times)
MUTANT_BINARY(less, Less, LessEqual)
MUTANT_BINARY(less_equal, LessEqual, Less)
MUTANT_BINARY(greater, Greater, GreaterEqual)
MUTANT_BINARY(greater_equal, GreaterEqual, Greater)
MUTANT_BINARY(equal, Equal, Unequal)
MUTANT_BINARY(unequal, Unequal, Equal)
#undef MUTANT_BINARY

// ---- assignments --------------------------------------------------------------------------------

template <int id, typename Op, typename Other, typename Plain, typename PlainOther, typename A,
          typename B>
[[gnu::always_inline]] inline decltype(auto) assign(A&& a, B&& b) {
  using P = std::remove_cvref_t<A>;
  if (is_quiet<id>()) return Op::of(std::forward<A>(a), std::forward<B>(b));
  if constexpr ((is_number<P> || Dual<P>)&&is_replaceable<Plain, PlainOther, A, B>()) {
    a = static_cast<P>(
        rarely<Plain, PlainOther, Pass<const P&>, Pass<B>>(id, a, std::forward<B>(b)));
    return (a);
  } else if constexpr (Possible<Other, A, B>) {
    if (state[id] == kOn) {
      Other::of(std::forward<A>(a), std::forward<B>(b));
      return static_cast<Result<Op, A, B>>(a);
    }
    note(id, true);
    return Op::of(std::forward<A>(a), std::forward<B>(b));
  } else {
    note_formless(id);
    return Op::of(std::forward<A>(a), std::forward<B>(b));
  }
}

#define MUTANT_ASSIGNMENT(name, Op, Other, Plain, PlainOther)                                \
  template <int id, typename A, typename B>                                                  \
  [[gnu::always_inline]] inline decltype(auto) name(A&& a, B&& b) {                          \
    return assign<id, Op, Other, Plain, PlainOther>(std::forward<A>(a), std::forward<B>(b)); \
  }
MUTANT_ASSIGNMENT(add_to, AddTo, TakeFrom, Plus, Minus)
MUTANT_ASSIGNMENT(take_from, TakeFrom, AddTo, Minus, Plus)
MUTANT_ASSIGNMENT(multiply_by, MultiplyBy, DivideBy, Times, Over)
MUTANT_ASSIGNMENT(divide_by, DivideBy, MultiplyBy, Over, Times)
#undef MUTANT_ASSIGNMENT

// ---- signs and constants ------------------------------------------------------------------------

template <int id, typename A>
[[gnu::always_inline]] inline auto negative(A&& a) {
  using R = Value<decltype(-std::forward<A>(a))>;
  if (is_quiet<id>()) return R(-std::forward<A>(a));
  if constexpr (std::is_convertible_v<A, R>) {
    if (state[id] == kOn) return static_cast<R>(std::forward<A>(a));
    if constexpr (is_number<R> || Dual<R>) {
      note(id, differ<R>(-a, static_cast<R>(a)));
    } else {
      note(id, true);
    }
  } else {
    note_formless(id);
  }
  return R(-std::forward<A>(a));
}

template <int id, typename T, typename U>
[[gnu::always_inline]] inline T number(T value, U other) {
  if (is_quiet<id>()) return value;
  if (state[id] == kOn) return static_cast<T>(other);
  note(id, true);
  return value;
}

template <int id>
[[gnu::always_inline]] inline bool truth(bool value) {
  return number<id>(value, !value);
}

// ---- a && b, a || b: goes_on(a) ? second(b) : ended() -------------------------------------------

template <int id, bool both>
[[gnu::always_inline]] inline bool goes_on(bool a) {
  if (is_quiet<id>()) return a == both;
  if (state[id] == kOn) return a != both;
  if (a != both) note(id, true);  // what the other side says is not known
  return a == both;
}
template <int id, bool both>
[[gnu::always_inline]] inline bool second(bool b) {
  if (!is_quiet<id>() && state[id] == kRecorded) note(id, b != both ? true : false);
  return b;
}
template <int id, bool both>
[[gnu::always_inline]] inline bool ended() {
  return (state[id] == kOn) == both;
}

}  // namespace mutant
