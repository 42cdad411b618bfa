// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/batch.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/units.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/model_notes.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {
struct Heading;
}

namespace twum::inline v0_1::motors {

/// True for a heading that names a parameter, with or without a unit: what plain_stream() looks for in tables of designs.
bool is_parameter_heading(std::string_view heading);

/// True if one of the expressions has a value. If metrics were asked for, parameters do not count.
bool any_answer(std::span<const MetricExpression> asked, std::span<const MetricValue> values);

/// A table with one design in each row. Columns named like parameters (with an optional "[unit]", "(unit)" or "/ unit") replace
/// the parameters of a base motor. Lines that begin with # are remarks. Other columns are copied to the result, except those that the result computes itself.
/// Cells that a spreadsheet would run as a formula get a leading apostrophe (append_cell()).
class DesignTable {
 public:
  /// @param header  the first record of the table
  /// @throws InputError with everything that is wrong with the header: an unknown or wrong unit, a
  ///         parameter twice or together with its alternative, no parameter at all.
  DesignTable(const CsvReader& reader, const CsvChunk& header, const MotorDesign& base,
              std::vector<MetricExpression> metrics);

  /// Header of the result: the table's own, one column for each metric, and "status"; with line end.
  std::string result_header() const;

  /// Warnings about the columns, such as one that looks like a mistyped parameter.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }
  /// Number of columns of the table, including those that are copied.
  std::size_t columns() const noexcept { return columns_.size(); }
  /// True if a column replaces the parameter.
  bool has(Parameter parameter) const;

  /// The parameters of the columns, in their order.
  std::vector<Parameter> parameters() const;
  /// Names of the columns that are no parameters, in their order.
  std::vector<std::string> copied() const;
  /// Position of the column with this heading.
  std::optional<std::size_t> column_named(std::string_view heading) const;

  struct Scratch;
  /// Reads the parameters of a row into scratch.values, in the order of parameters(). False if something is wrong: scratch.reason
  /// then says what, without the line.
  bool read_row(std::string_view record, Scratch& scratch) const;
  /// True if the row has an answer, see any_answer().
  bool any_answer(const Scratch& scratch) const;

  /// Buffers of one thread.
  struct Scratch {
    std::vector<std::string_view> cells;          ///< of the row being read
    std::vector<ParameterValue> values;           ///< of its parameter columns, SI
    std::vector<MetricValue> metrics;             ///< its results
    std::string reason;                           ///< why it has none; empty if it has results
    std::optional<std::vector<ModelNote>> notes;  ///< notes on the motor of the row, if it is valid
    bool well_formed{true};                       ///< its quotation marks are in the right places
  };

  /// Evaluates one row and appends it to `out` with its metrics and status; true if its status is ok. A row that is
  /// malformed or has no answer gets empty metrics and the reason, and nothing is thrown. Thread-safe if each thread
  /// has its own scratch. Takes about the time of the metrics.
  /// @param line  line of the row in its file, for the reason
  bool append_result(std::string_view record, std::size_t line, Scratch& scratch,
                     std::string& out) const;

 private:
  struct TableColumn {
    std::string name;                    // for a parameter column, its name as typed
    std::string heading;                 // with its unit
    std::optional<Parameter> parameter;  // nothing: the column is copied
    Scale scale;
    bool computed{false};  // the result computes a column with this heading
  };

  TableColumn read_column(const std::string& text);
  TableColumn parameter_column(const std::string& text, const Heading& heading,
                               const ParameterInfo& row);
  void warn_of_copy(const std::string& text);
  void check_alternatives(std::vector<std::string>& wrong) const;
  DesignOutcome<std::vector<MetricValue>> metrics(Scratch& scratch) const;
  DesignOutcome<std::vector<MetricValue>> parameters(const Scratch& scratch) const;
  bool compute(std::string_view record, std::size_t line, Scratch& scratch) const;
  bool read_values(Scratch& scratch) const;
  bool is_computed(const std::string& heading) const;
  void add_column_warnings();
  void append_columns(const std::vector<std::string_view>& cells, std::string& out) const;

  MotorDesign base_;
  std::vector<MetricExpression> metrics_;
  ExpressionEvaluator evaluator_;
  std::string header_;
  std::vector<TableColumn> columns_;
  // parameter columns without a unit, with the unit in which they are read
  std::vector<std::string> without_unit_;
  std::vector<std::string> warnings_;
};

/// Counts of evaluate_table().
struct DesignCounts {
  std::size_t rows{0};    ///< rows done
  std::size_t failed{0};  ///< rows whose status is not ok
  std::size_t empty{0};   ///< of these, rows without any_answer()
  std::size_t bytes{0};   ///< bytes of the table read so far
  /// Reasons to doubt the model for these designs, one sentence each, with the worst design; see model_notes().
  /// Complete at the end only.
  std::vector<std::string> notes;
};

/// Evaluates every row of a table and writes the result, on `jobs` threads, in the order of the rows;
/// the text does not depend on the number of threads.
/// @param write     receives the result piece by piece
/// @param proceed   called between blocks of rows; false ends the run after the blocks that have begun
/// @param progress  called with the counts now and then
/// @throws InputError as CsvReader::read(), after the rows before it are written; and whatever `write` throws
DesignCounts evaluate_table(CsvReader& reader, const DesignTable& table, unsigned jobs,
                            const std::function<void(std::string_view)>& write,
                            const std::function<bool()>& proceed,
                            const std::function<void(const DesignCounts&)>& progress);

}  // namespace twum::inline v0_1::motors
