// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace twum::cli {

/// Name and version, the solver libraries that are linked, and the licence that follows from them.
std::string version_text();

}  // namespace twum::cli
