// SPDX-License-Identifier: Apache-2.0
#include "file/worst_notes.hpp"

#include <twum/base/ordered.hpp>
#include <twum/motors/design_table.hpp>

#include <algorithm>

namespace twum::inline v0_1::motors {
namespace {

constexpr std::size_t kRowsAtATime = 256;

struct Block {
  CsvChunk rows;
  std::string result;
  std::size_t failed{0};
  std::size_t empty{0};
  std::size_t bytes{0};  // of the stream up to the end of this block
  WorstNotes notes;
};

void evaluate_block(const DesignTable& table, Block& block) {
  DesignTable::Scratch scratch;
  for (std::size_t i = 0; i < block.rows.records.size(); ++i) {
    const std::size_t line = block.rows.records[i].line;
    const bool ok = table.append_result(block.rows.record(i), line, scratch, block.result);
    if (scratch.notes) block.notes.add(*scratch.notes, "line " + std::to_string(line));
    block.failed += ok ? 0 : 1;
    block.empty += table.any_answer(scratch) ? 0 : 1;
  }
}

}  // namespace

DesignCounts evaluate_table(CsvReader& reader, const DesignTable& table, unsigned jobs,
                            const std::function<void(std::string_view)>& write,
                            const std::function<bool()>& proceed,
                            const std::function<void(const DesignCounts&)>& progress) {
  DesignCounts counts;
  WorstNotes notes;
  write(table.result_header());
  run_ordered<Block>(
      jobs,
      [&](Block& block) {
        const bool more = proceed() && reader.read(block.rows, kRowsAtATime);
        block.bytes = reader.bytes_taken();
        return more;
      },
      [&](Block& block) { evaluate_block(table, block); },
      [&](Block& block) {
        write(block.result);
        counts.rows += block.rows.records.size();
        counts.failed += block.failed;
        counts.empty += block.empty;
        counts.bytes = block.bytes;
        notes.add(block.notes);
        progress(counts);
      });
  counts.notes = notes.texts();
  return counts;
}

}  // namespace twum::inline v0_1::motors
