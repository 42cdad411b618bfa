// SPDX-License-Identifier: Apache-2.0
#include "store/written_content.hpp"

#include "text/file_content.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>

namespace twum::inline v0_1::io {

std::string written_content(const std::string& path) {
  try {
    return plain_file_content(path, kLargestResult);
  } catch (const InputError& error) {
    throw StoreError(error.what());
  }
}

}  // namespace twum::inline v0_1::io
