// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// A library that results depend on.
struct LibraryVersion {
  std::string name;     ///< such as "NLopt"
  std::string version;  ///< such as "2.7.1"; "none" if it is not in this build
};

/// The solver libraries in use, in a fixed order. Throws only if memory runs out.
std::vector<LibraryVersion> library_versions();

}  // namespace twum::inline v0_1::optim
