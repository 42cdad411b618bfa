// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/measured_parts.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/number.hpp>
#include <twum/io/plain_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/design_table.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::string_view kWeight = "weight";

// Weights are known in any case of letters: read as another column, all parts would count alike.
bool is_weight(const std::string& name) { return in_small_letters(name) == kWeight; }

double weight_of(const DesignTable::Scratch& row, std::size_t column, const std::string& place) {
  const std::string cell = cell_text(row.cells[column]);
  const auto weight = parse_number(cell);
  if (weight && *weight >= 0) return *weight;
  throw InputError(place + "weight: " + quoted(cell) + "; expected a number, 0 or more");
}

// The rows of the table below its heading.
optim::MeasuredRows rows_of(const DesignTable& table, CsvReader& reader, const std::string& path) {
  const std::vector<std::string> others = table.copied();
  const auto named = std::ranges::find_if(others, is_weight);
  const auto weight = named == others.end() ? std::nullopt : table.column_named(*named);
  optim::MeasuredRows rows(table.parameters().size());
  DesignTable::Scratch row;
  CsvChunk chunk;
  while (reader.read(chunk, 1000))
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      const std::string place = path + ":" + std::to_string(chunk.records[i].line) + ": ";
      if (!table.read_row(chunk.record(i), row)) throw InputError(place + row.reason);
      std::vector<double> values;
      for (const auto& [parameter, value] : row.values) {
        if (const std::string wrong = complaint(parameter, value); !wrong.empty())
          throw InputError(place + std::string(info(parameter).name) + ": " + number_text(value) +
                           ": " + wrong);
        values.push_back(value);
      }
      rows.add(values, weight ? weight_of(row, *weight, place) : 1);
    }
  if (!(rows.sum_of_weights() > 0) || !std::isfinite(rows.sum_of_weights()))
    throw InputError(path + ": " +
                     (rows.empty() ? "no part; expected a line for each part below the heading"
                                   : "the weights of all parts are 0; give one of them more"));
  return rows;
}

// A column that the motor cannot have, such as a voltage beside an amplitude, leaves no part a motor.
void check_fits(const MeasuredParts& parts, const MotorDesign& base, const std::string& place) {
  const std::span<const double> first = parts.rows.draw(0);
  for (std::size_t i = 0; i < parts.parameters.size(); ++i) {
    std::vector<std::string> wrong;
    try {
      wrong = complaints(with(base, parts.parameters[i], first[i]));
    } catch (const InputError& error) {
      wrong = {error.what()};
    }
    if (wrong.empty()) continue;
    throw InputError(place + ": the column " + std::string(info(parts.parameters[i]).name) +
                     " does not fit the motor: " + wrong.front());
  }
}

}  // namespace

PartsTable read_parts(const std::string& path, const std::string& folder, const MotorDesign& base) {
  if (path.empty()) return {};
  const std::filesystem::path typed(path);
  const std::string place = (std::filesystem::path(folder) / typed).string();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(place.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) throw InputError("study.parts: " + quoted(place) + " cannot be read");
  PlainStream plain = plain_stream(place, bytes_of(file.get(), place), is_parameter_heading);
  CsvReader reader(place, std::move(plain.bytes));
  CsvChunk heading;
  if (!reader.read(heading, 1))
    throw InputError(place + ": is empty; expected a heading, and a line for each part");
  const DesignTable table(reader, heading, base, {});
  const std::string name = typed.filename().string();
  PartsTable read{{table.parameters(), {}}, name, {}};
  if (!plain.kind.empty()) read.notes.push_back(name + " is read as: " + plain.kind);
  std::vector<std::string> unused = table.copied();
  if (std::erase_if(unused, is_weight) > 1)
    throw InputError(place + ": the column 'weight' stands there twice; leave one of them out");
  for (const std::string& column : unused)
    read.notes.push_back("column " + quoted(column) + " of " + quoted(name) +
                         " is no parameter and is not used");
  if (read.parts.parameters.empty())
    throw InputError(place +
                     ": no column is a parameter; expected a heading such as 'preload [N]'");
  read.parts.rows = rows_of(table, reader, place);
  check_fits(read.parts, base, place);
  return read;
}

void check_apart(const PartsTable& table, Parameter parameter, std::string_view entry) {
  if (std::ranges::find(table.parts.parameters, parameter) == table.parts.parameters.end()) return;
  throw InputError("study." + std::string(entry) + "." + std::string(info(parameter).name) +
                   ": has a column in study.parts too; leave one of them out");
}

}  // namespace twum::inline v0_1::studies
