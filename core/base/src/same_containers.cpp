// SPDX-License-Identifier: Apache-2.0
#include <twum/base/same_containers.hpp>

namespace twum::inline v0_1::base {

#ifdef _GLIBCXX_DEBUG
const char library_was_built_with_glibcxx_debug = 1;
#else
const char library_was_built_without_glibcxx_debug = 1;
#endif

}  // namespace twum::inline v0_1::base
