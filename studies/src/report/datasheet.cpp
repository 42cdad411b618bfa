// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/datasheet.hpp>

#include "report/assets.hpp"
#include "report/page_parts.hpp"
#include "telling/html_parts.hpp"
#include "telling/renderers.hpp"
#include "telling/sheet_sections.hpp"
#include "text/checksum.hpp"

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/io/words.hpp>

#include <array>
#include <cstdio>

namespace twum::inline v0_1::studies {
namespace {

constexpr double kThird = 300;  // of the sheet, on which three charts stand side by side [pixels]

// Hash of the motor, independent of the format of its file.
std::string motor_hash(const MotorFile& motor) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx",
                static_cast<unsigned long long>(checksum(motor_text(motor))));
  return text.data();
}

std::string provenance(const MotorFile& motor, const std::string& source) {
  return "Computed by twum " + std::string(version()) +
         (source.empty() ? "" : " from " + printable(source, 120)) +
         ". Hash of the motor: " + motor_hash(motor) +
         ". All numbers are computed; none is measured.";
}

std::optional<LoadPoint> rated_load(const DatasheetOptions& options) {
  if (options.held_torque && !options.rated_speed)
    throw InputError("datasheet: a held torque needs a rated speed");
  if (options.held_torque)
    return LoadPoint{Argument::both, *options.rated_speed, *options.held_torque};
  if (options.rated_speed) return LoadPoint{Argument::speed, *options.rated_speed};
  return {};
}

}  // namespace

std::string datasheet_html(const MotorFile& file, const DatasheetOptions& options) {
  using namespace telling;
  const std::string name = harmless(file.name.empty() ? "motor" : printable(file.name, 80));
  return filled(
      assets::datasheet_page(), "<!--SHEET-->",
      "<title>" + name + " - data sheet</title>\n</head>\n<body>\n<main>\n<header>\n<h1>" + name +
          "</h1>\n<p>" + html(motor_phrase(file.design)) + "</p>\n</header>\n" +
          html(sheet_sections(Motor(file.design), rated_load(options)), "h2", kThird) + "<footer>" +
          harmless(provenance(file, options.source)) + "</footer>\n</main>\n</body>\n");
}

}  // namespace twum::inline v0_1::studies
