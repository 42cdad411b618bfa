// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/design_table.hpp>

#include "tables/parameter_heading.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace twum::inline v0_1::motors {
namespace {

constexpr std::size_t kMostShown = 100;  // errors of one header

constexpr std::string_view kStatus = "status";

std::string at_line(std::size_t line) { return "line " + std::to_string(line) + ": "; }

std::string result_heading(const MetricExpression& metric) {
  return metric.text + " [" + std::string(metric.unit()) + "]";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string not_a_number(std::string_view cell) {
  if (cell.empty()) return "empty cell";
  const NumberComplaint comma = number_complaint(cell);
  return comma.found.empty() ? quoted(cell) + " is not a number"
                             : comma.found + "; " + comma.expected;
}

// Appends a cell unchanged, unless it is malformed or a spreadsheet would run it as a formula.
void append_copy(std::string& out, std::string_view cell) {
  std::vector<std::string_view> parts;
  const bool well_formed = split_record(cell, parts) && parts.size() == 1;
  if (well_formed && !is_formula(cell_text(cell))) {
    out += cell;
  } else {
    append_cell(out, well_formed ? cell_text(cell) : std::string(cell));
  }
}

}  // namespace

bool is_parameter_heading(std::string_view heading) {
  return std::ranges::any_of(heading_forms(heading), [](const Heading& form) {
    return parameter_named(form.name).has_value();
  });
}

bool any_answer(std::span<const MetricExpression> asked, std::span<const MetricValue> values) {
  const auto of_motor = [](const MetricExpression& one) {
    return std::any_of(one.terms.begin(), one.terms.end(),
                       [](const Term& term) { return !std::holds_alternative<Parameter>(term); });
  };
  const bool parameters_alone = std::none_of(asked.begin(), asked.end(), of_motor);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].status == MetricStatus::ok && (parameters_alone || of_motor(asked[i])))
      return true;
  return false;
}

DesignTable::DesignTable(const CsvReader& reader, const CsvChunk& header, const MotorDesign& base,
                         std::vector<MetricExpression> metrics)
    : base_(base), metrics_(std::move(metrics)), evaluator_(metrics_), header_(header.record(0)) {
  const std::string place = reader.name() + ":" + std::to_string(header.records[0].line) + ": ";
  std::vector<std::string> wrong;
  std::vector<std::string_view> cells;
  const bool well_formed = split_record(header_, cells);
  if (!well_formed)
    wrong.emplace_back("a quotation mark that cannot stand there; quote whole cells");
  for (const std::string_view cell : cells) {
    try {
      columns_.push_back(read_column(cell_text(cell)));
    } catch (const ValueError& error) {
      columns_.push_back({cell_text(cell), cell_text(cell), {}, {}});
      wrong.push_back("column " + quoted(cell_text(cell)) + ": " + error.what());
    }
  }
  check_alternatives(wrong);
  for (TableColumn& column : columns_) column.computed = is_computed(column.heading);
  add_column_warnings();
  const auto is_parameter = [](const TableColumn& c) { return c.parameter.has_value(); };
  if (wrong.empty() && std::none_of(columns_.begin(), columns_.end(), is_parameter)) {
    wrong.emplace_back(
        "no column is a parameter; name columns like 'preload [N]' ('twum parameters' lists the "
        "names)");
  }
  if (wrong.empty()) return;
  std::string text;
  for (std::size_t i = 0; i < std::min(wrong.size(), kMostShown); ++i)
    text += (text.empty() ? place : "\n" + place) + wrong[i];
  if (wrong.size() > kMostShown)
    text += "\n" + place + "and " + std::to_string(wrong.size() - kMostShown) + " more errors";
  throw InputError(text);
}

DesignTable::TableColumn DesignTable::read_column(const std::string& text) {
  for (const Heading& heading : heading_forms(text))
    if (const auto parameter = parameter_named(heading.name))
      return parameter_column(text, heading, info(*parameter));
  warn_of_copy(text);
  return {text, text, {}, {}};
}

DesignTable::TableColumn DesignTable::parameter_column(const std::string& text,
                                                       const Heading& heading,
                                                       const ParameterInfo& row) {
  const bool letter = heading.name.size() == 1;
  if (is_bare_letter(heading))
    throw ValueError(bare_letter_words(heading.name, row), bare_letter_advice(row));
  if (letter) warnings_.push_back("column " + quoted(text) + " sets " + std::string(row.name));
  if (!heading.has_unit && row.unit != "1")
    without_unit_.push_back(std::string(heading.name) + " [" + std::string(row.unit) + "]");
  const Scale scale =
      heading.has_unit ? parse_unit(heading.unit, {row.unit, row.example, row.absolute}) : Scale();
  return {std::string(heading.name), text, row.parameter, scale};
}

// A heading that is nearly a parameter, or begins with the name of one.
void DesignTable::warn_of_copy(const std::string& text) {
  const std::string_view name = heading_forms(text).front().name;
  std::vector<std::string_view> names;
  for (const ParameterInfo& row : parameter_table()) {
    names.push_back(row.name);
    if (row.symbol.size() > 2) names.push_back(row.symbol);  // shorter ones are near too many words
  }
  const auto begins = parameter_named(first_word(text));
  const std::string_view near = nearest(name, names);
  if (near.empty() && !begins) return;
  const ParameterInfo& row = info(near.empty() ? *begins : *find_parameter(near));
  if (near.empty() && row.symbol == first_word(text)) return;  // a word that happens to be a symbol
  warnings_.push_back("column " + quoted(text) +
                      " is not a parameter and is only copied; did you mean '" + heading_of(row) +
                      "'?");
}

// True for a column that the result computes itself, as in the result of an earlier run.
bool DesignTable::is_computed(const std::string& heading) const {
  if (heading == kStatus) return true;
  return std::any_of(metrics_.begin(), metrics_.end(), [&](const MetricExpression& metric) {
    std::string cell;
    append_cell(cell, result_heading(metric));
    return heading == cell_text(cell);
  });
}

void DesignTable::add_column_warnings() {
  if (!without_unit_.empty())
    warnings_.push_back("columns without a unit are read in SI units: " + joined(without_unit_) +
                        "; to name the unit, write a heading such as '" + without_unit_.front() +
                        "'");
  std::vector<std::string> computed;
  for (const TableColumn& column : columns_)
    if (column.computed && !column.parameter) computed.push_back(quoted(column.heading));
  if (!computed.empty())
    warnings_.push_back("columns that are computed anew are not copied: " + joined(computed));
}

void DesignTable::check_alternatives(std::vector<std::string>& wrong) const {
  std::map<Parameter, const TableColumn*> first;
  for (const TableColumn& column : columns_) {
    if (!column.parameter) continue;
    if (!first.emplace(*column.parameter, &column).second) {
      wrong.push_back("column " + quoted(column.name) +
                      ": the parameter is given twice; leave one of them out");
    }
    const auto alternative = info(*column.parameter).alternative;
    const auto before = alternative ? first.find(*alternative) : first.end();
    if (before != first.end()) {
      wrong.push_back("column " + quoted(column.name) + ": cannot be given together with " +
                      quoted(before->second->name) + "; give one of the two");
    }
  }
}

bool DesignTable::any_answer(const Scratch& scratch) const {
  return motors::any_answer(metrics_, scratch.metrics);
}

bool DesignTable::has(Parameter parameter) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](const TableColumn& c) { return c.parameter == parameter; });
}

std::string DesignTable::result_header() const {
  std::string text;
  std::vector<std::string_view> cells;
  split_record(header_, cells);
  append_columns(cells, text);
  for (const MetricExpression& metric : metrics_) {
    append_cell(text, result_heading(metric));
    text += ',';
  }
  return text + std::string(kStatus) + "\n";
}

std::vector<Parameter> DesignTable::parameters() const {
  std::vector<Parameter> list;
  for (const TableColumn& column : columns_)
    if (column.parameter) list.push_back(*column.parameter);
  return list;
}

std::vector<std::string> DesignTable::copied() const {
  std::vector<std::string> list;
  for (const TableColumn& column : columns_)
    if (!column.parameter) list.push_back(column.heading);
  return list;
}

std::optional<std::size_t> DesignTable::column_named(std::string_view heading) const {
  const auto found = std::ranges::find(columns_, heading, &TableColumn::heading);
  if (found == columns_.end()) return {};
  return static_cast<std::size_t>(found - columns_.begin());
}

bool DesignTable::read_values(Scratch& scratch) const {
  scratch.values.clear();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const TableColumn& column = columns_[i];
    if (!column.parameter) continue;
    std::string_view cell = trimmed(scratch.cells[i]);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = trimmed(cell.substr(1, cell.size() - 2));
    const auto value = column.scale.read(cell);
    if (!value) {
      scratch.reason = column.name + ": " + not_a_number(cell);
      return false;
    }
    scratch.values.emplace_back(*column.parameter, *value);
  }
  return true;
}

DesignOutcome<std::vector<MetricValue>> DesignTable::metrics(Scratch& scratch) const {
  return ask_design([&] { return with(base_, scratch.values); },
                    [&](const Motor& motor) {
                      scratch.notes = model_notes(motor);
                      return evaluator_.evaluate(motor);
                    });
}

// No contact is solved where nothing asks for one.
DesignOutcome<std::vector<MetricValue>> DesignTable::parameters(const Scratch& scratch) const {
  return outcome_of([&] {
    const MotorDesign design = with(base_, scratch.values);
    require_motor(design);
    std::vector<MetricValue> values(metrics_.size());
    evaluator_.combine(design, values);
    return values;
  });
}

bool DesignTable::read_row(std::string_view record, Scratch& scratch) const {
  scratch.well_formed = split_record(record, scratch.cells);
  if (scratch.well_formed && scratch.cells.size() == columns_.size()) return read_values(scratch);
  scratch.reason = scratch.well_formed ? counted(scratch.cells.size(), "cell") +
                                             ", the header has " + std::to_string(columns_.size())
                                       : "a quotation mark that cannot stand there";
  return false;
}

// Sets scratch.metrics, and scratch.reason if something is wrong.
bool DesignTable::compute(std::string_view record, std::size_t line, Scratch& scratch) const {
  if (!read_row(record, scratch)) {
    scratch.reason = at_line(line) + scratch.reason;
    return false;
  }
  auto outcome = evaluator_.requests().empty() ? parameters(scratch) : metrics(scratch);
  if (const auto* failure = std::get_if<DesignFailure>(&outcome)) {
    const bool refused = failure->kind == DesignFailure::Kind::refused;
    scratch.reason = (refused ? at_line(line) : "") + failure->text;
  } else {
    scratch.metrics = std::get<std::vector<MetricValue>>(std::move(outcome));
    scratch.reason = without_number(metrics_, scratch.metrics);
    return unanswered(metrics_, scratch.metrics).empty();
  }
  return false;
}

// Appends the copied columns, each followed by a comma. There are always as many cells as in the header.
void DesignTable::append_columns(const std::vector<std::string_view>& cells,
                                 std::string& out) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].computed && !columns_[i].parameter) continue;
    if (i < cells.size()) append_copy(out, cells[i]);
    out += ',';
  }
}

bool DesignTable::append_result(std::string_view record, std::size_t line, Scratch& scratch,
                                std::string& out) const {
  scratch.reason.clear();
  scratch.notes.reset();
  scratch.metrics.assign(metrics_.size(), {0, MetricStatus::undefined});
  const bool ok = compute(record, line, scratch);
  append_columns(scratch.cells, out);
  for (const MetricValue& metric : scratch.metrics) {
    if (metric.status == MetricStatus::ok) append_number(out, metric.value);
    out += ',';
  }
  append_cell(out, scratch.reason.empty() ? "ok" : std::string_view(scratch.reason));
  out += '\n';
  return ok;
}

}  // namespace twum::inline v0_1::motors
