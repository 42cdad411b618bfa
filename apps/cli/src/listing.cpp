// SPDX-License-Identifier: Apache-2.0
#include "listing.hpp"

#include "formats.hpp"
#include "json_parts.hpp"
#include "text_table.hpp"

#include <twum/io/csv.hpp>

namespace twum::inline v0_1::cli {
namespace {

std::string as_table(const Listing& listing, std::size_t width) {
  TextTable table;
  table.rows.push_back(listing.columns);
  table.rows.insert(table.rows.end(), listing.rows.begin(), listing.rows.end());
  return aligned(table, width);
}

// The lists hold no text from users, so a range that begins with a minus sign needs no apostrophe.
std::string own_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != cells.data()) line += ',';
    studies::append_own_cell(line, cell);
  }
  return line + "\n";
}

std::string as_csv(const Listing& listing) {
  std::string text = own_line(listing.columns);
  for (const auto& row : listing.rows) text += own_line(row);
  return text;
}

std::string as_json(const Listing& listing) {
  Json list = Json::array();
  for (const auto& row : listing.rows) {
    Json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[listing.columns[i]] = row[i];
    list.push_back(std::move(object));
  }
  return json_text(list);
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string as_markdown(const Listing& listing) {
  std::string text = "# " + listing.title + "\n\n" + listing.text + "\n\n";
  text += markdown_row(listing.columns);
  text += markdown_row(std::vector<std::string>(listing.columns.size(), "---"));
  for (auto row : listing.rows) {
    row.front() = "`" + row.front() + "`";
    text += markdown_row(row);
  }
  return text;
}

}  // namespace

std::string to_text(const Listing& listing, const std::string& format, std::size_t width) {
  if (format == "json") return as_json(listing);
  if (format == "csv") return as_csv(listing);
  return format == "markdown" ? as_markdown(listing) : as_table(listing, width);
}

}  // namespace twum::inline v0_1::cli
