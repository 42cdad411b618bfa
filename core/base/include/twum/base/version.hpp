// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The version of twum (semantic versioning). CMake reads it here.

#define TWUM_VERSION_MAJOR 0  ///< first number of the version
#define TWUM_VERSION_MINOR 1  ///< second number
#define TWUM_VERSION_PATCH 0  ///< third number
/// For comparisons by the preprocessor: 1.2.3 is 10203.
#define TWUM_VERSION (TWUM_VERSION_MAJOR * 10000 + TWUM_VERSION_MINOR * 100 + TWUM_VERSION_PATCH)

/// A name such as library_has_version_0_1.
#define TWUM_NAME_WITH_VERSION(major, minor) TWUM_NAME_WITH_NUMBERS(major, minor)
#define TWUM_NAME_WITH_NUMBERS(major, minor) library_has_version_##major##_##minor  ///< its parts

namespace twum::inline v0_1 {

/// Version of the library that runs, "major.minor.patch"; static lifetime. The macros are those of the headers.
const char* version() noexcept;

namespace base {

/// Defined by libraries of this minor version. Structures may differ in another one, so that a program with its headers does not
/// link: it refers to a name that the library does not have.
extern const char TWUM_NAME_WITH_VERSION(TWUM_VERSION_MAJOR, TWUM_VERSION_MINOR);
/// The reference to it.
[[gnu::used]] inline const char* const same_version =
    &TWUM_NAME_WITH_VERSION(TWUM_VERSION_MAJOR, TWUM_VERSION_MINOR);

}  // namespace base

}  // namespace twum::inline v0_1
