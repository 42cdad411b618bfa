// SPDX-License-Identifier: Apache-2.0
#include "plot/curve_plot.hpp"

#include "plot/style.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace twum::cli {
namespace {

// Half a pixel of the PNG is 1 / 2400 of the width; the curve has few bends, and 600 points are smooth.
constexpr int kPoints = 601;

// Removes the labels of a panel before the next one; the title is drawn once.
constexpr const char* kEndOfPanel = "\nunset label\n";

enum Column : int {
  kSpeed = 1,
  kTorque,
  kOutput,
  kFriction,
  kLayer,
  kStator,
  kContactEfficiency,
  kEfficiency,
  kOverallEfficiency,
  // electrical power from below: output, and each loss on top of what is below it
  kUpToOutput,
  kUpToFriction,
  kUpToLayer,
  kUpToStator,
  kUpToCeramic,
  kUpToDriver,
  kSquealBelow,  // the band where the motor squeals; NaN where it does not
  kSquealAbove
};

struct Mark {
  const char* name;
  double speed;   // [rad/s]
  double torque;  // [N m]
  double power;   // [W]; NaN: not marked among the powers
  std::string text;
  const char* place;  // of the label against the mark
};

struct CurvePicture {
  std::vector<std::vector<double>> rows;
  std::vector<Mark> marks;
  bool squeals{false};  // at some speed
  studies::DisplayUnit speed;
  studies::DisplayUnit torque;
  studies::DisplayUnit power;
  double first;
  double last;
  bool damped;     // the stator takes a share, so there is an efficiency of the whole
  bool driver;     // a resistance in series with the phases takes a share
  bool terminals;  // modal data say what the terminals see
};

// The parts of the electrical power (D4.2), stacked; NaN where the rotor is driven from outside.
std::vector<double> stacked(const OperatingPoint& p) {
  double sum = p.output_power < 0 ? std::nan("") : 0;
  std::vector<double> stack;
  for (const double part : {p.output_power, p.friction_power, p.layer_loss, p.stator_loss,
                            p.dielectric_loss, p.driver_loss})
    stack.push_back(sum += part);
  return stack;
}

// Evenly spread, and ever closer to the no-load speed: the efficiency falls to 0 in the last hundredth before it.
std::vector<double> picture_speeds(const Motor& motor, double first, double last) {
  std::vector<double> speeds;
  for (int i = 0; i < kPoints; ++i) speeds.push_back(first + (last - first) * i / (kPoints - 1));
  const MetricValue no_load = evaluate(motor, {Metric::no_load_speed, Argument::none, 0});
  if (no_load.status == MetricStatus::ok && first < no_load.value && no_load.value < last) {
    for (double below = 0.01; below > 1e-6; below /= 2)
      speeds.push_back(no_load.value * (1 - below));
    speeds.push_back(no_load.value);
  }
  std::erase_if(speeds, [&](double speed) { return speed < first; });
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

std::vector<std::vector<double>> rows_of(const Motor& motor, double first, double last) {
  std::vector<std::vector<double>> rows;
  for (const double speed : picture_speeds(motor, first, last)) {
    const OperatingPoint p = motor.operating_point(speed);
    rows.push_back({speed, p.torque, p.output_power, p.friction_power, p.layer_loss, p.stator_loss,
                    p.contact_efficiency(), p.efficiency(), p.overall_efficiency()});
    const std::vector<double> stack = stacked(p);
    rows.back().insert(rows.back().end(), stack.begin(), stack.end());
    const bool squeals =
        studies::squeals(motor.design(), motor.backward_wave(speed)).value_or(false);
    const double torque = squeals ? p.torque : std::nan("");
    rows.back().insert(rows.back().end(), {torque, torque});
  }
  return rows;
}

// Gives the band of squeals its width. True if the motor squeals at some speed.
bool widen_squeals(std::vector<std::vector<double>>& rows) {
  const double largest_torque = largest(rows, kTorque, kTorque);
  bool any = false;
  for (std::vector<double>& row : rows) {
    const auto [below, above] = band_about(row[kSquealBelow - 1], largest_torque);
    row[kSquealBelow - 1] = below;
    row[kSquealAbove - 1] = above;
    any = any || std::isfinite(above);
  }
  return any;
}

std::vector<Mark> marks_of(const Motor& motor, double first, double last) {
  const auto request = [](Metric metric) { return MetricRequest{metric, Argument::none, 0}; };
  const std::array<MetricRequest, 7> requests = {
      request(Metric::stall_torque),        request(Metric::plateau_speed),
      request(Metric::speed_at_peak_power), request(Metric::torque_at_peak_power),
      request(Metric::peak_power),          request(Metric::no_load_speed),
      request(Metric::pull_out_torque)};
  const std::vector<MetricValue> values = evaluate(motor, requests);
  const auto has = [&](std::size_t i) { return values[i].status == MetricStatus::ok; };
  const auto text = [&](std::size_t i, const char* unit) {
    return studies::printed_engineering(values[i].value, unit, 3);
  };
  const double none = std::nan("");
  std::vector<Mark> marks;
  if (has(0)) {
    marks.push_back({"stall", 0, values[0].value, none, "stall " + text(0, "N.m"),
                     "left offset character 0.6, character -1"});
  }
  if (has(1) && values[1].value > 0) {
    const double torque = motor.operating_point(values[1].value).torque;
    // Under the plateau, beside the label of the stall torque or below it. Above the falling curve if the plateau is
    // shorter than the label.
    const double share = values[1].value / last;
    const char* place = share > 0.45  ? "right offset character -0.6, character -1"
                        : share > 0.3 ? "right offset character -0.6, character -2"
                                      : "left offset character 0.6, character 0.8";
    marks.push_back(
        {"plateau", values[1].value, torque, none, "plateau to " + text(1, "rad/s"), place});
  }
  if (has(4) && values[4].value > 0) {
    marks.push_back({"peak power", values[2].value, values[3].value, values[4].value,
                     "peak power " + text(4, "W") + " at " + text(2, "rad/s"),
                     "left offset character 0.7, character 0.5"});
  }
  if (has(5) && values[5].value > 0) {
    // Below the axis of zero torque, where the curve is on the other side of the mark; above it if the picture ends there.
    const char* place = last > 1.02 * values[5].value
                            ? "right offset character -0.6, character -0.7"
                            : "right offset character -4, character 0.7";
    marks.push_back({"no load", values[5].value, 0, none, "no load " + text(5, "rad/s"), place});
  }
  if (has(6)) {
    const double speed = motor.first_speed();
    marks.push_back(
        {"pull-out", speed, values[6].value, none,
         "pull-out " + text(6, "N.m") + " at " + studies::printed_engineering(speed, "rad/s", 3),
         "right offset character -0.6, character -1"});
  }
  std::erase_if(marks, [&](const Mark& m) { return m.speed < first || m.speed > last; });
  return marks;
}

std::string point_label(double x, double y, const std::string& text, const char* place) {
  return "set label " + text + " at first " + plot_number(x) + ", first " + plot_number(y) + " " +
         place +
         " font 'Arial,11' noenhanced front point pointtype 7 pointsize 0.6 linecolor rgb "
         "'#000000'\n";
}

std::string guides(const CurvePicture& picture) {
  std::string script;
  for (const Mark& mark : picture.marks) {
    if (mark.speed <= picture.first) continue;
    const std::string x = plot_number(mark.speed / picture.speed.divisor);
    script += "set arrow from first " + x + ", graph 0 to first " + x +
              ", graph 1 nohead back dashtype '.' linewidth 1 linecolor rgb '#999999'\n";
  }
  return script;
}

std::string series(const CurvePicture& picture, Column column, const studies::DisplayUnit& unit,
                   const char* name, const char* colour, const char* dash) {
  return "$curve using " + in_unit(kSpeed, picture.speed) + ":" + in_unit(column, unit) +
         " with lines linewidth 2 dashtype " + dash + " linecolor rgb '" + colour + "' title " +
         plot_text(name);
}

std::string torque_panel(const CurvePicture& picture) {
  std::string script = panel_place(0.93, 0.63, false) + guides(picture) +
                       "set offsets 0, 0, graph 0.06, 0\n" +
                       vertical_label("torque", picture.torque);
  for (const Mark& mark : picture.marks) {
    script += point_label(mark.speed / picture.speed.divisor, mark.torque / picture.torque.divisor,
                          plot_text(mark.power > 0 ? mark.name : mark.text), mark.place);
  }
  script += "plot ";
  if (picture.squeals) {
    script += "$curve using " + in_unit(kSpeed, picture.speed) + ":" +
              in_unit(kSquealBelow, picture.torque) + ":" + in_unit(kSquealAbove, picture.torque) +
              " with filledcurves fillstyle solid 0.25 noborder fillcolor rgb '" + colour::kBlue +
              "' title 'squeals', ";
  }
  return script + series(picture, kTorque, picture.torque, "", colour::kBlue, "1") + kEndOfPanel;
}

std::string power_panel(const CurvePicture& picture) {
  std::string script = panel_place(0.58, 0.33, false) + "set offsets 0, 0, graph 0.1, 0\n" +
                       vertical_label("power", picture.power);
  for (const Mark& mark : picture.marks) {
    if (!(mark.power > 0)) continue;
    script += point_label(mark.speed / picture.speed.divisor, mark.power / picture.power.divisor,
                          plot_text(mark.text), "center offset character 0, character 0.8");
  }
  script += "plot " + series(picture, kOutput, picture.power, "output", colour::kBlue, "1") + ", " +
            series(picture, kFriction, picture.power, "friction loss", colour::kVermilion, "2") +
            ", " + series(picture, kLayer, picture.power, "layer loss", colour::kGreen, "4");
  if (picture.damped) {
    script += ", " + series(picture, kStator, picture.power, "stator loss", colour::kOrange, "5");
  }
  return script + kEndOfPanel;
}

struct Share {
  Column below, above;
  const char* name;
  const char* colour;
};

std::string terminal_panel(const CurvePicture& picture) {
  constexpr Share kShares[] = {{kUpToOutput, kUpToOutput, "output", colour::kBlue},
                               {kUpToOutput, kUpToFriction, "friction", colour::kVermilion},
                               {kUpToFriction, kUpToLayer, "layer", colour::kGreen},
                               {kUpToLayer, kUpToStator, "stator", colour::kOrange},
                               {kUpToStator, kUpToCeramic, "ceramic", colour::kGrey},
                               {kUpToCeramic, kUpToDriver, "driver", colour::kPurple}};
  std::string script = panel_place(0.58, 0.33, false) + "set offsets 0, 0, graph 0.1, 0\n" +
                       vertical_label("electrical power", picture.power) + "plot ";
  for (const Share& share : kShares) {
    if (share.above == kUpToDriver && !picture.driver) continue;
    // The first begins on the axis: zero times its value, so that a missing value stays missing.
    const bool first = share.below == share.above;
    script += std::string(first ? "" : ", ") + "$curve using " + in_unit(kSpeed, picture.speed) +
              ":" + (first ? "(0)*" : "") + in_unit(share.below, picture.power) + ":" +
              in_unit(share.above, picture.power) +
              " with filledcurves fillstyle solid 0.75 noborder linecolor rgb '" + share.colour +
              "' title " + plot_text(share.name);
  }
  return script + kEndOfPanel;
}

std::string efficiency_panel(const CurvePicture& picture) {
  const studies::DisplayUnit percent{"%", 0.01};
  std::string script =
      panel_place(0.28, 0.075, true) + "set offsets 0, 0, 0, 0\n" +
      horizontal_label("speed", picture.speed) + vertical_label("efficiency", percent) +
      "\nset yrange [0:100]\nplot " +
      series(picture, kContactEfficiency, percent, "of the contact", colour::kBlue, "1");
  if (picture.terminals) {
    script += ", " + series(picture, kOverallEfficiency, percent, "of the motor at its terminals",
                            colour::kOrange, "5");
  } else if (picture.damped) {
    script += ", " +
              series(picture, kEfficiency, percent, "with the stator's loss", colour::kOrange, "5");
  }
  return script + "\n";
}

}  // namespace

std::string curve_plot(const studies::MotorFile& file, double first, double last) {
  const Motor motor(file.design);
  CurvePicture picture;
  picture.rows = rows_of(motor, first, last);
  picture.marks = marks_of(motor, first, last);
  picture.squeals = widen_squeals(picture.rows);
  picture.first = first;
  picture.last = last;
  picture.damped = modal_damping(file.design) > 0;
  picture.terminals = has_modal_data(file.design);
  picture.driver = file.design.driver.value_or(Driver{}).resistance != 0;
  picture.speed = studies::display_unit(last, "rad/s");
  picture.torque = studies::display_unit(largest(picture.rows, kTorque, kTorque), "N.m");
  picture.power =
      studies::display_unit(picture.terminals ? largest(picture.rows, kUpToOutput, kUpToDriver)
                                              : largest(picture.rows, kOutput, kStator),
                            "W");
  return plot_data("curve", picture.rows) + plot_style(plot_text(motor_title(file))) +
         "set multiplot\n" + "set xrange [" + plot_number(first / picture.speed.divisor) + ":" +
         plot_number(last / picture.speed.divisor) + "]\n" + torque_panel(picture) +
         (picture.terminals ? terminal_panel(picture) : power_panel(picture)) +
         efficiency_panel(picture) + "unset multiplot\n";
}

}  // namespace twum::cli
