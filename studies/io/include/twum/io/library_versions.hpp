// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {

/// Names and versions of the libraries that files are read and written with.
std::vector<std::pair<std::string, std::string>> file_library_versions();

}  // namespace twum::inline v0_1::io
