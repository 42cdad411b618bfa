// SPDX-License-Identifier: Apache-2.0
#include "tables/measured_points.hpp"

#include "tables/chosen_columns.hpp"
#include "tables/instrument_headings.hpp"
#include "tables/measured_columns.hpp"

#include <twum/base/error.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string_view>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

// Limit of columns, to avoid a long list of errors for a file of another kind.
constexpr std::size_t kMostColumns = 100;

class PointReader {
 public:
  PointReader(const Source& source, const std::vector<ColumnChoice>& choices)
      : source_(source),
        choices_(choices),
        diagnostics_(source),
        reader_(source.name(), [this](char* to, std::size_t size) { return bytes(to, size); }) {}

  MeasuredPoints read() {
    CsvChunk chunk;
    while (reader_.read(chunk, 256)) read_lines(chunk);
    if (!has_header_)
      diagnostics_.add({1, 1}, "", "an empty file",
                       "expected a header such as 'speed [rpm],torque'");
    else if (points_.empty() && diagnostics_.empty())
      diagnostics_.add({1, 1}, "", "no points below the header", "expected one on each line");
    diagnostics_.throw_if_any();
    weigh();
    diagnostics_.throw_if_any();
    MeasuredPoints table{std::move(points_), without_unit(columns_), by_letter(columns_)};
    table.unused = unused(columns_);
    table.instrument = instrument_;
    for (const MeasuredColumn& column : columns_)
      if (column.role == ColumnRole::parameter)
        table.set.emplace_back(column.parameter, column.mark);
    return table;
  }

 private:
  std::size_t bytes(char* to, std::size_t size) {
    const std::size_t got = std::min(size, source_.text().size() - taken_);
    std::memcpy(to, source_.text().data() + taken_, got);
    taken_ += got;
    return got;
  }

  SourceMark mark(std::string_view record, std::size_t line, std::string_view cell) const {
    const auto blanks = cell.find_first_not_of(" \t");
    const auto byte = static_cast<std::size_t>(cell.data() - record.data()) +
                      (blanks == std::string_view::npos ? 0 : blanks);
    return source_.mark(static_cast<int>(line) - 1, static_cast<int>(byte));
  }

  bool split(std::string_view record, std::size_t line) {
    const bool good = split_record(record, cells_);
    if (!good)
      diagnostics_.add(source_.mark(static_cast<int>(line) - 1, 0), "",
                       "a quotation mark that cannot stand there", "quote whole cells");
    return good;
  }

  void read_header(std::string_view record, std::size_t line) {
    if (!split(record, line)) return;
    if (cells_.size() > kMostColumns) {
      diagnostics_.add({static_cast<int>(line), 1}, "", std::to_string(cells_.size()) + " columns",
                       "expected " + std::to_string(kMostColumns) + " at most");
      return;
    }
    std::vector<ColumnHeading> headings;
    for (const std::string_view cell : cells_)
      headings.push_back({cell_text(cell), mark(record, line, cell)});
    name_chosen_columns(choices_, headings, {static_cast<int>(line), 1}, diagnostics_);
    instrument_ = name_instrument_columns(headings);
    for (ColumnHeading& heading : headings) heading.text = with_usual_case(heading.text);
    columns_ = measured_columns(headings, {static_cast<int>(line), 1}, diagnostics_);
    for (const MeasuredColumn& column : columns_)
      measured_ += column.role == ColumnRole::measured ? 1 : 0;
  }

  void read_lines(const CsvChunk& chunk) {
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      const std::string_view record = chunk.record(i);
      if (has_header_) {
        read_row(record, chunk.records[i].line);
        continue;
      }
      read_header(record, chunk.records[i].line);
      has_header_ = true;
      diagnostics_.throw_if_any();  // the rows cannot be read without valid columns
    }
  }

  void read_row(std::string_view record, std::size_t line) {
    if (!split(record, line)) return;
    if (cells_.size() != columns_.size()) {
      diagnostics_.add({static_cast<int>(line), 1}, "",
                       std::to_string(cells_.size()) + (cells_.size() == 1 ? " cell" : " cells"),
                       "the header has " + std::to_string(columns_.size()));
      return;
    }
    marks_.clear();
    for (const std::string_view cell : cells_) marks_.push_back(mark(record, line, cell));
    values_.assign(columns_.size(), {});
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (wanted(i)) values_[i] = read_cell(columns_[i], cells_[i], marks_[i]);
    const std::size_t before = points_.size();
    for (std::size_t i = 0; i < columns_.size(); ++i) add_point(i);
    if (points_.size() == before && measured_ > 1 && diagnostics_.empty())
      diagnostics_.add({static_cast<int>(line), 1}, "", "nothing was measured",
                       "leave out the line");
  }

  // Whether a cell has to have a value: a reading may be empty if the row has another one, and then its deviation,
  // too.
  bool wanted(std::size_t i) const {
    const MeasuredColumn& column = columns_[i];
    if (column.role == ColumnRole::unused) return false;
    const bool read = column.role == ColumnRole::measured || column.role == ColumnRole::deviation;
    if (!read || measured_ < 2) return true;
    const std::size_t of = column.role == ColumnRole::measured ? i : column.of;
    return !cell_text(cells_[of]).empty();
  }

  void add_point(std::size_t i) {
    if (columns_[i].role != ColumnRole::measured || !values_[i]) return;
    MeasuredPoint point{columns_[i].reading, *values_[i]};
    weight_mark_ = {};
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const MeasuredColumn& other = columns_[k];
      if (!values_[k]) continue;
      if (other.role == ColumnRole::argument) set_argument(point, other, *values_[k]);
      if (other.role == ColumnRole::time) set_time(point, *values_[k]);
      if (other.role == ColumnRole::parameter) point.set.emplace_back(other.parameter, *values_[k]);
      const bool weighs = other.role == ColumnRole::weight ||
                          (other.role == ColumnRole::deviation && other.of == i);
      if (!weighs) continue;
      (other.role == ColumnRole::weight ? point.weight : point.deviation) = *values_[k];
      weight_mark_ = marks_[k];
      weight_name_ = other.name;
    }
    point.cell = marks_[i];
    point.heading = columns_[i].mark;
    points_.push_back(std::move(point));
    weight_marks_.emplace_back(weight_mark_, weight_name_);
  }

  static void set_argument(MeasuredPoint& point, const MeasuredColumn& column, double value) {
    auto* request = std::get_if<MetricRequest>(&point.reading);
    if (request != nullptr && request->argument == column.argument) request->at = value;
  }

  static void set_time(MeasuredPoint& point, double value) {
    auto* request = std::get_if<MetricRequest>(&point.reading);
    if (request != nullptr && info(request->metric).timed) request->after = value;
  }

  std::optional<double> read_cell(const MeasuredColumn& column, std::string_view cell,
                                  SourceMark mark) {
    const std::string text = cell_text(cell);
    auto value = column.scale.read(text);
    if (!value) {
      refuse_cell(column, text, mark);
      return {};
    }
    if (column.unit.empty() && is_phase(column) && std::abs(*value) > 2 * std::numbers::pi) {
      diagnostics_.add(mark, column.name,
                       quoted(text) + " without a unit is in radians, where no phase is as large",
                       "give the unit in the heading, such as 'impedance_phase [deg]'");
      return {};
    }
    if (column.reversed) value = -*value;
    const bool positive = column.role == ColumnRole::weight || column.role == ColumnRole::deviation;
    if (positive && !(*value > 0)) {
      diagnostics_.add(mark, column.name, quoted(text),
                       "must be more than 0; to ignore a point leave out its line");
      return {};
    }
    if (column.role == ColumnRole::time && !(*value >= 0)) {
      diagnostics_.add(mark, column.name, quoted(text),
                       "must be 0 or more: the time since the motor at ambient temperature took up "
                       "the load");
      return {};
    }
    if (column.role != ColumnRole::parameter) return value;
    const std::string wrong = complaint(column.parameter, *value);
    if (!wrong.empty()) diagnostics_.add(mark, column.name, quoted(text), wrong);
    return value;
  }

  static bool is_phase(const MeasuredColumn& column) {
    const auto* part = std::get_if<CircuitPart>(&column.reading);
    return column.role == ColumnRole::measured && part != nullptr &&
           *part == CircuitPart::impedance_phase;
  }

  void refuse_cell(const MeasuredColumn& column, const std::string& text, SourceMark mark) {
    if (const NumberComplaint comma = number_complaint(text); !comma.found.empty()) {
      diagnostics_.add(mark, column.name, comma.found, comma.expected);
      return;
    }
    diagnostics_.add(
        mark, column.name, text.empty() ? "empty cell" : quoted(text) + " is not a number",
        column.unit.empty() ? "expected a number" : "expected a number in " + column.unit);
  }

  // Scales weights to the mean 1, so that the sum of squares keeps its unit.
  void weigh() {
    double least = 0;
    for (const MeasuredPoint& point : points_)
      if (point.deviation > 0)
        least = least == 0 ? point.deviation : std::min(least, point.deviation);
    for (MeasuredPoint& point : points_) {
      const double part = point.deviation > 0 ? least / point.deviation : 1;
      if (point.deviation > 0) point.weight = part * part;
    }
    double largest = 0;
    for (const MeasuredPoint& point : points_) largest = std::max(largest, point.weight);
    // of weights relative to the largest one, because the sum of large ones may overflow
    double sum = 0;
    for (MeasuredPoint& point : points_) sum += point.weight /= largest;
    refuse_weightless();
    for (MeasuredPoint& point : points_) point.weight *= static_cast<double>(points_.size()) / sum;
  }

  // Refuses a point whose weight underflows relative to the largest one.
  void refuse_weightless() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].weight > 0) continue;
      diagnostics_.add(weight_marks_[i].first, weight_marks_[i].second,
                       "the weight of the point is negligible compared with the others",
                       "to ignore a point leave out its line");
    }
  }

  const Source& source_;
  const std::vector<ColumnChoice>& choices_;
  Diagnostics diagnostics_;
  CsvReader reader_;
  std::size_t taken_{0};
  bool has_header_{false};
  std::size_t measured_{0};  // columns
  std::vector<MeasuredColumn> columns_;
  std::string instrument_;
  std::vector<MeasuredPoint> points_;
  // Of the row being read.
  std::vector<std::string_view> cells_;
  std::vector<SourceMark> marks_;
  std::vector<std::optional<double>> values_;
  SourceMark weight_mark_;
  std::string weight_name_;
  std::vector<std::pair<SourceMark, std::string>> weight_marks_;  // of each point
};

bool one_kind(const std::vector<MeasuredPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const MeasuredPoint& point) {
    return same_scale(point.reading, points.front().reading);
  });
}

}  // namespace

std::string_view name_of(const Reading& reading) {
  if (const auto* request = std::get_if<MetricRequest>(&reading)) return info(request->metric).name;
  return info(std::get<CircuitPart>(reading)).name;
}

std::string_view unit_of(const Reading& reading) {
  if (const auto* request = std::get_if<MetricRequest>(&reading)) return info(request->metric).unit;
  return info(std::get<CircuitPart>(reading)).unit;
}

bool same_kind(const Reading& a, const Reading& b) { return name_of(a) == name_of(b); }

bool same_scale(const Reading& a, const Reading& b) {
  const auto* one = std::get_if<CircuitPart>(&a);
  const auto* other = std::get_if<CircuitPart>(&b);
  return same_kind(a, b) || (one != nullptr && other != nullptr && same_number(*one, *other));
}

MeasuredPoint torque_point(double speed, double torque, double weight, double deviation) {
  return {MetricRequest{Metric::torque_at, Argument::speed, speed}, torque, weight, deviation};
}

MeasuredPoints read_measured_points(const MeasuredTable& table,
                                    const std::vector<ColumnChoice>& choices) {
  return PointReader(table.source, choices).read();
}

MeasuredPoints read_measured_points(const Source& source,
                                    const std::vector<ColumnChoice>& choices) {
  return read_measured_points(measured_table(source, choices), choices);
}

MeasuredPoints joined(std::vector<MeasuredPoints> files) {
  MeasuredPoints all;
  for (std::size_t k = 0; k < files.size(); ++k) {
    MeasuredPoints& file = files[k];
    for (MeasuredPoint& point : file.points) point.table = k;
    std::move(file.points.begin(), file.points.end(), std::back_inserter(all.points));
    std::move(file.without_unit.begin(), file.without_unit.end(),
              std::back_inserter(all.without_unit));
    std::move(file.by_letter.begin(), file.by_letter.end(), std::back_inserter(all.by_letter));
  }
  const bool alike = one_kind(all.points);
  if (files.size() == 1 && alike) return all;
  const auto bare = std::count_if(all.points.begin(), all.points.end(),
                                  [](const MeasuredPoint& point) { return point.deviation == 0; });
  if (alike && bare == std::ssize(all.points)) return all;
  if (bare != 0) throw InputError("measured points: some have no standard deviation");
  for (MeasuredPoint& point : all.points) point.weight = 1 / (point.deviation * point.deviation);
  double sum = 0;
  for (const MeasuredPoint& point : all.points) sum += point.weight;
  const double mean = alike ? sum / static_cast<double>(all.points.size()) : 1;
  for (MeasuredPoint& point : all.points) point.weight /= mean;
  return all;
}

}  // namespace twum::inline v0_1::motors
