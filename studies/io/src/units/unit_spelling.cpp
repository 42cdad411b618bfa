// SPDX-License-Identifier: Apache-2.0
#include "units/unit_spelling.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

// Signs for a product, the ohm sign, and the minus sign of typographers.
constexpr std::array<Pair, 7> kSigns{{{"\xE2\x8B\x85", "."},         // U+22C5
                                      {"\xC2\xB7", "."},             // U+00B7
                                      {"\xE3\x83\xBB", "."},         // U+30FB
                                      {"\xE2\x88\x99", "."},         // U+2219
                                      {"\xE2\x80\xA2", "."},         // U+2022
                                      {"\xE2\x84\xA6", "\xCE\xA9"},  // U+2126
                                      {"\xE2\x88\x92", "-"}}};       // U+2212

// Superscripts, which are a power where they follow each other.
constexpr std::array<Pair, 12> kSuperscripts{{{"\xE2\x81\xBB", "-"},
                                              {"\xE2\x81\xBA", "+"},
                                              {"\xE2\x81\xB0", "0"},
                                              {"\xC2\xB9", "1"},
                                              {"\xC2\xB2", "2"},
                                              {"\xC2\xB3", "3"},
                                              {"\xE2\x81\xB4", "4"},
                                              {"\xE2\x81\xB5", "5"},
                                              {"\xE2\x81\xB6", "6"},
                                              {"\xE2\x81\xB7", "7"},
                                              {"\xE2\x81\xB8", "8"},
                                              {"\xE2\x81\xB9", "9"}}};

constexpr std::array<Pair, 3> kWholeUnits{{{"r/min", "rpm"}, {"U/min", "rpm"}, {"r/s", "rps"}}};

template <std::size_t N>
const Pair* begins_with(const std::array<Pair, N>& pairs, std::string_view text) {
  const auto found =
      std::ranges::find_if(pairs, [&](const Pair& pair) { return text.starts_with(pair.first); });
  return found == pairs.end() ? nullptr : &*found;
}

bool is_electrical(std::string_view unit) { return unit.ends_with('V') || unit.ends_with('A'); }

// The unit of volts or amperes before one of the endings, written at once, or behind a blank or an underscore.
std::string_view before_ending(std::string_view unit, std::string_view ending) {
  if (!unit.ends_with(ending)) return {};
  unit.remove_suffix(ending.size());
  if (unit.ends_with('_')) unit.remove_suffix(1);
  unit = trimmed(unit);
  return is_electrical(unit) ? unit : std::string_view();
}

}  // namespace

std::string usual_spelling(std::string_view unit) {
  if (const Pair* whole = begins_with(kWholeUnits, unit); whole && whole->first == unit)
    return std::string(whole->second);
  if (const std::string_view rms = before_ending(unit, "rms"); !rms.empty()) unit = rms;
  std::string text;
  bool power = false;
  while (!unit.empty()) {
    const Pair* superscript = begins_with(kSuperscripts, unit);
    const Pair* sign = begins_with(kSigns, unit);
    if (superscript != nullptr && !power) text += '^';
    power = superscript != nullptr;
    const Pair* known = power ? superscript : sign;
    text += known != nullptr ? known->second : unit.substr(0, 1);
    unit.remove_prefix(known != nullptr ? known->first.size() : 1);
  }
  return text;
}

std::optional<PeakUnit> peak_unit(std::string_view unit) {
  constexpr double kSine = std::numbers::sqrt2;  // peak over rms
  for (const std::string_view ending : {"pk-pk", "p-p", "pkpk", "pp"})
    if (const auto base = before_ending(unit, ending); !base.empty())
      return PeakUnit{base, 1 / (2 * kSine)};
  for (const std::string_view ending : {"peak", "pk", "p"})
    if (const auto base = before_ending(unit, ending); !base.empty())
      return PeakUnit{base, 1 / kSine};
  return {};
}

}  // namespace twum::inline v0_1::io
