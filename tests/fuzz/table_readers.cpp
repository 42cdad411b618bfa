// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.hpp"
#include "fuzz/targets.hpp"
#include "tables/measured_points.hpp"

#include <twum/io/plain_table.hpp>
#include <twum/motors/design_table.hpp>
#include <twum/motors/motor_file.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace twum::fuzz {
namespace {

using namespace twum::studies;

constexpr std::size_t kMostRows = 20;

// Bytes of a text, at most `step` at once.
CsvReader::Bytes bytes_of(std::string_view text, std::size_t step) {
  return [text, step](char* to, std::size_t size) mutable {
    const std::size_t got = std::min({size, step, text.size()});
    std::memcpy(to, text.data(), got);
    text.remove_prefix(got);
    return got;
  };
}

// All records with their lines, and the error at the end if there is one.
std::vector<std::string> records_of(std::string_view text, std::size_t step) {
  std::vector<std::string> records;
  CsvReader reader("table.csv", bytes_of(text, step));
  CsvChunk chunk;
  try {
    while (reader.read(chunk, 1)) {
      for (std::size_t i = 0; i < chunk.records.size(); ++i)
        records.push_back(std::to_string(chunk.records[i].line) + ":" +
                          std::string(chunk.record(i)));
    }
  } catch (const InputError& error) {
    records.emplace_back(error.what());
  }
  return records;
}

const MotorDesign& base_motor() {
  static const MotorDesign design =
      read_motor_file(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml").design;
  return design;
}

void expect_columns_in_step(std::string_view record, std::size_t line, const DesignTable& table,
                            DesignTable::Scratch& scratch) {
  std::string out;
  table.append_result(record, line, scratch, out);
  const std::string header = table.result_header();
  std::vector<std::string_view> cells, names;
  const bool well_formed =
      split_record(std::string_view(out).substr(0, out.size() - 1), cells) &&
      split_record(std::string_view(header).substr(0, header.size() - 1), names);
  if (!well_formed || cells.size() != names.size())
    throw BrokenLaw("a result of " + std::to_string(cells.size()) + " cells: " + out);
}

void evaluate_rows(std::string_view text) {
  CsvReader reader(
      "table.csv",
      plain_stream("table.csv", bytes_of(text, text.size()), is_parameter_heading).bytes);
  CsvChunk chunk;
  if (!reader.read(chunk, 1)) return;
  const DesignTable table(reader, chunk, base_motor(),
                          parse_metric_list("contact_half_length, preload"));
  DesignTable::Scratch scratch;
  for (std::size_t row = 0; row < kMostRows && reader.read(chunk, 1); ++row)
    expect_columns_in_step(chunk.record(0), chunk.records[0].line, table, scratch);
}

void expect_weights(const std::vector<MeasuredPoint>& points) {
  double sum = 0;
  for (const MeasuredPoint& point : points) {
    sum += point.weight;
    if (!std::isfinite(point.value) || !(point.weight >= 0))
      throw BrokenLaw("a point that is no number");
  }
  // Rounding of a sum of positive numbers, of at most 1e6 of them.
  const auto count = static_cast<double>(points.size());
  if (!(std::abs(sum - count) <= 1e-9 * count)) throw BrokenLaw("weights without a mean of 1");
}

}  // namespace

void feed_table(std::string_view text) {
  if (text.empty()) return;
  const std::size_t step = 1 + static_cast<unsigned char>(text.front()) % 16;
  text.remove_prefix(1);
  if (records_of(text, step) != records_of(text, std::max<std::size_t>(text.size(), 1)))
    throw BrokenLaw("other records when read in pieces");
  try {
    evaluate_rows(text);
  } catch (const InputError&) {
    return;
  }
}

void feed_points(std::string_view text) {
  std::vector<MeasuredPoint> points;
  try {
    points = read_measured_points(Source("points.csv", std::string(text))).points;
  } catch (const InputError&) {
    return;
  }
  expect_weights(points);
}

}  // namespace twum::fuzz
