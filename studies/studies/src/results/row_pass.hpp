// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/study_result.hpp>
#include <twum/studies/store/result_store.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {

/// Counts rows failed or incomplete by reason, and where the variables were.
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

/// The rows of a store as the text of a CSV table, and the failures among them, in one pass.
/// Columns are "name [unit]" in SI, or "name" where words stand for the values, a stage where there is more than one, and the
/// status.
/// @param columns    those of the store, with their words
/// @param variables  how many of them are variables
/// @param put  takes the text piece by piece
FailureCount write_rows(const ResultStore& store, const std::vector<StoredColumn>& columns,
                        std::size_t variables, const std::function<void(std::string_view)>& put);

}  // namespace twum::studies
