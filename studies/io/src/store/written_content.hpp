// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace twum::inline v0_1::io {

/// The largest file of a results folder that is read as a whole [bytes].
inline constexpr std::size_t kLargestResult = std::size_t{256} << 20U;

/// Content of a file that this program wrote: an ordinary file of at most kLargestResult bytes.
/// @throws StoreError with the path and the reason
std::string written_content(const std::string& path);

}  // namespace twum::inline v0_1::io
