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

namespace twum::studies {
namespace {

// A path without a file is an error of the study; errors in the file are reported there.
MeasuredPoints points_of(const std::string& path) {
  try {
    return read_measured_points(path);
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) +
                     "; expected a CSV file of measured points with columns such as "
                     "'speed [rpm],torque [N.m]'; its path starts in the folder of the study");
  }
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

bool same_reading(const MeasuredPoint& a, const MeasuredPoint& b) {
  const auto* one = std::get_if<MetricRequest>(&a.reading);
  const auto* other = std::get_if<MetricRequest>(&b.reading);
  const bool there = one == nullptr || other == nullptr || one->at == other->at;
  return same_kind(a.reading, b.reading) && there && a.value == b.value && a.set == b.set;
}

// Tables with the same numbers count twice: a fit then takes its errors for smaller than they are.
std::vector<std::string> copy_notes(const std::vector<MeasuredPoints>& tables,
                                    const std::vector<std::string>& names) {
  std::vector<std::string> notes;
  for (std::size_t k = 1; k < tables.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      if (!std::ranges::equal(tables[i].points, tables[k].points, same_reading)) continue;
      notes.push_back(
          names[k] + " holds the same numbers as " + names[i] +
          ", so that each counts twice and intervals are too narrow; leave one of them out "
          "unless the numbers were measured twice");
      break;
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

MeasuredPoints checked_table(const CalibrateStudy& asked, const MotorDesign& motor,
                             const std::string& path) {
  MeasuredPoints table = points_of(path);
  const Source source = read_source(path);
  Diagnostics diagnostics(source);
  refuse_set(table, asked, diagnostics);
  refuse_electrical(table, motor, diagnostics);
  if (asked.scatter == Scatter::stated)
    refuse_bare(table, "which 'scatter: stated' needs", ", or leave out 'scatter'", diagnostics);
  if (asked.scatter == Scatter::by_column)
    refuse_short(table, fit_parameters(asked).size(), diagnostics);
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
void require_deviations(const std::vector<MeasuredPoints>& tables,
                        const std::vector<std::string>& paths) {
  bool alike = true;
  bool given = false;
  for (const MeasuredPoints& table : tables) {
    for (const MeasuredPoint& point : table.points) {
      alike = alike && same_kind(point.reading, tables.front().points.front().reading);
      given = given || point.deviation > 0;
    }
  }
  if (alike && !given) return;
  const std::string need = std::string("which data of ") +
                           (alike ? "tables of which some give them" : "several kinds") + " need";
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const Source source = read_source(paths[k]);
    Diagnostics diagnostics(source);
    refuse_bare(tables[k], need, "", diagnostics);
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
  std::vector<MeasuredPoints> tables;
  std::vector<std::string> paths;
  std::string names;
  for (const std::string& name : asked.data) {
    paths.push_back((std::filesystem::path(file.folder) / name).string());
    names += (names.empty() ? "" : ", ") + paths.back();
    tables.push_back(checked_table(asked, file.motor.design, paths.back()));
    if (asked.scatter == Scatter::by_column) give_sizes(tables.back().points);
  }
  refuse_file_twice(asked.data, paths);
  require_deviations(tables, paths);
  std::vector<std::string> notes = copy_notes(tables, asked.data);
  MeasuredPoints table = joined(std::move(tables));
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

}  // namespace twum::studies
