// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace twum::inline v0_1::cli {

/// Name and version, the linked solver libraries, and the resulting licence.
std::string version_text();

}  // namespace twum::inline v0_1::cli
