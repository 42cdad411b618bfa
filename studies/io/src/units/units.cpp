// SPDX-License-Identifier: Apache-2.0
#include <twum/io/units.hpp>

#include "text/utf8.hpp"
#include "units/unit_definitions.hpp"
#include "units/unit_spelling.hpp"
#include "units/unit_system.hpp"

#include <twum/io/dimension.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {
namespace {

// Usual units, suggested for mistyped ones.
constexpr std::array<std::string_view, 49> kUsualUnits{
    "nm",   "um",     "mm",  "cm",    "m",       "Pa",     "kPa",    "MPa",    "GPa",    "N",
    "mN",   "kN",     "N.m", "mN.m",  "N.cm",    "rpm",    "rad/s",  "Hz",     "kHz",    "MHz",
    "W",    "mW",     "kW",  "W/m^2", "kW/m^2",  "W/cm^2", "W/mm^2", "kg/m^3", "g/cm^3", "N.s/m",
    "Pa.s", "Pa.s^2", "deg", "rad",   "rev/min", "N/mm^2", "bar",    "s",      "ms",     "%",
    "ohm",  "mH",     "nF",  "N/V",   "1/s",     "K",      "W/K",    "J/K",    "ppm"};

bool dimensionless(std::string_view unit) { return unit == "1"; }

std::string article(std::string_view noun) {
  const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(noun);
}

// "expected a length [m] such as '0.3 mm'"
std::string expectation(std::span<const Expected> expected) {
  std::string text = "expected ";
  for (const Expected& one : expected) {
    if (&one != expected.data()) text += " or ";
    text += dimension_phrase(one.unit);
    if (!one.example.empty()) text += " such as '" + std::string(one.example) + "'";
  }
  return text;
}

// The dimension of a known unit: "a force [N]".
std::string phrase_of_unit(std::string_view unit) {
  if (factor_to(unit, "1")) return "a number without dimension";
  for (const NamedDimension& named : kDimensions) {
    if (factor_to(unit, named.unit)) return dimension_phrase(named.unit);
  }
  return "something in " + quoted(unit);
}

bool fits_any(std::string_view unit, std::span<const Expected> expected) {
  return std::any_of(expected.begin(), expected.end(),
                     [&](const Expected& one) { return factor_to(unit, one.unit).has_value(); });
}

// Units of data sheets and workshops, and their names here.
std::string_view usual_unit_for(std::string_view unit) {
  static constexpr std::pair<std::string_view, std::string_view> kSaid[] = {
      {"1/min", "rpm"}, {"min^-1", "rpm"}, {"min-1", "rpm"},     {"tr/min", "rpm"}, {"/min", "rpm"},
      {"micron", "um"}, {"microns", "um"}, {"N/sqmm", "N/mm^2"}, {"Nm", "N.m"}};
  for (const auto& [said, usual] : kSaid) {
    if (said == unit) return usual;
  }
  return {};
}

// expectation(), then the unit that may be meant, if there is one.
std::string expectation(std::span<const Expected> expected, std::string_view meant) {
  const std::string hint =
      meant.empty() ? std::string() : "; did you mean '" + std::string(meant) + "'?";
  return expectation(expected) + hint;
}

std::string expectation_instead_of(std::string_view unit, std::span<const Expected> expected) {
  const std::string_view usual = usual_unit_for(unit);
  const bool fits = !usual.empty() && fits_any(usual, expected);
  return expectation(expected, fits ? usual : std::string_view());
}

// A usual unit of the right dimension that the text may stand for; empty if there is none.
std::string_view usual_unit_near(std::string_view unit, std::span<const Expected> expected) {
  const std::string_view known = usual_unit_for(unit);
  if (!known.empty() && fits_any(known, expected)) return known;
  std::vector<std::string_view> candidates;
  for (const std::string_view usual : kUsualUnits) {
    // Spelling first, which takes a hundredth of the time of asking for dimensions.
    if (nearest(unit, std::span(&usual, 1)).empty()) continue;
    if (fits_any(usual, expected)) candidates.push_back(usual);
  }
  return nearest(unit, candidates);
}

// The scale of a unit to the first expected dimension that it has.
struct Match {
  Scale scale;
  std::size_t which;
};

// Scale of a temperature in degC. @throws ValueError where none with its offset is expected
Match match_celsius(std::string_view whole, std::size_t at, std::span<const Expected> expected) {
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (expected[i].absolute) return {Scale::celsius(), i};
  const bool difference = std::any_of(expected.begin(), expected.end(),
                                      [](const Expected& one) { return one.unit == "K"; });
  if (difference)
    throw ValueError(quoted(whole) + " is an absolute temperature",
                     "expected a difference of temperatures in K such as '40 K'", at);
  throw ValueError(quoted(whole) + " is a temperature", expectation(expected), at);
}

// Voltages and currents are rms. Of a sine the rms value is told; of another wave it is not known.
void refuse_peak(std::string_view unit, std::string_view whole, std::size_t at,
                 std::span<const Expected> expected) {
  const auto peak = peak_unit(unit);
  if (!peak || !is_unit(peak->base) || !fits_any(peak->base, expected)) return;
  const auto number = parse_number(trimmed(whole.substr(0, at)));
  const std::string base(peak->base);
  throw ValueError(
      quoted(whole) + " is a peak value, but voltages and currents are rms",
      number ? "of a sine write " + quoted(rounded_text(*number * peak->rms, 4) + " " + base)
             : "of a sine multiply by " + rounded_text(peak->rms, 4) + " and write " + quoted(base),
      at);
}

Match match_unit(std::string_view unit, std::string_view whole, std::size_t at,
                 std::span<const Expected> expected) {
  if (is_celsius(unit)) return match_celsius(whole, at, expected);
  if (const std::string wrong = unit_form_complaint(unit); !wrong.empty()) {
    throw ValueError(quoted(whole) + ": " + quoted(unit) + " " + wrong,
                     expectation_instead_of(unit, expected), at);
  }
  if (!is_unit(unit)) {
    refuse_peak(unit, whole, at, expected);
    throw ValueError(quoted(whole) + ": unknown unit " + quoted(unit),
                     expectation(expected, usual_unit_near(unit, expected)), at);
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (const auto factor = factor_to(unit, expected[i].unit)) return {Scale(*factor), i};
  }
  throw ValueError(quoted(whole) + " is " + phrase_of_unit(unit),
                   expectation_instead_of(unit, expected), at);
}

// A comma is the decimal sign of some and separates the thousands of others. Where both readings are possible, both are offered.
void refuse_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  const std::size_t end = std::min(text.find_first_not_of("+-0123456789.,"), text.size());
  if (comma >= end) return;  // no part of a number
  const NumberComplaint complaint = number_complaint(text.substr(0, end), text.substr(end));
  if (!complaint.found.empty()) throw ValueError(complaint.found, complaint.expected, comma);
}

[[noreturn]] void no_number(std::string_view text, std::span<const Expected> expected) {
  if (text.empty()) throw ValueError("empty", expectation(expected));
  refuse_comma(text);
  throw ValueError(quoted(text) + " is not a number", expectation(expected));
}

}  // namespace

Scale::Scale(double factor) : factor_(factor), power_() {
  const double power = std::round(std::log10(factor));
  // UDUNITS multiplies prefixes and powers one by one; a few roundings of 1e-16 each.
  if (std::abs(power) < 300 && std::abs(factor / std::pow(10.0, power) - 1) < 4e-15) {
    power_ = static_cast<int>(power);
    factor_ = std::pow(10.0, power);
  }
}

Scale Scale::celsius() {
  Scale scale;
  scale.power_.reset();
  scale.offset_ = 273.15;
  return scale;
}

std::optional<double> Scale::read(std::string_view number) const noexcept {
  if (power_) return parse_decimal(number, *power_);
  const auto value = parse_number(number);
  if (!value || !std::isfinite(*value * factor_)) return {};
  return *value * factor_ + offset_;
}

Quantity parse_quantity(std::string_view text, std::span<const Expected> expected) {
  text = trimmed(text);
  const std::size_t length = number_prefix(text);
  if (length == 0) no_number(text, expected);
  const std::string_view number = text.substr(0, length);
  const std::string_view unit = trimmed(text.substr(length));
  if (!unit.empty() && unit.front() == ',') no_number(text, expected);

  Match match{Scale(), 0};
  if (unit.empty()) {
    while (match.which < expected.size() && !dimensionless(expected[match.which].unit))
      ++match.which;
    if (match.which == expected.size()) {
      throw ValueError(quoted(text) + " has no unit", expectation(expected), length);
    }
  } else {
    match = match_unit(unit, text, text.size() - unit.size(), expected);
  }
  const auto value = match.scale.read(number);
  if (!value)
    throw ValueError(quoted(text) + " is beyond the range of numbers", expectation(expected));
  return {*value, match.which};
}

Measure parse_measure(std::string_view text) {
  text = trimmed(text);
  const std::string_view unit = trimmed(text.substr(number_prefix(text)));
  if (unit.empty()) return {parse_quantity(text, {"1", ""}), {}};
  if (is_celsius(unit))
    throw ValueError(quoted(text) + " is an absolute temperature",
                     "compare it with a metric of a temperature alone, or write K",
                     text.size() - unit.size());
  if (!unit_form_complaint(unit).empty() || !is_unit(unit)) {
    const std::string_view meant = nearest(unit, kUsualUnits);
    throw ValueError(quoted(text) + ": unknown unit " + quoted(unit),
                     meant.empty() ? "expected a unit such as 'N.m' or 'W/m^2'"
                                   : "did you mean '" + std::string(meant) + "'?",
                     text.size() - unit.size());
  }
  constexpr int kMostPower = 20;  // limit of the powers; beyond 255 UDUNITS cannot represent them
  for (const int power : base_powers(unit)) {
    if (std::abs(power) > kMostPower)
      throw ValueError(quoted(text) + ": " + quoted(unit) + " is of too high a power",
                       "expected a unit such as 'N.m' or 'W/m^2'", text.size() - unit.size());
  }
  const Dimension dimension = Dimension(unit);
  return {parse_quantity(text, {dimension.unit(), ""}), dimension};
}

double parse_quantity(std::string_view text, const Expected& expected) {
  return parse_quantity(text, std::span(&expected, 1)).value;
}

Scale parse_unit(std::string_view unit, const Expected& expected) {
  unit = trimmed(unit);
  if (unit.empty() || unit == "1" || unit == "-") {
    if (dimensionless(expected.unit)) return {};
    throw ValueError(quoted(unit) + " is not a unit", expectation(std::span(&expected, 1)));
  }
  return match_unit(unit, unit, 0, std::span(&expected, 1)).scale;
}

bool is_celsius(std::string_view unit) { return unit == "degC" || unit == "\xC2\xB0\x43"; }

std::string_view dimension_name(std::string_view si_unit) {
  const auto* found = std::find_if(std::begin(kDimensions), std::end(kDimensions),
                                   [&](const NamedDimension& d) { return d.unit == si_unit; });
  return found == std::end(kDimensions) ? std::string_view() : found->name;
}

std::string dimension_phrase(std::string_view si_unit) {
  if (dimensionless(si_unit)) return "a number without unit";
  const std::string bracketed = " [" + std::string(si_unit) + "]";
  const std::string_view name = dimension_name(si_unit);
  return (name.empty() ? std::string("a quantity") : article(name)) + bracketed;
}

}  // namespace twum::inline v0_1::io
