// SPDX-License-Identifier: Apache-2.0
#include <twum/io/result_store.hpp>

#include "store/database.hpp"

namespace twum::inline v0_1::io {

ResultStore::ResultStore(const std::string& path, const std::vector<StoredColumn>& columns,
                         const std::stop_token& stop)
    : database_(std::make_unique<Database>(path, columns, stop)) {}

ResultStore::ResultStore(const std::string& path, const std::stop_token& stop)
    : database_(std::make_unique<Database>(path, stop)) {}

ResultStore::~ResultStore() = default;

const std::vector<StoredColumn>& ResultStore::columns() const noexcept {
  return database_->columns();
}

void ResultStore::require(const std::vector<StoredColumn>& columns) const {
  database_->require(columns);
}

void ResultStore::add(const StoredRow& row) { database_->add(row); }

void ResultStore::flush() { database_->flush(); }

std::uint64_t ResultStore::next_index(std::uint64_t stage) const {
  return database_->next_index(stage);
}

std::uint64_t ResultStore::rows() const { return database_->rows(); }

std::vector<std::uint64_t> ResultStore::stages() const {
  std::vector<std::uint64_t> stages;
  for (auto stage = database_->stage_from(0); stage; stage = database_->stage_from(*stage + 1))
    stages.push_back(*stage);
  return stages;
}

void ResultStore::read(const std::function<void(const StoredRow&)>& visit) const {
  for (const std::uint64_t stage : stages()) read(stage, visit);
}

void ResultStore::read(std::uint64_t stage,
                       const std::function<void(const StoredRow&)>& visit) const {
  for (std::vector<StoredRow> page = database_->page(stage, 0); !page.empty();) {
    for (const StoredRow& row : page) visit(row);
    const std::uint64_t next = page.back().index + 1;
    page = database_->page(stage, next);
    if (!page.empty() && page.front().index < next)
      throw StoreError("results.db: is damaged: the rows of stage " + std::to_string(stage) +
                       " are not in order");
  }
}

std::string ResultStore::fact(const std::string& name) const { return database_->fact(name); }

void ResultStore::set_fact(const std::string& name, const std::string& value) {
  database_->set_fact(name, value);
}

}  // namespace twum::inline v0_1::io
