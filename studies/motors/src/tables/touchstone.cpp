// SPDX-License-Identifier: Apache-2.0
#include "tables/touchstone.hpp"

#include <twum/io/diagnostics.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

using Complex = std::complex<double>;

// "# kHz S RI R 50", in capital letters; what is left out has the value of the standard.
struct Options {
  double hertz{1e9};
  char parameter{'S'};
  std::string form{"MA"};
  double resistance{50};
  bool second_version{false};
};

// A line of version 2 such as "[Reference] 50".
bool is_keyword(std::string_view line) { return trimmed(line).starts_with('['); }

std::string in_capitals(std::string word) {
  for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return word;
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : std::string(line.substr(0, line.find('!'))) + " ") {
    if (c != ' ' && c != '\t' && c != '\r') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

bool is_touchstone_name(std::string_view name) {
  const std::string ending(name.substr(name.size() - std::min<std::size_t>(name.size(), 4)));
  return ending.size() == 4 && ending[0] == '.' && (ending[1] == 's' || ending[1] == 'S') &&
         std::isdigit(static_cast<unsigned char>(ending[2])) != 0 &&
         (ending[3] == 'p' || ending[3] == 'P');
}

// The options of a line, if it is one of options. Without a word it is one of the defaults.
std::optional<Options> options_of(std::string_view line) {
  static constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
      {{"HZ", 1}, {"KHZ", 1e3}, {"MHZ", 1e6}, {"GHZ", 1e9}}};
  if (!trimmed(line).starts_with('#')) return {};
  const std::vector<std::string> words = words_of(trimmed(line).substr(1));
  Options options;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string word = in_capitals(words[k]);
    const auto unit = std::ranges::find(kUnits, word, &std::pair<std::string_view, double>::first);
    if (unit != kUnits.end()) {
      options.hertz = unit->second;
    } else if (word == "S" || word == "Y" || word == "Z") {
      options.parameter = word.front();
    } else if (word == "RI" || word == "MA" || word == "DB") {
      options.form = word;
    } else if (word == "R" && k + 1 < words.size() && parse_number(words[k + 1])) {
      options.resistance = *parse_number(words[++k]);
    } else {
      return {};
    }
  }
  return options;
}

Complex number_of(const Options& options, double a, double b) {
  if (options.form == "RI") return {a, b};
  const double size = options.form == "DB" ? std::pow(10, a / 20) : a;
  return std::polar(size, b * std::numbers::pi / 180);
}

// Of a reflection S the admittance is Y = (1 - S) / (1 + S) / R; in version 1 Y and Z are in parts of 1/R and R.
Complex admittance_of(const Options& options, Complex value) {
  const double unit = options.second_version ? 1 : options.resistance;
  if (options.parameter == 'Y') return value / unit;
  if (options.parameter == 'Z') return 1.0 / (value * unit);
  return (1.0 - value) / (1.0 + value) / options.resistance;
}

class TouchstoneReader {
 public:
  explicit TouchstoneReader(const Source& source) : source_(source), diagnostics_(source) {}

  std::optional<MeasuredTable> read() {
    for (int number = 1; !source_.line(number).empty() || number <= kMostRemarks; ++number) {
      const std::string_view line = source_.line(number);
      if (trimmed(line).empty() || trimmed(line).starts_with('!')) continue;
      second_version_ = second_version_ || is_keyword(line);
      if (is_keyword(line)) continue;
      auto options = options_of(line);
      const bool remark = trimmed(line) == "#";  // of a plain table
      if (options && (named_ || !remark)) {
        options->second_version = second_version_;
        return table(*options, number);
      }
      if (named_) refuse_options(line, number);
      return {};
    }
    return {};
  }

 private:
  static constexpr int kMostRemarks = 200;  // lines above the options

  void refuse_options(std::string_view line, int number) {
    const bool given = trimmed(line).starts_with('#');
    diagnostics_.add({number, 1}, "",
                     given ? "options that a Touchstone file of one port does not have"
                           : "no line of options above the numbers of a Touchstone file",
                     "expected one such as '# kHz S RI R 50': unit of the frequency, S, Y or Z, "
                     "RI, MA or DB, reference");
    diagnostics_.throw_if_any();
  }

  MeasuredTable table(Options options, int header) {
    std::string text(static_cast<std::size_t>(header - 1), '\n');
    text += "frequency [Hz],conductance [S],susceptance [S]\n";
    const auto lines = static_cast<int>(std::ranges::count(source_.text(), '\n')) + 1;
    for (int number = header + 1; number <= lines; ++number) {
      const std::vector<std::string> words = words_of(source_.line(number));
      const bool keyword = is_keyword(source_.line(number));
      if (keyword && in_capitals(words.front()) == "[REFERENCE]" && words.size() > 1)
        options.resistance = parse_number(words[1]).value_or(options.resistance);
      if (!words.empty() && !keyword) add_row(options, words, number, text);
      text += '\n';
    }
    diagnostics_.throw_if_any();
    return {{source_.name(), std::move(text)}, kind(options)};
  }

  void add_row(const Options& options, const std::vector<std::string>& words, int line,
               std::string& text) {
    std::vector<double> values;
    for (const std::string& word : words) {
      if (const auto value = parse_number(word)) {
        values.push_back(*value);
        continue;
      }
      const NumberComplaint complaint = number_complaint(word);
      diagnostics_.add(
          {line, 1}, "",
          complaint.found.empty() ? quoted(word) + " is not a number" : complaint.found,
          complaint.found.empty() ? "expected a number, or leave out the line"
                                  : complaint.expected);
      return;
    }
    if (values.size() != 3) {
      diagnostics_.add({line, 1}, "",
                       counted(words.size(), "word") + " in a line of a Touchstone file",
                       "expected a frequency and two numbers of one port");
      return;
    }
    const Complex y = admittance_of(options, number_of(options, values[1], values[2]));
    if (!std::isfinite(y.real()) || !std::isfinite(y.imag())) {
      diagnostics_.add({line, 1}, "", "a short circuit, whose admittance is not finite",
                       "leave out the line");
      return;
    }
    for (const double value : {values[0] * options.hertz, y.real(), y.imag()})
      text += number_text(value) + ",";
    text.pop_back();
  }

  static std::string kind(const Options& options) {
    const std::string reference =
        " with a reference of " + rounded_text(options.resistance, 6) + " ohm";
    return "Touchstone, " + std::string(1, options.parameter) + "11" + reference +
           ", as conductance and susceptance";
  }

  const Source& source_;
  const bool named_{is_touchstone_name(source_.name())};  // by its ending
  Diagnostics diagnostics_;
  bool second_version_{false};
};

}  // namespace

std::optional<MeasuredTable> touchstone_table(const Source& source) {
  return TouchstoneReader(source).read();
}

}  // namespace twum::inline v0_1::motors
