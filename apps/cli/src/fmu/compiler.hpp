// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::cli {

/// Name and text of a source file.
using SourceFile = std::pair<std::string, std::string>;

/// A shared library, or why there is none.
struct Compiled {
  std::string binary;   ///< its bytes; empty if there is none
  std::string problem;  ///< a sentence; empty if there is none
};

/// Compiles sources of C with the machine's `cc`, in a folder of their own that is removed.
Compiled compile_shared_library(const std::vector<SourceFile>& files);

}  // namespace twum::inline v0_1::cli
