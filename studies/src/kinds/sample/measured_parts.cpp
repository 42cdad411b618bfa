// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/measured_parts.hpp"

#include <twum/io/csv.hpp>
#include <twum/io/number.hpp>
#include <twum/io/plain_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/design_table.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace twum::studies {
namespace {

constexpr std::string_view kWeight = "weight";

double weight_of(const DesignTable::Scratch& row, std::size_t column, const std::string& place) {
  const std::string cell = cell_text(row.cells[column]);
  const auto weight = parse_number(cell);
  if (weight && *weight >= 0) return *weight;
  throw InputError(place + "weight: " + quoted(cell) + "; expected a number, 0 or more");
}

}  // namespace

MeasuredParts::MeasuredParts(const std::string& path, const MotorDesign& base) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) throw InputError("study.parts: " + quoted(path) + " cannot be read");
  PlainStream plain = plain_stream(path, bytes_of(file.get(), path), is_parameter_heading);
  kind_ = plain.kind;
  CsvReader reader(path, std::move(plain.bytes));
  CsvChunk chunk;
  if (!reader.read(chunk, 1))
    throw InputError(path + ": is empty; expected a heading, and a line for each part");
  const DesignTable table(reader, chunk, base, {});
  parameters_ = table.parameters();
  const auto weight = table.column_named(kWeight);
  unused_ = table.copied();
  if (std::erase(unused_, kWeight) > 1)
    throw InputError(path + ": the column 'weight' stands there twice; leave one of them out");
  DesignTable::Scratch row;
  double sum = 0;
  while (reader.read(chunk, 1000))
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      const std::string place = path + ":" + std::to_string(chunk.records[i].line) + ": ";
      if (!table.read_row(chunk.record(i), row)) throw InputError(place + row.reason);
      for (const ParameterValue& one : row.values) values_.push_back(one.second);
      sum += weight ? weight_of(row, *weight, place) : 1;
      sums_.push_back(sum);
    }
  if (!(sum > 0) || !std::isfinite(sum))
    throw InputError(path + ": " + (sums_.empty() ? "no part" : "no part with a weight") +
                     "; expected a line for each part below the heading");
}

std::span<const double> MeasuredParts::draw(double u) const {
  const auto found = std::ranges::upper_bound(sums_, u * sums_.back());
  const auto part = std::min(static_cast<std::size_t>(found - sums_.begin()), size() - 1);
  return std::span(values_).subspan(part * parameters_.size(), parameters_.size());
}

}  // namespace twum::studies
