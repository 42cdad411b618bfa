// SPDX-License-Identifier: Apache-2.0
#include "fmu/archive.hpp"

#include "output.hpp"

#include <zip.h>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

// 1980-01-01 in the times of a zip archive.
constexpr zip_uint16_t kDate = (1 << 5) | 1;

[[noreturn]] void fail(const char* reason) {
  throw OutputError(std::string("the archive cannot be made: ") + reason);
}

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

void add(zip_t* archive, const std::string& path, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) fail(zip_strerror(archive));
  const zip_int64_t index = zip_file_add(archive, path.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    fail(zip_strerror(archive));
  }
  if (zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, kDate, 0) < 0)
    fail(zip_strerror(archive));
}

std::string contents(zip_source_t* source) {
  if (zip_source_open(source) < 0) fail(zip_error_strerror(zip_source_error(source)));
  zip_source_seek(source, 0, SEEK_END);
  std::string bytes(static_cast<std::size_t>(zip_source_tell(source)), '\0');
  zip_source_seek(source, 0, SEEK_SET);
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read != static_cast<zip_int64_t>(bytes.size())) fail("it cannot be read");
  return bytes;
}

}  // namespace

std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& files) {
  zip_error_t error;
  zip_error_init(&error);
  const Source source(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!source) fail(zip_error_strerror(&error));
  zip_source_keep(source.get());  // the archive gives its own hold back when it closes
  zip_t* archive = zip_open_from_source(source.get(), ZIP_TRUNCATE, &error);
  if (archive == nullptr) fail(zip_error_strerror(&error));
  try {
    for (const auto& [path, bytes] : files) add(archive, path, bytes);
    if (zip_close(archive) < 0) fail(zip_strerror(archive));
  } catch (...) {
    zip_discard(archive);
    throw;
  }
  return contents(source.get());
}

}  // namespace twum::inline v0_1::cli
