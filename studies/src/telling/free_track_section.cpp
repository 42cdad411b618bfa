// SPDX-License-Identifier: Apache-2.0
#include "telling/free_track_section.hpp"

#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies::telling {
namespace {

using State = LifeResult::TrackState;

struct Named {
  std::string name;
  const State* state;
};

std::vector<Named> states_of(const LifeResult::FreeTrack& track) {
  std::vector<Named> states{{"new", &track.fresh}};
  if (track.run_in) states.push_back({"after run-in", &*track.run_in});
  states.push_back({"end", &track.last});
  return states;
}

double least_depth(const State& state) {
  return std::ranges::min_element(state.nodes, {}, &LifeResult::AtNode::depth)->depth;
}

template <typename ValueOf>
Chart over_radius(const LifeResult::FreeTrack& track, const std::string& name, Phrase title,
                  const std::string& quantity, const std::string& unit, ValueOf value_of) {
  Chart chart{name, std::move(title), {{"radius"}, "mm"}, {{quantity}, unit, true}};
  std::size_t colour = 0;
  for (const Named& one : states_of(track)) {
    Series series{one.name, Stroke::line, {}, {}, colour_of(colour++)};
    for (const LifeResult::AtNode& node : one.state->nodes) {
      series.x.values.push_back(1e3 * node.radius);
      series.y.values.push_back(value_of(*one.state, node));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Table states_table(const LifeResult::FreeTrack& track) {
  Table table{
      "free-states",
      {{"track"}, {"time"}, {"speed"}, {"torque"}, {"friction power"}, {"largest pressure"}},
      {}};
  for (const Named& one : states_of(track)) {
    const auto highest =
        std::ranges::max_element(one.state->nodes, {}, &LifeResult::AtNode::pressure);
    table.rows.push_back({{one.name},
                          {time_part(one.state->seconds)},
                          {value_part(one.state->speed, "rad/s")},
                          {value_part(one.state->torque, "N.m")},
                          {value_part(one.state->friction_power, "W")},
                          {value_part(highest->pressure, "Pa")}});
  }
  return table;
}

// Depths less that of the least worn radius, which run-in leaves in nanometres.
Table nodes_table(const LifeResult::FreeTrack& track) {
  Table table{"free-profile", {{"radius"}}, {}};
  const std::vector<Named> states = states_of(track);
  for (const Named& one : states) {
    if (one.state != &track.fresh) table.heads.push_back({"uneven depth, " + one.name});
    table.heads.push_back({"pressure, " + one.name});
  }
  for (std::size_t j = 0; j < track.fresh.nodes.size(); ++j) {
    std::vector<Phrase> row{{value_part(track.fresh.nodes[j].radius, "m", 4)}};
    for (const Named& one : states) {
      const LifeResult::AtNode& node = one.state->nodes[j];
      if (one.state != &track.fresh)
        row.push_back({value_part(node.depth - least_depth(*one.state), "m", 3)});
      row.push_back({value_part(node.pressure, "Pa", 3)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Section free_track_section(const LifeResult::FreeTrack& track) {
  Section section{{"Each radius by itself"},
                  {"Each radius of the track wears by its own pressure and slip (profile: free). "
                   "The uneven depth is that beyond the least worn "
                   "radius."}};
  section.sentences = {
      {track.run_in ? "After run-in all radii wear at one rate, to 1 %."
                    : "The radii do not come to one rate of wear."},
      {"At the end the most loaded radius carries ", value_part(track.largest_share, "1", 3),
       " times its even share. At more than 3 the wear localizes, and there is no life."}};
  section.charts = {
      over_radius(track, "free-depth", {"depth beyond the least worn radius"}, "uneven depth", "nm",
                  [](const State& state, const LifeResult::AtNode& node) {
                    return 1e9 * (node.depth - least_depth(state));
                  }),
      over_radius(
          track, "free-pressure", {"largest pressure over the radius"}, "pressure", "MPa",
          [](const State&, const LifeResult::AtNode& node) { return 1e-6 * node.pressure; })};
  section.tables = {states_table(track), nodes_table(track)};
  return section;
}

}  // namespace twum::inline v0_1::studies::telling
