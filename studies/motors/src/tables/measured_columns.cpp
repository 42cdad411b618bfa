// SPDX-License-Identifier: Apache-2.0
#include "tables/measured_columns.hpp"

#include "tables/parameter_heading.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <optional>

namespace twum::inline v0_1::motors {
namespace {

constexpr std::string_view kDeviation = "_sd", kTime = "time";

std::optional<Reading> reading_of(std::string_view name) {
  if (const auto part = find_circuit_part(name)) return *part;
  const auto metric = name == "torque" ? Metric::torque_at : find_metric(name);
  if (!metric) return {};
  return MetricRequest{*metric, info(*metric).argument, 0};
}

class ColumnReader {
 public:
  ColumnReader(const std::vector<ColumnHeading>& headings, Diagnostics& diagnostics)
      : headings_(headings), diagnostics_(diagnostics) {
    has_speed_ = has("speed");
    has_timed_ = std::ranges::any_of(
        metric_table(), [&](const MetricInfo& row) { return row.timed && has(row.name); });
    for (const ColumnHeading& heading : headings) parts_.push_back(known_form(heading.text));
  }

  std::vector<MeasuredColumn> read(SourceMark begin) {
    for (std::size_t i = 0; i < headings_.size(); ++i) add(headings_[i], parts_[i]);
    check_repeats();
    check_alternatives();
    if (unknown_) return std::move(columns_);  // the unknown column may be the missing one
    for (MeasuredColumn& column : columns_) {
      if (column.role == ColumnRole::deviation) find_owner(column);
      if (column.role == ColumnRole::measured) find_argument(column, begin);
    }
    check_measured(begin);
    check_weights();
    return std::move(columns_);
  }

 private:
  bool has(std::string_view name) const {
    return std::ranges::any_of(headings_, [&](const auto& heading) {
      return std::ranges::any_of(heading_forms(heading.text),
                                 [&](const Heading& form) { return form.name == name; });
    });
  }

  // The first reading of a heading whose name is known, or the usual one.
  Heading known_form(const std::string& text) const {
    const std::vector<Heading> forms = heading_forms(text);
    const auto known = std::ranges::find_if(
        forms, [&](const Heading& form) { return column_of(std::string(form.name)).has_value(); });
    return known == forms.end() ? forms.front() : *known;
  }

  void add(const ColumnHeading& heading, const Heading& parts) {
    std::optional<MeasuredColumn> column = column_of(std::string(parts.name));
    if (heading.unused || (!column && !is_mistyped(parts.name))) {
      MeasuredColumn& unused = columns_.emplace_back();
      unused.role = ColumnRole::unused;
      unused.name = heading.text;
      unused.mark = heading.mark;
      return;
    }
    if (column && column->role == ColumnRole::parameter && is_bare_letter(parts)) {
      const ParameterInfo& row = info(column->parameter);
      diagnostics_.add(heading.mark, "", bare_letter_words(parts.name, row),
                       bare_letter_advice(row));
      unknown_ = true;
    }
    if (!column) {
      unknown_ = true;
      diagnostics_.add(heading.mark, "", "unknown column " + quoted(heading.text),
                       did_you_mean(parts.name, known_names()));
      columns_.emplace_back();
      return;
    }
    column->name = parts.name;
    column->unit = parts.unit;
    column->mark = heading.mark;
    column->reversed = heading.reversed;
    try {
      if (parts.has_unit)
        column->scale =
            parse_unit(parts.unit, {column->expected, example_of(*column), is_absolute(*column)});
    } catch (const ValueError& error) {
      diagnostics_.add(heading.mark, column->name, error.found(), error.expected());
    }
    columns_.push_back(std::move(*column));
  }

  // A standard deviation is a difference.
  static bool is_absolute(const MeasuredColumn& column) {
    if (column.role == ColumnRole::parameter) return info(column.parameter).absolute;
    const auto* request = std::get_if<MetricRequest>(&column.reading);
    return column.role == ColumnRole::measured && request != nullptr &&
           info(request->metric).absolute;
  }

  static std::string_view example_of(const MeasuredColumn& column) {
    if (column.role == ColumnRole::parameter) return info(column.parameter).example;
    if (column.expected == "N.m")
      return column.role == ColumnRole::deviation ? "5 mN.m" : "0.5 N.m";
    if (column.expected == "rad/s") return "100 rpm";
    if (column.role == ColumnRole::time) return "10 min";
    return "";
  }

  std::optional<MeasuredColumn> column_of(const std::string& name) const {
    MeasuredColumn column;
    if (name == "weight") {
      column.role = ColumnRole::weight;
      column.expected = "1";
      return column;
    }
    if (name == "speed" || (name == "torque" && !has_speed_)) {
      column.role = ColumnRole::argument;
      column.argument = name == "speed" ? Argument::speed : Argument::torque;
      column.expected = name == "speed" ? "rad/s" : "N.m";
      return column;
    }
    if (has_timed_ &&
        in_small_letters(name) == kTime) {  // otherwise a logger's, which says nothing of the motor
      column.role = ColumnRole::time;
      column.expected = "s";
      return column;
    }
    if (name.ends_with(kDeviation) && has(name.substr(0, name.size() - kDeviation.size()))) {
      const auto owner = column_of(name.substr(0, name.size() - kDeviation.size()));
      if (owner) column.expected = owner->expected;
      column.role = ColumnRole::deviation;
      return owner ? std::optional(column) : std::nullopt;
    }
    if (name == "torque_sd") {  // of a column that is missing
      column.role = ColumnRole::deviation;
      column.expected = "N.m";
      return column;
    }
    if (const auto reading = reading_of(name)) {
      column.reading = *reading;
      column.expected = unit_of(*reading);
      return column;
    }
    const auto parameter = parameter_named(name);
    if (!parameter) return {};
    column.role = ColumnRole::parameter;
    column.parameter = *parameter;
    column.expected = info(*parameter).unit;
    return column;
  }

  // A name with a letter too many, too few, or wrong. It may be meant, so that it is not merely unused.
  static bool is_mistyped(std::string_view name) {
    constexpr std::size_t kLongName = 6;  // letters of a name in which two may be wrong
    const std::vector<std::string_view> known = known_names();
    const std::string_view near = nearest(name, known);
    const int most = near.size() > kLongName ? 2 : 1;
    return !near.empty() && (near.size() == name.size() || edit_distance(name, near, most) <= most);
  }

  static std::vector<std::string_view> known_names() {
    std::vector<std::string_view> names{"speed", "torque", "weight", "torque_sd"};
    for (const MetricInfo& row : metric_table()) names.push_back(row.name);
    for (std::size_t part = 0; part < kCircuitParts; ++part)
      names.push_back(info(static_cast<CircuitPart>(part)).name);
    for (const ParameterInfo& row : parameter_table()) names.push_back(row.name);
    return names;
  }

  void check_repeats() {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const MeasuredColumn& a = columns_[i];
        const MeasuredColumn& b = columns_[j];
        const bool unused = a.role == ColumnRole::unused && b.role == ColumnRole::unused;
        if (a.name.empty() || a.name != b.name || unused) continue;
        diagnostics_.add({a.mark, a.name, "the column is given twice", "leave one of them out",
                          b.mark, "first given here"});
      }
    }
  }

  // Two parameters of which a motor has one.
  void check_alternatives() {
    for (const MeasuredColumn& a : columns_)
      for (const MeasuredColumn& b : columns_) {
        const bool both =
            a.role == ColumnRole::parameter && b.role == ColumnRole::parameter && &b < &a;
        if (!both || info(a.parameter).alternative != b.parameter) continue;
        diagnostics_.add({a.mark, a.name, "cannot be set together with " + quoted(b.name),
                          "leave out one of the two columns", b.mark, "set here"});
      }
  }

  void find_owner(MeasuredColumn& column) {
    const std::string name = column.name.substr(0, column.name.size() - kDeviation.size());
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].name == name) column.of = k;
    if (columns_[column.of].name == name && columns_[column.of].role != ColumnRole::measured)
      diagnostics_.add(column.mark, column.name, quoted(name) + " is set, not measured",
                       "give standard deviations of measured columns");
  }

  // The argument that a metric of a point is read at.
  void find_argument(MeasuredColumn& column, SourceMark begin) {
    auto* request = std::get_if<MetricRequest>(&column.reading);
    if (request == nullptr || request->argument == Argument::none) return;
    const Argument takes = request->argument;
    if (takes == Argument::both) {
      diagnostics_.add(column.mark, column.name,
                       "belongs to a torque that the drive holds at a speed",
                       "leave it out: a table gives one of the two for each point");
      return;
    }
    const bool torque = has("torque") && !has_speed_;
    if (has_speed_ && takes != Argument::torque)
      request->argument = Argument::speed;
    else if (torque && takes != Argument::speed)
      request->argument = Argument::torque;
    else if (takes == Argument::torque)
      diagnostics_.add(column.mark, column.name, "read at a torque that no column gives",
                       has_speed_ ? "leave out 'speed'; with it, 'torque' is a measured value"
                                  : "expected a column such as 'torque [N.m]'");
    else
      diagnostics_.add(begin, "", "no column 'speed'", "expected one such as 'speed [rpm]'");
  }

  void check_measured(SourceMark begin) {
    const auto is_measured = [](const auto& c) { return c.role == ColumnRole::measured; };
    if (std::ranges::any_of(columns_, is_measured)) return;
    const bool numbers = std::ranges::any_of(
        headings_, [](const auto& one) { return parse_number(one.text).has_value(); });
    if (numbers && diagnostics_.count() > 0) return;  // said already
    if (numbers)
      diagnostics_.add(begin, "", "numbers where the headings should be",
                       "add a line with a heading for each column above the numbers");
    else if (headings_.size() == 1 && is_of_words(headings_.front().text))
      diagnostics_.add(begin, "", "one column, " + quoted(headings_.front().text),
                       "separate columns by commas, semicolons or tabs");
    else if (has_frequency())
      diagnostics_.add(begin, "", "no column with measured values",
                       missing("impedance",
                               "beside a frequency expected |Z| and phase, R and X, or G and B, "
                               "such as 'impedance [ohm]' and 'impedance_phase [deg]'"));
    else if (has_speed_)
      diagnostics_.add(begin, "", "no column 'torque'",
                       missing("torque", "expected one such as 'torque [N.m]'"));
    else if (has("torque"))
      diagnostics_.add(begin, "", "no column 'speed'",
                       missing("speed", "expected one such as 'speed [rpm]'"));
    else
      diagnostics_.add(begin, "", "no column with measured values",
                       missing("torque",
                               "expected one such as 'torque [N.m]' together with 'speed [rpm]', "
                               "or 'no_load_speed [rpm]'"));
  }

  // Several words: more than a name with a unit.
  static bool is_of_words(std::string_view heading) {
    return std::ranges::count(trimmed(heading_forms(heading).front().name), ' ') > 0;
  }

  static bool is_frequency(std::string_view heading) {
    return in_small_letters(trimmed(heading)).starts_with("freq");
  }

  bool has_frequency() const {
    return std::ranges::any_of(headings_, [](const auto& one) { return is_frequency(one.text); });
  }

  // What to do about a column that is not there; one with another heading may be it.
  std::string missing(const std::string& quantity, const std::string& expected) const {
    const auto other = std::ranges::find_if(columns_, [](const MeasuredColumn& column) {
      return column.role == ColumnRole::unused && !is_frequency(column.name);
    });
    if (other == columns_.end()) return expected;
    return expected + "; if another heading stands for it, say so in the study: columns: {" +
           quantity + ": " + quoted(other->name) + "}";
  }

  void check_weights() {
    const MeasuredColumn* weight = nullptr;
    const MeasuredColumn* deviation = nullptr;
    std::size_t measured = 0;
    for (const MeasuredColumn& column : columns_) {
      if (column.role == ColumnRole::weight) weight = &column;
      if (column.role == ColumnRole::deviation) deviation = &column;
      measured += column.role == ColumnRole::measured ? 1 : 0;
    }
    if (weight == nullptr) return;
    if (deviation != nullptr)
      diagnostics_.add({deviation->mark, deviation->name, "weights and standard deviations",
                        "give one of the two", weight->mark, "weights given here"});
    else if (measured > 1)
      diagnostics_.add(weight->mark, weight->name, "weights of several columns",
                       "give standard deviations, such as 'torque_sd [N.m]'");
  }

  const std::vector<ColumnHeading>& headings_;
  std::vector<Heading> parts_;  // of each heading
  Diagnostics& diagnostics_;
  bool has_speed_{false};
  bool has_timed_{false};  // a column of temperatures that may be read on the way
  bool unknown_{false};
  std::vector<MeasuredColumn> columns_;
};

}  // namespace

std::vector<MeasuredColumn> measured_columns(const std::vector<ColumnHeading>& headings,
                                             SourceMark begin, Diagnostics& diagnostics) {
  return ColumnReader(headings, diagnostics).read(begin);
}

bool is_reading_heading(std::string_view heading) {
  return std::ranges::any_of(heading_forms(heading),
                             [](const Heading& form) { return reading_of(form.name).has_value(); });
}

namespace {

bool is_measured_name(std::string_view name) {
  return reading_of(name) || name == "speed" || name == "weight" || parameter_named(name);
}

bool is_known_in_small_letters(std::string_view name) {
  std::string small = in_small_letters(name);
  if (small.ends_with(kDeviation)) small.resize(small.size() - kDeviation.size());
  return name.size() > kLongestSymbol && !is_measured_name(name) && is_measured_name(small);
}

}  // namespace

bool is_measured_heading(std::string_view heading) {
  return std::ranges::any_of(heading_forms(heading), [](const Heading& form) {
    return is_measured_name(form.name) || is_known_in_small_letters(form.name);
  });
}

std::string with_usual_case(const std::string& heading) {
  for (const Heading& form : heading_forms(heading)) {
    if (!is_known_in_small_letters(form.name)) continue;
    const std::string unit(form.unit);
    return in_small_letters(form.name) + (form.has_unit ? " [" + unit + "]" : "");
  }
  return heading;
}

std::vector<std::string> unused(const std::vector<MeasuredColumn>& columns) {
  std::vector<std::string> headings;
  for (const MeasuredColumn& column : columns)
    if (column.role == ColumnRole::unused) headings.push_back(column.name);
  return headings;
}

std::vector<std::string> by_letter(const std::vector<MeasuredColumn>& columns) {
  std::vector<std::string> list;
  for (const MeasuredColumn& column : columns)
    if (column.role == ColumnRole::parameter && column.name.size() == 1)
      list.push_back(column.name + " sets " + std::string(info(column.parameter).name));
  return list;
}

std::vector<std::string> without_unit(const std::vector<MeasuredColumn>& columns) {
  std::vector<std::string> headings;
  for (const MeasuredColumn& column : columns) {
    if (column.unit.empty() && column.role != ColumnRole::unused && column.expected != "1")
      headings.push_back(column.name + " [" + std::string(column.expected) + "]");
  }
  return headings;
}

}  // namespace twum::inline v0_1::motors
