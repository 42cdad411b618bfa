// SPDX-License-Identifier: Apache-2.0
#include "file/shape_rows.hpp"

#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

Shape<std::pair<double, double>> shape_row() {
  const Shape<double> radius = quantity("radius", "m", "24.5 mm");
  const Shape<double> amplitude = quantity("R there", "1", "0.9");
  const auto pair = list("radius and R", path("a number", "24.5 mm"), 2, 2);
  using Pair = std::pair<double, double>;
  Shape<Pair> shape;
  shape.schema = pair.schema;
  shape.read = [=](Pair& into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    std::vector<std::string> texts;
    if (!pair.read(texts, node, spot, diagnostics)) return false;
    const auto at = [&](std::size_t i) {
      return Spot{spot.path + "[" + std::to_string(i) + "]", node.items[i].mark};
    };
    const bool first = radius.read(into.first, node.items[0], at(0), diagnostics);
    return amplitude.read(into.second, node.items[1], at(1), diagnostics) && first;
  };
  shape.write = [=](const Pair& row) {
    YamlNode node;
    node.kind = YamlNode::Kind::list;
    node.items = {radius.write(row.first), amplitude.write(row.second)};
    return node;
  };
  return shape;
}

}  // namespace twum::inline v0_1::motors
