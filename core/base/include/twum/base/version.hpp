// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The version of twum (semantic versioning). CMake reads it here.

#define TWUM_VERSION_MAJOR 0  ///< first number of the version
#define TWUM_VERSION_MINOR 1  ///< second number
#define TWUM_VERSION_PATCH 0  ///< third number
/// For comparisons by the preprocessor: 1.2.3 is 10203.
#define TWUM_VERSION (TWUM_VERSION_MAJOR * 10000 + TWUM_VERSION_MINOR * 100 + TWUM_VERSION_PATCH)

namespace twum {

/// Version of the library that runs, "major.minor.patch"; static lifetime. The macros are those of the headers.
const char* version() noexcept;

}  // namespace twum
