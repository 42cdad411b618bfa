// SPDX-License-Identifier: Apache-2.0
#include <twum/io/library_versions.hpp>

#include <sqlite3.h>

namespace twum::inline v0_1::io {

std::vector<std::pair<std::string, std::string>> file_library_versions() {
  return {{"SQLite", sqlite3_libversion()},
          {"UDUNITS", TWUM_UDUNITS_VERSION},
          {"yaml-cpp", TWUM_YAML_CPP_VERSION}};
}

}  // namespace twum::inline v0_1::io
