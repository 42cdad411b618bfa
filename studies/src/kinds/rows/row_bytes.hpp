// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Appends the bytes of a number to the detail of a row.
template <typename T>
void append_bytes(std::string& bytes, const T& value) {
  const auto at = bytes.size();
  bytes.resize(at + sizeof value);
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// Reads back what append_bytes() wrote; a row that is too short was not written by this study.
class RowBytes {
 public:
  explicit RowBytes(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  T take() {
    T value{};
    if (at_ + sizeof value > bytes_.size())
      throw StoreError("the stored evaluations are damaged: a row is too short");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  std::vector<double> numbers() {
    const auto count = take<std::uint32_t>();
    std::vector<double> list;
    for (std::uint32_t i = 0; i < count; ++i) list.push_back(take<double>());
    return list;
  }

  std::string text() {
    const auto size = take<std::uint64_t>();
    if (size > bytes_.size() - at_)
      throw StoreError("the stored evaluations are damaged: a row is too short");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  const std::string& bytes_;
  std::size_t at_{0};
};

/// Appends a list with its length.
inline void append_numbers(std::string& bytes, const std::vector<double>& list) {
  append_bytes(bytes, static_cast<std::uint32_t>(list.size()));
  for (const double value : list) append_bytes(bytes, value);
}

/// Appends a text with its length.
inline void append_text(std::string& bytes, const std::string& text) {
  append_bytes(bytes, static_cast<std::uint64_t>(text.size()));
  bytes += text;
}

}  // namespace twum::inline v0_1::studies
