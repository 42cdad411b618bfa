// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// One record of a CSV text, with the line on which it begins, counted from 1.
struct CsvRecord {
  std::size_t begin;   ///< offset in the text of its chunk
  std::size_t length;  ///< in bytes, without line end
  std::size_t line;    ///< on which it begins
};

/// Consecutive records and their text.
struct CsvChunk {
  std::string text;                ///< the records and what stands between them
  std::vector<CsvRecord> records;  ///< where they are

  /// Text of record `i`, without its line end: a view into the chunk.
  std::string_view record(std::size_t i) const {
    return std::string_view(text).substr(records[i].begin, records[i].length);
  }
};

/// Cuts a stream of bytes into CSV records (RFC 4180: commas, "" quoting, line ends LF or CRLF, line breaks inside
/// quotes). Blank lines, remarks (lines that begin with #) and a byte order mark are skipped. Memory holds one block of the stream and one record,
/// whatever the length of the stream.
class CsvReader {
 public:
  /// Fills up to `size` bytes and returns how many, 0 at the end.
  using Bytes = std::function<std::size_t(char* to, std::size_t size)>;

  /// @param name   of the file, for errors
  /// @param bytes  source of the bytes; called by read() only
  CsvReader(std::string name, Bytes bytes) : name_(std::move(name)), bytes_(std::move(bytes)) {}

  /// Replaces the chunk by the next records, at most `most` and at most about 256 KiB; false at the end.
  /// @throws InputError if a quotation does not end or a record is longer than 64 MiB, after the records before it
  ///         were returned.
  bool read(CsvChunk& chunk, std::size_t most);

  /// Name of the file in errors.
  const std::string& name() const noexcept { return name_; }
  /// Bytes of the stream up to the end of the last record read.
  std::size_t bytes_taken() const noexcept { return bytes_read_ - rest().size(); }

 private:
  /// Bytes that were read but not yet divided into records.
  std::string_view rest() const noexcept { return {buffer_.data() + at_, end_ - at_}; }
  bool fill();
  bool find_record(std::size_t& length, std::size_t& lines);
  bool next(CsvChunk& chunk);

  std::string name_;
  Bytes bytes_;
  std::string buffer_;  // grows, never shrinks; bytes at_ to end_ are in use
  std::size_t at_{0};
  std::size_t end_{0};
  std::size_t line_{1};
  std::size_t bytes_read_{0};
  bool at_start_{true};
  bool at_end_{false};
  std::exception_ptr failure_;  // thrown by the next read
};

/// The bytes of a C file, which must outlive them.
/// @throws InputError (when read from) if reading fails.
CsvReader::Bytes bytes_of(std::FILE* file, const std::string& name);

/// Divides a record into cells, with their quotation marks; the cells are views into the record. Readers of whole tables meet
/// commas only (plain_table.hpp).
/// @return false if a quotation mark is in the wrong place.
bool split_record(std::string_view record, std::vector<std::string_view>& cells,
                  char separator = ',');

/// The text of a cell: blanks, quotation marks and doubled quotation marks removed.
std::string cell_text(std::string_view cell);

/// True for a text that a spreadsheet may run as a formula: it begins with '=', '+', '-', '@', a tab or a carriage
/// return, and is not a number.
bool is_formula(std::string_view text);

/// Appends a text that does not come from a user as a cell, quoted if necessary.
void append_own_cell(std::string& out, std::string_view text);

/// Appends a text as a cell, quoted if necessary. A formula gets a leading apostrophe, which makes spreadsheets treat
/// it as text.
void append_cell(std::string& out, std::string_view text);

}  // namespace twum::inline v0_1::io
