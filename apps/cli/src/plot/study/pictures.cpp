// SPDX-License-Identifier: Apache-2.0
#include "plot/study/pictures.hpp"

#include "plot/frequency_plot.hpp"
#include "plot/study/kinds.hpp"
#include "plot/study/told_pictures.hpp"

#include <twum/io/engineering.hpp>
#include <twum/motors/plain_name.hpp>

#include <algorithm>
#include <iterator>
#include <variant>

namespace twum::cli {
namespace {

std::string member_name(const std::optional<studies::StoredColumn>& family, double value) {
  return family ? studies::plain_name(family->name) + " " +
                      studies::printed_engineering(value, family->unit)
                : "motor";
}

std::vector<studies::NamedValue> member_values(const std::optional<studies::StoredColumn>& family,
                                               double value) {
  if (!family) return {};
  return {{family->name, family->unit, value}};
}

struct ResponseQuantity {
  const char* name;
  const char* unit;
  double (*value)(const OperatingPoint&);
};

constexpr ResponseQuantity kResponses[] = {
    {"wave amplitude", "m", [](const OperatingPoint& p) { return p.amplitude; }},
    {"speed", "rad/s", [](const OperatingPoint& p) { return p.speed; }},
    {"torque", "N.m", [](const OperatingPoint& p) { return p.torque; }},
    {"electrical power", "W", [](const OperatingPoint& p) { return p.electrical_power; }},
    {"output power", "W", [](const OperatingPoint& p) { return p.output_power; }},
    {"current of a phase", "A", [](const OperatingPoint& p) { return p.phase_current; }}};

Panel response_panel(const studies::FrequencyResult& answer, const ResponseQuantity& quantity,
                     bool named) {
  Panel panel{{"frequency", "Hz", false, 0, answer.from, answer.to},
              {quantity.name, quantity.unit, true, 0.08},
              {}};
  for (std::size_t i = 0; i < answer.members.size(); ++i) {
    bool first = named;
    for (const ResponseBranch& branch : answer.members[i].branches) {
      Series series{
          first && branch.stable ? member_name(answer.family, answer.members[i].value) : "",
          branch.stable ? Draw::line : Draw::dashes,
          colour_of(i),
          {}};
      first = first && !branch.stable;
      for (const ResponsePoint& p : branch.points)
        series.rows.push_back({p.frequency, quantity.value(p.point)});
      panel.series.push_back(std::move(series));
    }
  }
  return panel;
}

Picture family_of_responses(const FinishedStudy& study, const studies::FrequencyResult& answer) {
  const std::string_view given = answer.load.given == Argument::torque ? "torque" : "speed";
  Chart chart{study.title("responses; dashed waves are unstable"), {}, true};
  for (const ResponseQuantity& quantity : kResponses)
    if (quantity.name != given)
      chart.panels.push_back(response_panel(answer, quantity, chart.panels.empty()));
  return picture_of("responses", chart);
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::CurveResult& answer) {
  std::vector<Picture> pictures;
  std::vector<NamedMotor> motors;
  for (const studies::CurveResult::Member& member : answer.members)
    add_motor(motors, member_name(answer.family, member.value), study.result.design,
              member_values(answer.family, member.value));
  add_curve_pictures(pictures, study.title("torque-speed curves"), motors);
  return pictures;
}

std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::FrequencyResult& answer) {
  if (answer.members.size() != 1) return {family_of_responses(study, answer)};
  const studies::FrequencyResult::Member& member = answer.members.front();
  FrequencyPicture picture{member.branches,
                           {},
                           answer.from,
                           answer.to,
                           member.frequency,
                           member.pull_out_below,
                           answer.load.given == Argument::speed};
  for (const studies::FrequencyResult::Jumped& jumped : member.jumps)
    picture.jumps.push_back(jumped.jump);
  const studies::MotorFile titled{study.title("response"), study.result.design};
  return {{"response", kFrequencyPlotSize, frequency_plot(titled, picture)}};
}

std::vector<Picture> study_pictures(const FinishedStudy& study) {
  std::vector<Picture> pictures = std::visit(
      [&](const auto& answer) { return pictures_of(study, answer); }, study.result.answer);
  std::ranges::move(told_pictures(study), std::back_inserter(pictures));
  return pictures;
}

}  // namespace twum::cli
