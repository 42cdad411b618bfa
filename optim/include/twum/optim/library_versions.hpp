// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::optim {

/// A library that results depend on.
struct LibraryVersion {
  std::string name;     ///< such as "NLopt"
  std::string version;  ///< such as "2.7.1"; "none" if this build does without it
};

/// Solver libraries that are in use, in a fixed order. Never throws but for lack of memory.
std::vector<LibraryVersion> library_versions();

}  // namespace twum::optim
