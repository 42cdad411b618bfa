// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

namespace twum::inline v0_1::detail {

void assertion_failed(const char* condition, const char* file, int line) {
  throw BugError(std::string("internal error, please report it: ") + file + ":" +
                 std::to_string(line) + ": " + condition);
}

}  // namespace twum::inline v0_1::detail
