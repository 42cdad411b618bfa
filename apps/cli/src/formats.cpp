// SPDX-License-Identifier: Apache-2.0
#include "formats.hpp"

#include "options.hpp"
#include "terminal.hpp"

#include <twum/base/error.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

// Endings that say nothing of a format: none, those of plain text, and numbers, as of "run-1.5".
bool says_nothing(const std::string& ending) {
  constexpr std::array kPlain{"", "txt", "dat", "out", "log"};
  const bool number =
      std::ranges::all_of(ending, [](unsigned char c) { return std::isdigit(c) != 0; });
  return number || std::ranges::find(kPlain, ending) != kPlain.end();
}

// Formats whose files end otherwise than with their name.
constexpr std::array<std::pair<const char*, const char*>, 2> kEndings{
    {{"markdown", "md"}, {"matlab", "m"}}};

std::string ending_of(const std::string& format) {
  for (const auto& [name, ending] : kEndings)
    if (format == name) return ending;
  return format;
}

}  // namespace

std::string format_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (extension.empty()) return extension;
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  extension.erase(0, 1);
  for (const auto& [name, ending] : kEndings)
    if (extension == ending) return name;
  return extension;
}

void require_ending(const std::string& path, const std::vector<std::string>& formats) {
  const std::string ending = format_of(path);
  if (says_nothing(ending) || std::ranges::find(formats, ending) != formats.end()) return;
  std::string endings;
  for (const std::string& format : formats)
    if (format != "table") endings += (endings.empty() ? "." : ", .") + ending_of(format);
  throw InputError("-o " + studies::printable(path, 200) +
                   ": nothing that can be written here is a ." +
                   studies::printable(ending_of(ending)) + " file; expected the ending " + endings);
}

std::size_t OutputOptions::table_width() const {
  return path.empty() ? terminal_width(STDOUT_FILENO).value_or(0) : 0;
}

void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats) {
  const CLI::Option* given =
      command
          .add_option("--format", options.format,
                      "Format of the result (default: by the ending of the file, else a table)")
          ->check(one_of(formats))
          ->type_name(choices(formats));
  command
      .add_option_function<std::string>(
          "-o,--output",
          [&options, given, formats](const std::string& path) {
            options.path = path;
            const std::string by_name = format_of(path);
            const bool known = std::find(formats.begin(), formats.end(), by_name) != formats.end();
            if (given->count() > 0) return;
            if (known)
              options.format = by_name;
            else
              require_ending(path, formats);
          },
          "Write the result to this file")
      ->type_name("FILE");
}

std::string cell_of(double value) { return studies::number_text(value); }

std::string rounded_cell(double value, const ColumnScale& scale) {
  constexpr double kRounding = 1e-9;
  if (!std::isfinite(value)) return "-";
  const bool dust = std::abs(value) <= kRounding * scale.largest;
  return studies::rounded_text(dust ? 0 : value / scale.unit.divisor, 4);
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != cells.data()) line += ',';
    studies::append_cell(line, cell);
  }
  return line + "\n";
}

}  // namespace twum::inline v0_1::cli
