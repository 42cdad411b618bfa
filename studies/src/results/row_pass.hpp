// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>
#include <twum/studies/study_result.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {

/// Counts failed or incomplete rows by reason, with the ranges of their variables.
class FailureCount {
 public:
  /// @param variables  the first columns of the rows
  explicit FailureCount(std::vector<StoredColumn> variables) : variables_(std::move(variables)) {}
  void see(const StoredRow& row);
  /// The most frequent first.
  std::vector<FailureRegion> regions() const;

 private:
  std::vector<StoredColumn> variables_;
  std::map<std::string, FailureRegion> by_reason_;
};

/// Writes the rows of a store as a CSV table and counts the failures in one pass. Columns are "name [unit]" in SI, or
/// "name" for words; a stage if there is more than one; and the status.
/// @param columns    those of the store, with their words
/// @param variables  how many of them are variables
/// @param put  receives the text piece by piece
FailureCount write_rows(const ResultStore& store, const std::vector<StoredColumn>& columns,
                        std::size_t variables, const std::function<void(std::string_view)>& put);

}  // namespace twum::inline v0_1::studies
