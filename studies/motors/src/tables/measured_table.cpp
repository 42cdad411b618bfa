// SPDX-License-Identifier: Apache-2.0
#include "tables/measured_table.hpp"

#include "tables/chosen_columns.hpp"
#include "tables/instrument_headings.hpp"
#include "tables/measured_columns.hpp"
#include "tables/text_kind.hpp"
#include "tables/touchstone.hpp"
#include "text/file_content.hpp"

#include <twum/io/plain_table.hpp>

#include <algorithm>

namespace twum::inline v0_1::motors {

MeasuredTable measured_table(const Source& source, const std::vector<ColumnChoice>& choices) {
  std::vector<std::string> kinds;
  if (auto touchstone =
          touchstone_table({source.name(), utf8_text(source.name(), source.text(), kinds)})) {
    for (const std::string& kind : kinds) touchstone->kind += ", " + kind;
    return *std::move(touchstone);
  }
  const auto known = [&](std::string_view heading) {
    return is_measured_heading(heading) || is_instrument_heading(heading) ||
           std::ranges::any_of(choices,
                               [&](const ColumnChoice& one) { return names(one, heading); });
  };
  PlainTable plain = plain_table(source.name(), source.text(), known);
  return {{source.name(), std::move(plain.text)}, std::move(plain.kind)};
}

MeasuredTable read_measured_table(const std::string& path,
                                  const std::vector<ColumnChoice>& choices) {
  const std::string name = path == "-" ? "standard input" : path;
  return measured_table({name, file_content(path, kLargestMeasurements)}, choices);
}

}  // namespace twum::inline v0_1::motors
