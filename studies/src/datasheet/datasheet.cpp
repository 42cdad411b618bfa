// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/datasheet.hpp>

#include "datasheet/parts.hpp"
#include "report/assets.hpp"
#include "report/page_parts.hpp"
#include "text/checksum.hpp"

#include <twum/base/version.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/model_notes.hpp>

#include <array>
#include <cstdio>

namespace twum::studies {
namespace {

using namespace datasheet;

// Of heat, wear and driver what the motor file does not give.
std::string left_out(const MotorDesign& design) {
  std::string text = "Not in the model: ";
  if (!design.thermal) text += "heat and its effect on resonance and friction, ";
  text += design.wear ? "running in, " : "wear and running in, ";
  const Driver driver = design.driver.value_or(Driver{});
  const bool circuit = driver.inductance != 0 || driver.resistance != 0;
  return text + (circuit ? "and a rotor that bends."
                         : "a rotor that bends, and the driver's electronics.");
}

struct RatedPoint {
  std::string criterion;
  std::optional<OperatingPoint> point;
};

RatedPoint rated_of(const Motor& motor, const std::optional<double>& speed) {
  if (speed) return {"at the speed or load that was given", motor.operating_point(*speed)};
  const bool terminals = has_modal_data(motor.design());
  const Metric metric =
      terminals ? Metric::speed_at_max_overall_efficiency : Metric::speed_at_peak_power;
  const MetricValue at = evaluate(motor, {metric, Argument::none, 0});
  if (at.status != MetricStatus::ok) return {"none: this motor drives no load", {}};
  return {
      terminals ? "where the overall efficiency is largest" : "where the output power is largest",
      motor.operating_point(at.value)};
}

// Hash of the motor, independent of the format of its file.
std::string motor_hash(const MotorFile& motor) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx",
                static_cast<unsigned long long>(checksum(motor_text(motor))));
  return text.data();
}

std::string kind_of_motor(const MotorDesign& design) {
  const Stator& s = design.stator;
  const std::string drive = s.voltage ? "driven by " + printed_engineering(*s.voltage, "V") + " rms"
                                      : "with a wave of " + printed_engineering(s.amplitude, "m");
  return "Travelling wave ultrasonic motor with " + printed_engineering(s.wavelengths, "1") +
         " wavelengths, " + drive + " at " + printed_engineering(drive_frequency(design), "Hz");
}

std::string block(const std::string& look, const std::string& heading, const std::string& content) {
  if (content.empty()) return "";
  const std::string of = look.empty() ? "" : " class=\"" + look + "\"";
  return "<section" + of + ">\n<h2>" + heading + "</h2>\n" + content + "</section>\n";
}

std::string notes(const MotorDesign& design) {
  std::string text;
  for (ModelNote& note : model_notes_at_length(design)) {
    if (!note.text.empty() && note.text[0] >= 'a' && note.text[0] <= 'z') note.text[0] -= 'a' - 'A';
    text += "<li>" + escaped(note.text) + ".</li>\n";
  }
  return "<p>" + left_out(design) + "</p>\n" + (text.empty() ? "" : "<ul>\n" + text + "</ul>\n");
}

std::string provenance(const MotorFile& motor, const DatasheetOptions& options) {
  const std::string source =
      options.source.empty() ? "" : " from " + printable(options.source, 120);
  return element("footer", {},
                 "Computed by twum " + escaped(version()) + escaped(source) +
                     ". Hash of the motor: " + motor_hash(motor) +
                     ". All numbers are computed; none is measured.") +
         "\n";
}

}  // namespace

std::string datasheet_html(const MotorFile& file, const DatasheetOptions& options) {
  const Motor motor(file.design);
  const RatedPoint rated = rated_of(motor, options.rated_speed);
  const std::string name = escaped(file.name.empty() ? "motor" : printable(file.name, 80));
  const std::string body =
      "<title>" + name + " - data sheet</title>\n</head>\n<body>\n<main>\n<header>\n<h1>" + name +
      "</h1>\n<p>" + escaped(kind_of_motor(file.design)) + "</p>\n</header>\n" +
      block("wide", "Torque, power and efficiency", curves(motor, rated.point)) + "<div>\n" +
      block("", "Cross-section", section(file.design)) +
      block("", "Performance and limits", list(performance(motor))) + "</div>\n<div>\n" +
      block("", "Rated point",
            "<p>" + rated.criterion + "</p>\n" +
                (rated.point ? list(rated_point(file.design, *rated.point)) : "")) +
      block("", "Electrical", list(electrical(motor))) + "</div>\n" +
      block("wide parameters", "Parameters", list(parameters(file.design))) +
      block("wide", "What to know", notes(file.design)) + provenance(file, options) +
      "</main>\n</body>\n";
  return filled(assets::datasheet_page(), "<!--SHEET-->", body);
}

}  // namespace twum::studies
