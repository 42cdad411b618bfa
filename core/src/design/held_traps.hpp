// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>

namespace twum::inline v0_1::core {

/// Holds the host's floating-point traps in its scope, because NaN stands for "no value" in the core and a comparison with it
/// is an invalid operation. Flags and traps are afterwards what they were before. Costs some nanoseconds where the host has
/// enabled no trap.
class HeldTraps {
 public:
#ifdef __GLIBC__
  HeldTraps() : held_(fegetexcept() != 0) {
    if (held_) std::feholdexcept(&before_);
  }
  ~HeldTraps() {
    if (held_) std::fesetenv(&before_);
  }
#else  // no standard way to enable a trap
  HeldTraps() {}
  ~HeldTraps() {}
#endif
  HeldTraps(const HeldTraps&) = delete;
  HeldTraps& operator=(const HeldTraps&) = delete;

 private:
#ifdef __GLIBC__
  bool held_;
  std::fenv_t before_{};
#endif
};

}  // namespace twum::inline v0_1::core
