// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// A program and its libraries must have containers of one layout. `-D_GLIBCXX_DEBUG` changes that of std::vector and others, so
/// that a library built without it would read wrong members. A program that mixes the two does not link: it refers to a symbol
/// that only a library of its own kind has.

namespace twum::inline v0_1::base {

#ifdef _GLIBCXX_DEBUG
/// Defined by libraries that were built with _GLIBCXX_DEBUG.
extern const char library_was_built_with_glibcxx_debug;
/// The reference to it.
[[gnu::used]] inline const char* const same_containers = &library_was_built_with_glibcxx_debug;
#else
/// Defined by libraries that were built without _GLIBCXX_DEBUG.
extern const char library_was_built_without_glibcxx_debug;
/// The reference to it.
[[gnu::used]] inline const char* const same_containers = &library_was_built_without_glibcxx_debug;
#endif

}  // namespace twum::inline v0_1::base
