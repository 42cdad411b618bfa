// SPDX-License-Identifier: Apache-2.0
#include "tables/instrument_headings.hpp"

#include "tables/heading.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

// What analysers call a quantity: small letters, without blanks and signs between words.
struct Vocabulary {
  std::string_view quantity;
  std::string_view unit;  // where the heading gives none; empty: it has to
  std::vector<std::string_view> words;
};

const std::vector<Vocabulary>& vocabulary() {
  static const std::vector<Vocabulary> list{
      {"frequency", "Hz", {"frequency", "freq", "f", "frequenz"}},
      {"conductance", "S", {"g", "gp", "conductance", "re(y)", "real(y)", "y'"}},
      {"susceptance", "S", {"b", "bp", "susceptance", "im(y)", "imag(y)", "y''"}},
      {"resistance",
       "ohm",
       {"r", "rs", "esr", "resistance", "re(z)", "real(z)", "z'", "zreal", "zre"}},
      {"reactance", "ohm", {"x", "xs", "reactance", "im(z)", "imag(z)", "z''", "zimag", "zim"}},
      {"impedance",
       "ohm",
       {"|z|", "z", "impedance", "mag(z)", "abs(z)", "zmod", "zabs", "magnitude", "modz"}},
      {"impedance_phase",
       "",
       {"phase", "theta", "phi", "angle", "phase(z)", "arg(z)", "zphase", "phasez", "thetaz",
        "zphz", "impedancephase", "\xCE\xB8", "\xCE\xB8z", "\xCF\x86", "\xCE\xB8(z)"}}};
  return list;
}

struct Pair {
  std::string_view first, second, name;
};
constexpr std::array<Pair, 3> kPairs{{{"conductance", "susceptance", "G and B"},
                                      {"resistance", "reactance", "R and X"},
                                      {"impedance", "impedance_phase", "|Z| and phase"}}};

std::string plain_word(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (std::string_view(" \t_-.:").find(c) != std::string_view::npos) continue;
    word += c;
  }
  return in_small_letters(word);
}

struct InstrumentHeading {
  std::string_view quantity;
  std::string unit;  // empty: not given, and not evident
};

// "Phase-deg" and "Z_ohm": the unit behind the last sign between words.
std::vector<Heading> instrument_forms(std::string_view text) {
  std::vector<Heading> forms = heading_forms(text);
  for (const char sign : {'-', '_', ' ', ','}) {
    const std::size_t at = text.rfind(sign);
    if (at == std::string_view::npos || at + 1 == text.size()) continue;
    const std::string_view unit = trimmed(text.substr(at + 1));
    if (names_unit(unit)) forms.push_back({trimmed(text.substr(0, at)), unit, true});
  }
  return forms;
}

std::string spelled_unit(std::string_view unit);

// A unit in capital letters between parentheses, which heading_forms() does not know.
void add_capitals(std::vector<Heading>& forms, std::string_view text) {
  const std::size_t open = text.rfind('(');
  if (open == std::string_view::npos || !text.ends_with(')')) return;
  const std::string_view unit = trimmed(text.substr(open + 1, text.size() - open - 2));
  if (names_unit(spelled_unit(unit))) forms.push_back({trimmed(text.substr(0, open)), unit, true});
}

std::string spelled_unit(std::string_view unit) {
  const std::string word = plain_word(unit);
  if (word == "hz" || word == "khz" || word == "mhz")
    return (word.size() == 2 ? "" : word.front() == 'k' ? "k" : "M") + std::string("Hz");
  if (word == "ohm" || word == "ohms") return "ohm";
  if (word == "deg" || word == "degree" || word == "degrees") return "deg";
  return std::string(unit);
}

std::optional<InstrumentHeading> instrument_heading(std::string_view text) {
  std::vector<Heading> forms = instrument_forms(trimmed(text));
  add_capitals(forms, trimmed(text));
  for (const Heading& form : forms)
    for (const Vocabulary& one : vocabulary())
      if (std::ranges::find(one.words, plain_word(form.name)) != one.words.end())
        return InstrumentHeading{one.quantity,
                                 form.has_unit ? spelled_unit(form.unit) : std::string(one.unit)};
  return {};
}

}  // namespace

bool is_instrument_heading(std::string_view heading) {
  return instrument_heading(heading).has_value();
}

std::string name_instrument_columns(std::vector<ColumnHeading>& headings) {
  const bool ours = std::ranges::any_of(headings, [](const ColumnHeading& heading) {
    return !heading.chosen && is_reading_heading(heading.text);
  });
  if (ours) return {};
  std::vector<std::optional<InstrumentHeading>> found;
  for (const ColumnHeading& heading : headings)
    found.push_back(heading.chosen ? std::nullopt : instrument_heading(heading.text));
  const auto place = [&](std::string_view quantity) {
    return std::ranges::find_if(found,
                                [&](const auto& one) { return one && one->quantity == quantity; });
  };
  if (place("frequency") == found.end()) return {};
  const auto pair = std::ranges::find_if(kPairs, [&](const Pair& one) {
    return place(one.first) != found.end() && place(one.second) != found.end();
  });
  if (pair == kPairs.end()) return {};
  for (std::size_t k = 0; k < headings.size(); ++k) headings[k].unused = !headings[k].chosen;
  for (const std::string_view quantity :
       {std::string_view("frequency"), pair->first, pair->second}) {
    const auto one = place(quantity);
    ColumnHeading& heading = headings[static_cast<std::size_t>(one - found.begin())];
    heading.text = std::string(quantity) + ((*one)->unit.empty() ? "" : " [" + (*one)->unit + "]");
    heading.unused = false;
  }
  return "an impedance analyser's table of " + std::string(pair->name);
}

}  // namespace twum::inline v0_1::motors
