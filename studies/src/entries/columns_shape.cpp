// SPDX-License-Identifier: Apache-2.0
#include "entries/columns_shape.hpp"

#include "entries/named_shape.hpp"
#include "tables/measured_columns.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <utility>

namespace twum::inline v0_1::studies::shapes {
namespace {

// A heading, or the number of a column.
struct Place {
  std::string heading;
  std::size_t number{0};
};

Place parse_place(std::string_view text) {
  constexpr double kMostColumns = 1000;
  const auto number = parse_number(text);
  if (!number) return {std::string(text), 0};
  const auto whole =
      *number >= 1 && *number <= kMostColumns ? static_cast<std::size_t>(*number) : 0;
  if (static_cast<double>(whole) != *number)
    throw ValueError(quoted(text), "expected the number of a column, from 1, or its heading");
  return {{}, whole};
}

std::string place_text(const Place& place) {
  return place.number > 0 ? std::to_string(place.number) : place.heading;
}

Shape<Place> place() {
  return text_of<Place>(
      "heading of the column, with or without its unit, or its number, counted from 1", "n [rpm]",
      parse_place, place_text);
}

struct Item {
  Place place;
  std::string unit;
  bool reversed{false};
};

ColumnChoice to_choice(const Item& item) {
  return {{}, item.place.heading, item.place.number, item.unit, item.reversed};
}

Item from_choice(const ColumnChoice& choice) {
  return {{choice.heading, choice.number}, choice.unit, choice.reversed};
}

Shape<ColumnChoice> column() {
  const auto alone = shape_as<Item, Place>(
      place(),
      [](Place place) {
        return Item{std::move(place), {}, false};
      },
      [](const Item& item) { return item.place; });
  const auto whole = mapping<Item>(
      "a column, its unit and its sign",
      {required<Item>("column", place(), &Item::place),
       optional<Item>("unit", path("unit of its cells", "mN.m"), &Item::unit,
                      "the unit in the heading"),
       standard<Item>(
           "sign", word<bool>("sign of its values: as given, or reversed", {"given", "reversed"}),
           &Item::reversed)});
  const auto either =
      one_of<Item>("the column of a quantity", {alone, whole},
                   [](const Item& item) { return item.unit.empty() && !item.reversed ? 0U : 1U; });
  return shape_as<ColumnChoice, Item>(either, to_choice, from_choice);
}

bool check_quantity(const YamlEntry& entry, const Spot& spot, Diagnostics& diagnostics) {
  constexpr std::string_view kDeviation = "_sd";
  std::string_view name = entry.key;
  if (name.ends_with(kDeviation)) name.remove_suffix(kDeviation.size());
  if ((is_measured_heading(name) || name == "time") &&
      name.find_first_of(" [(/") == std::string_view::npos)
    return true;
  diagnostics.add(entry.key_mark, spot.entry(entry.key, entry.key_mark).path,
                  quoted(entry.key) + " is not a quantity that a table may contain",
                  "expected speed, torque, a metric, a parameter, frequency, impedance or another "
                  "electrical quantity, or one of them with _sd");
  return false;
}

}  // namespace

Shape<std::vector<ColumnChoice>> columns() {
  Schema schema;
  schema.text = "columns of the tables, for quantities that the headings do not name";
  schema.example = "speed: \"n [rpm]\"";
  schema.sample = "speed: \"n [rpm]\"\ntorque: {column: 3, unit: mN.m, sign: reversed}";
  return named_items(std::move(schema), column(), &ColumnChoice::quantity, check_quantity);
}

}  // namespace twum::inline v0_1::studies::shapes
