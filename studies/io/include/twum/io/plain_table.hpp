// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/csv.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// True for a heading that the reader of a table knows, such as "preload [N]".
using KnownHeading = std::function<bool(std::string_view heading)>;

/// A table as this program writes them: UTF-8, commas, decimal points, headings with their units in its first record.
struct PlainTable {
  std::string text;  ///< each line is where it was
  std::string
      kind;  ///< what it was: "text in UTF-16, columns separated by semicolons"; empty: nothing has changed
};

/// Rewrites the table of a spreadsheet, an instrument or a logger. Its headings are in the line with the most known ones among
/// the first 200, or in its first line. Lines above them, and a row of units below them, become empty.
///
/// A comma inside the numbers of known columns is a decimal comma if one of them leaves no doubt ("0,5", "12,75"). If it may
/// separate thousands everywhere ("1,200"), or if there are decimal points too, the cells stay as they are: no reader takes
/// them for numbers.
/// @param name  of the file, for errors
/// @throws InputError for a spreadsheet or another file that is no text
PlainTable plain_table(const std::string& name, std::string content, const KnownHeading& known);

/// A stream of bytes, and what it was.
struct PlainStream {
  CsvReader::Bytes bytes;  ///< of plain CSV
  std::string kind;        ///< as of PlainTable
};

/// The same of a stream, whose beginning is read at once. A plain table is passed on as it comes; another one is read as a whole.
/// @throws InputError likewise, and if a table that is not plain has more than 256 MiB
PlainStream plain_stream(const std::string& name, CsvReader::Bytes bytes,
                         const KnownHeading& known);

}  // namespace twum::inline v0_1::io
