// SPDX-License-Identifier: Apache-2.0
#include "entries/profile_shape.hpp"

#include <twum/io/words.hpp>

#include <utility>

namespace twum::inline v0_1::studies::shapes {
namespace {

using io::YamlNode;
using motion::Interval;
using motion::Profile;

io::Shape<Profile::Row> row_shape(const std::string& unit, const std::string& example) {
  const io::Shape<double> time = io::quantity("time", "s", "5 ms");
  const io::Shape<double> value = io::quantity("value", unit, example);
  const auto pair = io::list("time and value", io::path("a number", "5 ms"), 2, 2);
  io::Shape<Profile::Row> shape;
  shape.schema = pair.schema;
  shape.schema.example = "[5 ms, " + example + "]";
  shape.read = [=](Profile::Row& into, const YamlNode& node, const io::Spot& spot,
                   io::Diagnostics& diagnostics) {
    std::vector<std::string> texts;
    if (!pair.read(texts, node, spot, diagnostics)) return false;
    const auto at = [&](std::size_t i) {
      return io::Spot{spot.path + "[" + std::to_string(i) + "]", node.items[i].mark};
    };
    const bool first = time.read(into.first, node.items[0], at(0), diagnostics);
    return value.read(into.second, node.items[1], at(1), diagnostics) && first;
  };
  shape.write = [=](const Profile::Row& row) {
    YamlNode node;
    node.kind = YamlNode::Kind::list;
    node.items = {time.write(row.first), value.write(row.second)};
    return node;
  };
  return shape;
}

// Adds an error for a row before the one above it, or a third row of one time.
bool times_rise(const std::vector<Profile::Row>& rows, const YamlNode& node, const io::Spot& spot,
                io::Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool falls = rows[i].first < rows[i - 1].first;
    if (!falls && !(i > 1 && rows[i].first == rows[i - 2].first)) continue;
    const YamlNode& time = node.items[i].items[0];
    diagnostics.add(time.mark, spot.path + "[" + std::to_string(i) + "][0]",
                    io::quoted(time.scalar),
                    falls ? "expected a time no earlier than that of the row above"
                          : "expected at most two rows with the same time; two are a step");
    return false;
  }
  return true;
}

io::Shape<Profile> rows_shape(const std::string& unit, const std::string& example) {
  auto rows = io::list(
      "rows of time and value, with linear interpolation; two rows with the same time are a step",
      row_shape(unit, example));
  rows.schema.example = "[[0 ms, " + example + "], [5 ms, " + example + "]]";
  io::Shape<Profile> shape;
  shape.schema = rows.schema;
  shape.read = [rows](Profile& into, const YamlNode& node, const io::Spot& spot,
                      io::Diagnostics& diagnostics) {
    std::vector<Profile::Row> found;
    if (!rows.read(found, node, spot, diagnostics) || !times_rise(found, node, spot, diagnostics))
      return false;
    into = Profile(std::move(found));
    return true;
  };
  shape.write = [rows](const Profile& profile) { return rows.write(profile.rows()); };
  return shape;
}

}  // namespace

io::Shape<Profile> profile(std::string text, std::string unit, std::string example) {
  const auto value = io::shape_as<Profile, double>(
      io::quantity(text, unit, example), [](double constant) { return Profile(constant); },
      [](const Profile& at) { return at.rows().front().second; });
  auto shape = io::one_of<Profile>(
      std::move(text), {value, rows_shape(unit, example)},
      [](const Profile& at) { return at.rows().size() == 1 ? std::size_t{0} : std::size_t{1}; });
  shape.schema.example = example;
  return shape;
}

io::Shape<std::vector<Interval>> intervals(std::string text) {
  auto times = io::list(std::move(text), io::quantity("a time", "s", "30 ms"), 2);
  times.schema.example = "[30 ms, 40 ms]";
  io::Shape<std::vector<Interval>> shape;
  shape.schema = times.schema;
  shape.read = [times](std::vector<Interval>& into, const YamlNode& node, const io::Spot& spot,
                       io::Diagnostics& diagnostics) {
    std::vector<double> found;
    if (!times.read(found, node, spot, diagnostics)) return false;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] >= 0 && (i == 0 || found[i] > found[i - 1])) continue;
      diagnostics.add(node.items[i].mark, spot.path + "[" + std::to_string(i) + "]",
                      io::quoted(node.items[i].scalar),
                      "expected rising times from 0 s on, in pairs of begin and end");
      return false;
    }
    if (found.size() % 2 != 0) {
      diagnostics.add(node.mark, spot.path, "the last interval has no end",
                      "expected pairs of begin and end, such as [30 ms, 40 ms]");
      return false;
    }
    into.clear();
    for (std::size_t i = 0; i < found.size(); i += 2) into.push_back({found[i], found[i + 1]});
    return true;
  };
  shape.write = [times](const std::vector<Interval>& from) {
    std::vector<double> ends;
    for (const Interval& one : from) ends.push_back(one.begin), ends.push_back(one.end);
    return times.write(ends);
  };
  return shape;
}

}  // namespace twum::inline v0_1::studies::shapes
