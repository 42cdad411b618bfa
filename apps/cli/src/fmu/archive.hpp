// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::cli {

/// A zip archive of files, each a path and its bytes. The same files make the same archive at any time.
std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace twum::inline v0_1::cli
