// SPDX-License-Identifier: Apache-2.0
#include "tables/measured_points.hpp"

#include "tables/heading.hpp"

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/tables/csv.hpp>
#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/units.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>

namespace twum::studies {
namespace {

enum Kind : std::size_t { kSpeedColumn, kTorqueColumn, kWeight, kDeviation };

constexpr std::array<std::string_view, 4> kNames{"speed", "torque", "weight", "torque_sd"};
constexpr std::array<Expected, 4> kExpected{
    {{"rad/s", "100 rpm"}, {"N.m", "0.5 N.m"}, {"1", "2"}, {"N.m", "5 mN.m"}}};

// More columns than a table of points can have; so many errors would help nobody.
constexpr std::size_t kMostColumns = 100;

class PointReader {
 public:
  explicit PointReader(const Source& source)
      : source_(source),
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
    std::vector<std::string> bare = without_unit();
    return {std::move(points_), std::move(bare)};
  }

 private:
  struct Column {
    Kind kind;
    Scale scale;
    std::string unit;  // as typed
    SourceMark mark;
  };

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
    if (!good) {
      diagnostics_.add(source_.mark(static_cast<int>(line) - 1, 0), "",
                       "a quotation mark that cannot stand there", "quote whole cells");
    }
    return good;
  }

  void read_header(std::string_view record, std::size_t line) {
    if (!split(record, line)) return;
    const bool other_separator =
        cells_.size() == 1 && record.find_first_of(";\t") != std::string_view::npos;
    if (other_separator) {
      diagnostics_.add({static_cast<int>(line), 1}, "", "one column",
                       "columns are separated by commas");
      return;
    }
    if (cells_.size() > kMostColumns) {
      diagnostics_.add({static_cast<int>(line), 1}, "", std::to_string(cells_.size()) + " columns",
                       "expected speed, torque, and one more at most");
      return;
    }
    for (const std::string_view cell : cells_)
      columns_.push_back(read_column(cell_text(cell), mark(record, line, cell)));
    check_columns({static_cast<int>(line), 1});
  }

  std::optional<Column> read_column(const std::string& text, SourceMark mark) {
    const Heading heading = split_heading(text);
    const auto name = std::find(kNames.begin(), kNames.end(), heading.name);
    if (name == kNames.end()) {
      diagnostics_.add(mark, "", "unknown column " + quoted(text),
                       did_you_mean(heading.name, kNames));
      return {};
    }
    const auto kind = static_cast<Kind>(name - kNames.begin());
    Column column{kind, {}, std::string(heading.unit), mark};
    try {
      if (heading.has_unit) column.scale = parse_unit(heading.unit, kExpected[kind]);
    } catch (const ValueError& error) {
      diagnostics_.add(mark, std::string(*name), error.found(), error.expected());
    }
    return column;
  }

  void check_columns(SourceMark begin) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!columns_[i] || !columns_[j] || columns_[i]->kind != columns_[j]->kind) continue;
        diagnostics_.add({columns_[i]->mark, std::string(kNames[columns_[i]->kind]),
                          "the column is there twice", "leave one of them out", columns_[j]->mark,
                          "first given here"});
      }
    }
    for (const Kind needed : {kSpeedColumn, kTorqueColumn}) {
      if (find(needed) != nullptr || unknown_column()) continue;
      diagnostics_.add(begin, "", "no column '" + std::string(kNames[needed]) + "'",
                       needed == kSpeedColumn ? "expected one such as 'speed [rpm]'"
                                              : "expected one such as 'torque [N.m]'");
    }
    if (find(kWeight) != nullptr && find(kDeviation) != nullptr) {
      diagnostics_.add({find(kDeviation)->mark, "torque_sd", "weights and standard deviations",
                        "give one of the two", find(kWeight)->mark, "weights given here"});
    }
  }

  std::vector<std::string> without_unit() const {
    std::vector<std::string> headings;
    for (const auto& column : columns_) {
      const std::string_view unit = kExpected[column->kind].unit;
      if (column->unit.empty() && unit != "1")
        headings.push_back(std::string(kNames[column->kind]) + " [" + std::string(unit) + "]");
    }
    return headings;
  }

  // An unknown column may be the one that seems to be missing.
  bool unknown_column() const {
    return std::any_of(columns_.begin(), columns_.end(), [](const auto& c) { return !c; });
  }

  const Column* find(Kind kind) const {
    for (const auto& column : columns_) {
      if (column && column->kind == kind) return &*column;
    }
    return nullptr;
  }

  void read_lines(const CsvChunk& chunk) {
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      const std::string_view record = chunk.record(i);
      if (record.starts_with('#')) continue;
      if (has_header_) {
        read_row(record, chunk.records[i].line);
        continue;
      }
      read_header(record, chunk.records[i].line);
      has_header_ = true;
      diagnostics_.throw_if_any();  // without its columns nothing below has a meaning
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
    MeasuredPoint point{};
    point.weight = 1;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      read_cell(*columns_[i], cells_[i], mark(record, line, cells_[i]), point);
    points_.push_back(point);
    weight_marks_.push_back(weight_mark_);
  }

  void read_cell(const Column& column, std::string_view cell, SourceMark mark,
                 MeasuredPoint& point) {
    const std::string text = cell_text(cell);
    const std::string name(kNames[column.kind]);
    const auto value = column.scale.read(text);
    if (!value) {
      const std::string of =
          column.unit.empty() ? "expected a number" : "expected a number of " + column.unit;
      diagnostics_.add(mark, name, text.empty() ? "no number" : quoted(text) + " is no number", of);
      return;
    }
    const bool positive = column.kind == kWeight || column.kind == kDeviation;
    if (positive && !(*value > 0)) {
      diagnostics_.add(mark, name, quoted(text),
                       "must be more than 0; to ignore a point leave out its line");
      return;
    }
    if (positive) weight_mark_ = mark;
    if (column.kind == kSpeedColumn) point.speed = *value;
    if (column.kind == kTorqueColumn) point.torque = *value;
    if (column.kind == kWeight) point.weight = *value;
    if (column.kind == kDeviation) point.deviation = *value;
  }

  // Weights of mean 1, so that a sum of squares stays one of torques.
  void weigh() {
    double least = 0;
    for (const MeasuredPoint& point : points_)
      least = least == 0 ? point.deviation : std::min(least, point.deviation);
    for (MeasuredPoint& point : points_) {
      const double part = point.deviation > 0 ? least / point.deviation : 1;
      if (point.deviation > 0) point.weight = part * part;
    }
    double largest = 0;
    for (const MeasuredPoint& point : points_) largest = std::max(largest, point.weight);
    double sum = 0;  // of weights relative to the largest one: large ones have no finite sum
    for (MeasuredPoint& point : points_) sum += point.weight /= largest;
    refuse_weightless();
    for (MeasuredPoint& point : points_) point.weight *= static_cast<double>(points_.size()) / sum;
  }

  // A point whose weight is below the smallest number beside that of another one.
  void refuse_weightless() {
    const std::string name(kNames[find(kDeviation) != nullptr ? kDeviation : kWeight]);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].weight > 0) continue;
      diagnostics_.add(weight_marks_[i], name,
                       "so far from the others that the point would count nothing",
                       "to ignore a point leave out its line");
    }
  }

  const Source& source_;
  Diagnostics diagnostics_;
  CsvReader reader_;
  std::size_t taken_{0};
  bool has_header_{false};
  std::vector<std::string_view> cells_;
  std::vector<std::optional<Column>> columns_;
  std::vector<MeasuredPoint> points_;
  SourceMark weight_mark_;                // of the row being read
  std::vector<SourceMark> weight_marks_;  // of each point
};

}  // namespace

MeasuredPoints read_measured_points(const Source& source) { return PointReader(source).read(); }

MeasuredPoints read_measured_points(const std::string& path) {
  return read_measured_points(read_source(path));
}

}  // namespace twum::studies
