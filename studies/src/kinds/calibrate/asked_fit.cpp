// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/asked_fit.hpp"

#include <twum/base/error.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// A table as text and as points.
struct ReadTable {
  MeasuredTable text;
  MeasuredPoints points;
};

// A path without a file is an error of the study; errors in the file are reported there.
ReadTable table_of(const std::string& path, const std::vector<ColumnChoice>& columns) {
  try {
    MeasuredTable text = read_measured_table(path, columns);
    MeasuredPoints points = read_measured_points(text, columns);
    return {std::move(text), std::move(points)};
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) throw;
    throw InputError(std::string(error.what()) +
                     "; expected a table of measured points with columns such as "
                     "'speed [rpm],torque [N.m]'; its path starts in the folder of the study");
  }
}

// How a table was read that is not plain CSV, and what of it is not used.
std::vector<std::string> reading_notes(const ReadTable& table, const std::string& name) {
  std::vector<std::string> notes;
  std::string kind = table.points.instrument;
  if (!table.text.kind.empty()) kind += (kind.empty() ? "" : ", ") + table.text.kind;
  if (!kind.empty()) notes.push_back(name + " is read as: " + kind);
  std::string unused;
  for (const std::string& heading : table.points.unused)
    unused += (unused.empty() ? "" : ", ") + quoted(heading);
  if (!unused.empty())
    notes.push_back(name + " has columns that the study does not use: " + unused);
  return notes;
}

std::vector<std::string> unit_notes(const MeasuredPoints& table) {
  std::string names;
  for (const std::string& heading : table.without_unit)
    names += (names.empty() ? "" : ", ") + heading;
  if (names.empty()) return {};
  return {"the headings of the measured points have no unit, so that they are read in SI units: " +
          names};
}

std::vector<std::string> letter_notes(const MeasuredPoints& table) {
  std::vector<std::string> notes;
  for (const std::string& column : table.by_letter) notes.push_back("the column " + column);
  return notes;
}

// What one point says, as numbers that order points.
std::vector<double> numbers_of(const MeasuredPoint& point) {
  std::vector<double> numbers{point.value};
  const auto* request = std::get_if<MetricRequest>(&point.reading);
  numbers.push_back(static_cast<double>(point.reading.index()));
  numbers.push_back(request != nullptr ? static_cast<double>(request->metric)
                                       : static_cast<double>(std::get<CircuitPart>(point.reading)));
  numbers.push_back(request != nullptr ? request->at : 0);
  for (const auto& [parameter, value] : point.set) {
    numbers.push_back(static_cast<double>(index_of(parameter)));
    numbers.push_back(value);
  }
  return numbers;
}

std::string line_of(const MeasuredPoint& point) { return std::to_string(point.cell.line); }

// How many numbers of a table are copies, and of how many.
struct CopyCount {
  std::size_t copies, all;
};

std::string copy_words(const std::vector<std::string>& names, std::size_t table, std::size_t first,
                       const CopyCount& count, const std::string& lines) {
  const std::string remedy = "; leave them out unless they were measured twice";
  if (table != first && count.copies == count.all)
    return names[table] + " holds the same numbers as " + names[first] +
           ", so that each counts twice and intervals are too narrow" + remedy;
  return names[table] + ": " + std::to_string(count.copies) + " of " +
         counted(count.all, "number") + (count.copies == 1 ? " stands" : " stand") +
         (table == first ? " there twice" : " in " + names[first] + ", too") + " (first: " + lines +
         ") and count twice, so that intervals may be too narrow" + remedy;
}

// Numbers that stand twice count twice: a fit then takes its errors for smaller than they are.
std::vector<std::string> copy_notes(const std::vector<ReadTable>& tables,
                                    const std::vector<std::string>& names) {
  struct First {
    std::size_t table;
    const MeasuredPoint* point;
  };
  std::map<std::vector<double>, First> firsts;
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    std::map<std::size_t, std::pair<std::size_t, std::string>> copies;  // by the table of the first
    for (const MeasuredPoint& point : tables[k].points.points) {
      const auto [first, fresh] = firsts.try_emplace(numbers_of(point), First{k, &point});
      if (fresh) continue;
      auto& [count, lines] = copies[first->second.table];
      if (count++ == 0) lines = "lines " + line_of(*first->second.point) + " and " + line_of(point);
    }
    for (const auto& [table, copy] : copies)
      notes.push_back(
          copy_words(names, k, table, {copy.first, tables[k].points.points.size()}, copy.second));
  }
  return notes;
}

// The same file by any path.
void refuse_file_twice(const std::vector<std::string>& names,
                       const std::vector<std::string>& paths) {
  std::error_code ignored;
  for (std::size_t k = 1; k < paths.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (std::filesystem::equivalent(paths[i], paths[k], ignored))
        throw InputError("study.data: " + quoted(names[k]) +
                         (names[i] == names[k] ? " is given twice"
                                               : " is the same file as " + quoted(names[i])) +
                         ", and its points would count twice; leave one of them out");
}

// Refuses a parameter that a column sets and the study estimates.
void refuse_set(const MeasuredPoints& table, const CalibrateStudy& asked,
                Diagnostics& diagnostics) {
  std::vector<Parameter> given = parameters_of(asked.variables);
  for (const DerivedParameter& rule : asked.derived) given.push_back(rule.parameter);
  for (const auto& [parameter, mark] : table.set) {
    const ParameterInfo& row = info(parameter);
    const bool twice = std::any_of(given.begin(), given.end(), [&](Parameter other) {
      return other == row.parameter || row.alternative == other;
    });
    if (twice)
      diagnostics.add(mark, std::string(row.name), "set here, and estimated by the study",
                      "leave out the column, or the variable");
  }
}

// As in the heading of its column.
std::string column_name(const Reading& reading) {
  const std::string name(name_of(reading));
  return name == "torque_at" ? "torque" : name;
}

// One place for each column without standard deviations.
void refuse_bare(const MeasuredPoints& table, const std::string& reason,
                 const std::string& other_remedy, Diagnostics& diagnostics) {
  std::vector<std::string_view> said;
  for (const MeasuredPoint& point : table.points) {
    const std::string_view quantity = name_of(point.reading);
    if (point.deviation > 0 || std::find(said.begin(), said.end(), quantity) != said.end())
      continue;
    said.push_back(quantity);
    const std::string name = column_name(point.reading);
    diagnostics.add(point.heading, name, "no standard deviation, " + reason,
                    "add the column '" + name + "_sd'" + other_remedy);
  }
}

// Points of one kind in one table.
bool same_column(const MeasuredPoint& a, const MeasuredPoint& b) {
  return a.table == b.table && same_kind(a.reading, b.reading);
}

// With fewer numbers than these beyond the parameters a fit comes so close to all numbers of a column that intervals of 95 %
// were twice as wide as with known deviations.
constexpr std::size_t kBeyondParameters = 3;

void refuse_short(const MeasuredPoints& table, std::size_t parameters, Diagnostics& diagnostics) {
  std::vector<const MeasuredPoint*> said;
  for (const MeasuredPoint& point : table.points) {
    const auto like = [&](const MeasuredPoint& other) { return same_column(point, other); };
    if (std::any_of(said.begin(), said.end(), [&](const auto* other) { return like(*other); }))
      continue;
    said.push_back(&point);
    const auto count =
        static_cast<std::size_t>(std::count_if(table.points.begin(), table.points.end(), like));
    const std::size_t least = parameters + kBeyondParameters;
    if (count >= least) continue;
    diagnostics.add(
        point.heading, column_name(point.reading), counted(count, "number"),
        "'scatter: by-column' needs " + std::to_string(least) + " or more in each column, " +
            std::to_string(kBeyondParameters) +
            " beyond the number of parameters; measure more, or leave out 'scatter' and add the "
            "column '" +
            column_name(point.reading) +
            "_sd' with the standard deviation, for example from the data sheet of the instrument");
  }
}

// Refuses columns of voltages, currents, electrical powers and impedances, where the motor says nothing of its stator.
void refuse_electrical(const MeasuredPoints& table, const MotorDesign& motor,
                       Diagnostics& diagnostics) {
  if (has_modal_data(motor)) return;
  std::vector<std::string_view> said;
  for (const MeasuredPoint& point : table.points) {
    const auto* request = std::get_if<MetricRequest>(&point.reading);
    const std::string_view quantity = name_of(point.reading);
    if (request != nullptr && !info(request->metric).needs_modes) continue;
    if (std::find(said.begin(), said.end(), quantity) != said.end()) continue;
    said.push_back(quantity);
    diagnostics.add(point.heading, std::string(quantity),
                    "the motor has no such value without modal data",
                    "give resonance_frequency, modal_mass, force_factor and quality_factor under "
                    "'stator' in the motor file, with 'voltage' or 'amplitude'; or leave out the "
                    "column");
  }
}

ReadTable checked_table(const CalibrateStudy& asked, const MotorDesign& motor,
                        const std::string& path) {
  ReadTable table = table_of(path, asked.columns);
  Diagnostics diagnostics(table.text.source);
  refuse_set(table.points, asked, diagnostics);
  refuse_electrical(table.points, motor, diagnostics);
  if (asked.scatter == Scatter::stated)
    refuse_bare(table.points, "which 'scatter: stated' needs", ", or leave out 'scatter'",
                diagnostics);
  if (asked.scatter == Scatter::by_column)
    refuse_short(table.points, fit_parameters(asked).size(), diagnostics);
  diagnostics.throw_if_any();
  return table;
}

std::vector<std::size_t> columns_of(const std::vector<MeasuredPoint>& points) {
  std::vector<const MeasuredPoint*> firsts;
  std::vector<std::size_t> columns;
  for (const MeasuredPoint& point : points) {
    const auto known = std::find_if(firsts.begin(), firsts.end(),
                                    [&](const auto* first) { return same_column(*first, point); });
    columns.push_back(static_cast<std::size_t>(known - firsts.begin()));
    if (known == firsts.end()) firsts.push_back(&point);
  }
  return columns;
}

// Sets missing standard deviations to the root mean square of their column, for a first fit.
void give_sizes(std::vector<MeasuredPoint>& points) {
  struct Column {
    double squares{0}, count{0};
    double size() const { return squares > 0 ? std::sqrt(squares / count) : 1; }
  };
  std::map<std::size_t, Column> columns;
  const std::vector<std::size_t> column = columns_of(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    columns[column[i]].squares += points[i].value * points[i].value;
    ++columns[column[i]].count;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].deviation == 0) points[i].deviation = columns[column[i]].size();
}

// Numbers of several kinds are weighed by their standard deviations, and so are those of tables of which some give them.
void require_deviations(const std::vector<ReadTable>& tables) {
  bool alike = true;
  bool given = false;
  const Reading& first = tables.front().points.points.front().reading;
  for (const ReadTable& table : tables) {
    for (const MeasuredPoint& point : table.points.points) {
      alike = alike && same_scale(point.reading, first);
      given = given || point.deviation > 0;
    }
  }
  if (alike && !given) return;
  const std::string need = std::string("which data of ") +
                           (alike ? "tables of which some give them" : "several kinds") + " need";
  for (const ReadTable& table : tables) {
    Diagnostics diagnostics(table.text.source);
    refuse_bare(table.points, need, ", or 'scatter: by-column' to the study", diagnostics);
    diagnostics.throw_if_any();
  }
}

}  // namespace

std::vector<std::string> file_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths)
    names.push_back(std::filesystem::path(path).filename().string());
  return names;
}

std::vector<FitParameter> fit_parameters(const CalibrateStudy& asked) {
  const std::vector<std::string> files = file_names(asked.data);
  std::vector<FitParameter> list;
  for (const DesignVariable& range : asked.variables) {
    const bool own = std::find(asked.per_file.begin(), asked.per_file.end(), range.parameter) !=
                     asked.per_file.end();
    if (!own) list.emplace_back(range);
    for (std::size_t k = 0; own && k < files.size(); ++k) list.emplace_back(range, k, files[k]);
  }
  return list;
}

AskedFit asked_fit(const CalibrateStudy& asked, const StudyFile& file) {
  std::vector<ReadTable> tables;
  std::vector<std::string> paths;
  std::string names;
  for (const std::string& name : asked.data) {
    paths.push_back((std::filesystem::path(file.folder) / name).string());
    names += (names.empty() ? "" : ", ") + paths.back();
    tables.push_back(checked_table(asked, file.motor.design, paths.back()));
    if (asked.scatter == Scatter::by_column) give_sizes(tables.back().points.points);
  }
  refuse_file_twice(asked.data, paths);
  require_deviations(tables);
  const std::vector<std::string> titles = file_names(asked.data);
  std::vector<std::string> notes = copy_notes(tables, titles);
  for (std::size_t k = 0; k < tables.size(); ++k)
    for (const std::string& note : reading_notes(tables[k], titles[k])) notes.push_back(note);
  std::vector<MeasuredPoints> all;
  for (ReadTable& one : tables) all.push_back(std::move(one.points));
  MeasuredPoints table = joined(std::move(all));
  std::vector<MeasuredPoint>& points = table.points;
  std::vector<FitParameter> parameters = fit_parameters(asked);
  if (points.size() < parameters.size())
    throw InputError(names + ": " + counted(points.size(), "point") + " cannot determine " +
                     counted(parameters.size(), "parameter") +
                     "; measure more points or estimate fewer parameters");
  for (const std::vector<std::string>& more : {unit_notes(table), letter_notes(table)})
    notes.insert(notes.end(), more.begin(), more.end());
  std::vector<std::size_t> columns;
  if (asked.scatter == Scatter::by_column) columns = columns_of(points);
  return {{file.motor.design, std::move(parameters), std::move(points), asked.derived},
          std::move(notes),
          std::move(columns)};
}

}  // namespace twum::inline v0_1::studies
