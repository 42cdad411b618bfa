// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum {

/// Version of the library, "major.minor.patch" (semantic versioning); static lifetime.
const char* version() noexcept;

}  // namespace twum
