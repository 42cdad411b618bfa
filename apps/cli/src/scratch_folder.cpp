// SPDX-License-Identifier: Apache-2.0
#include "scratch_folder.hpp"

#include "output.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace twum::inline v0_1::cli {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& user)
    : path_((fs::temp_directory_path() / "twum-XXXXXX").string()) {
  if (::mkdtemp(path_.data()) == nullptr)
    throw OutputError("a temporary folder for " + user +
                      " cannot be made: " + std::strerror(errno));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace twum::inline v0_1::cli
