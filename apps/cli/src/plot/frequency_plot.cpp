// SPDX-License-Identifier: Apache-2.0
#include "plot/frequency_plot.hpp"

#include "plot/style.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::cli {
namespace {

using Value = double (*)(const OperatingPoint&);

struct ResponseSeries {
  Value value;
  const char* name;  // in the key; empty: none
  const char* colour;
};

struct ResponsePanel {
  const char* quantity;
  const char* unit;
  std::vector<ResponseSeries> series;
};

std::vector<ResponsePanel> panels_of(const FrequencyPicture& picture) {
  const ResponsePanel speed{
      "speed", "rad/s", {{[](const OperatingPoint& p) { return p.speed; }, "", colour::kBlue}}};
  const ResponsePanel torque{
      "torque", "N.m", {{[](const OperatingPoint& p) { return p.torque; }, "", colour::kBlue}}};
  return {
      {"amplitude",
       "m",
       {{[](const OperatingPoint& p) { return p.amplitude; }, "", colour::kBlue}}},
      picture.at_speed ? torque : speed,
      {"power",
       "W",
       {{[](const OperatingPoint& p) { return p.electrical_power; }, "electrical", colour::kOrange},
        {[](const OperatingPoint& p) { return p.output_power; }, "output", colour::kBlue}}},
      {"phase current",
       "A",
       {{[](const OperatingPoint& p) { return p.phase_current; }, "", colour::kBlue}}}};
}

double largest_of(const ResponsePanel& panel, const FrequencyPicture& picture) {
  double largest = 0;
  for (const ResponseSeries& series : panel.series)
    for (const ResponseBranch& branch : picture.branches)
      for (const ResponsePoint& p : branch.points)
        largest = std::max(largest, std::abs(series.value(p.point)));
  return largest;
}

std::string block_name(std::size_t panel, std::size_t series, std::size_t branch) {
  return "p" + std::to_string(panel) + "_" + std::to_string(series) + "_" + std::to_string(branch);
}

std::string guide_lines(const FrequencyPicture& picture) {
  const std::string x = plot_number(picture.operating / 1e3);
  std::string script = "set arrow 1 from first " + x + ", graph 0 to first " + x +
                       ", graph 1 nohead back dashtype '.' linewidth 1.5 linecolor rgb '#444444'\n";
  if (picture.pull_out && *picture.pull_out < picture.operating)
    script += "set object 1 rectangle from first " +
              plot_number(std::max(*picture.pull_out, picture.from) / 1e3) + ", graph 0 to first " +
              x + ", graph 1 behind fillcolor rgb '#eef3e8' fillstyle solid noborder\n";
  return script;
}

std::string jump_arrows(const FrequencyPicture& picture, const ResponseSeries& series,
                        double divisor) {
  std::string script;
  int number = 10;
  for (const Jump& jump : picture.jumps) {
    if (!jump.to) continue;
    const std::string x = plot_number(jump.from.frequency / 1e3);
    script += "set arrow " + std::to_string(number++) + " from first " + x + ", first " +
              plot_number(series.value(jump.from.point) / divisor) + " to first " + x + ", first " +
              plot_number(series.value(jump.to->point) / divisor) +
              " head filled size screen 0.012, 18 linewidth 1.2 linecolor rgb '" +
              colour::kVermilion + "'\n";
  }
  return script;
}

// The margin and the operating frequency are named once, above the first panel.
std::string names_of_marks(const FrequencyPicture& picture) {
  std::string text = "drive at " + studies::printed_engineering(picture.operating, "Hz");
  if (picture.pull_out && *picture.pull_out < picture.operating)
    text += ", pulls out below " + studies::printed_engineering(*picture.pull_out, "Hz");
  return "set label 97 " + plot_text(text) +
         " at graph 1, graph 1.02 right offset 0, character 0.4 font 'Arial,11' noenhanced\n";
}

std::string draw_panel(const FrequencyPicture& picture, const ResponsePanel& panel,
                       std::size_t index, std::string& data) {
  const studies::DisplayUnit unit = studies::display_unit(largest_of(panel, picture), panel.unit);
  std::string script = vertical_label(panel.quantity, unit) + guide_lines(picture), plots;
  script += jump_arrows(picture, panel.series.front(), unit.divisor);
  if (index == 0) script += names_of_marks(picture);
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    bool named = false;
    for (std::size_t b = 0; b < picture.branches.size(); ++b) {
      const ResponseBranch& branch = picture.branches[b];
      std::vector<std::vector<double>> rows;
      for (const ResponsePoint& p : branch.points)
        rows.push_back({p.frequency / 1e3, panel.series[s].value(p.point) / unit.divisor});
      const std::string name = block_name(index, s, b);
      data += plot_data(name, rows);
      const bool name_it = branch.stable && !named;
      named |= name_it;
      plots += std::string(plots.empty() ? "plot " : ", ") + "$" + name +
               " using 1:2 with lines linewidth " + (branch.stable ? "2" : "1.2") + " dashtype " +
               (branch.stable ? "1" : "2") + " linecolor rgb '" + panel.series[s].colour +
               "' title " + plot_text(name_it ? panel.series[s].name : "");
    }
  }
  return script + plots + "\nunset label\nunset arrow\nunset object\n";
}

}  // namespace

std::string frequency_plot(const studies::MotorFile& file, const FrequencyPicture& picture) {
  std::string data, script;
  const std::vector<ResponsePanel> panels = panels_of(picture);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double top = 0.93 - 0.22 * static_cast<double>(i);
    const bool last = i + 1 == panels.size();
    script += panel_place(top, top - 0.185, last) + "set offsets 0, 0, graph 0.06, 0\n";
    if (last) script += horizontal_label("frequency", {"kHz", 1e3});
    script += draw_panel(picture, panels[i], i, data);
  }
  return data + plot_style(plot_text(motor_title(file))) + "set multiplot\nset xrange [" +
         plot_number(picture.from / 1e3) + ":" + plot_number(picture.to / 1e3) + "]\n" + script +
         "unset multiplot\n";
}

}  // namespace twum::cli
