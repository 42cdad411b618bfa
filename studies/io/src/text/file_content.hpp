// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace twum::inline v0_1::io {

/// Content of a file, or of a pipe that another program writes to. "-" is standard input.
/// @param most  bytes
/// @throws InputError with the path and the reason: a directory, a device, more than `most` bytes, a pipe without a writer
std::string file_content(const std::string& path, std::size_t most);

/// The same of a file that is neither a pipe nor standard input.
/// @throws InputError likewise
std::string plain_file_content(const std::string& path, std::size_t most);

}  // namespace twum::inline v0_1::io
