// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/stored_medians.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

constexpr unsigned kDigitBits = 16;
constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;

// Integers in the same order as the doubles that they represent, and the inverse.
std::uint64_t key_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}
double value_of(std::uint64_t key) {
  return std::bit_cast<double>((key & kSign) != 0 ? key & ~kSign : ~key);
}

// Finds a number of given rank by its digits, the highest first: each pass counts the next digit among
// the numbers that begin with those found.
class RankSearch {
 public:
  void begin_pass(unsigned shift) {
    shift_ = shift;
    counts_.assign(std::size_t{1} << kDigitBits, 0);
  }

  void add(double value) {
    if (std::isnan(value)) return;
    const std::uint64_t key = key_of(value);
    if (shift_ + kDigitBits < 64 && (key >> (shift_ + kDigitBits)) != found_) return;
    ++counts_[(key >> shift_) & ((std::uint64_t{1} << kDigitBits) - 1)];
  }

  // `choose` returns the wanted rank, from 0, for a count of numbers.
  template <typename Choose>
  void end_pass(Choose choose) {
    if (shift_ + kDigitBits == 64) {
      std::uint64_t all = 0;
      for (const std::uint64_t count : counts_) all += count;
      any_ = all > 0;
      rank_ = any_ ? choose(all) : 0;
    }
    if (!any_) return;
    std::size_t digit = 0;
    while (rank_ >= counts_[digit]) rank_ -= counts_[digit++];
    found_ = (found_ << kDigitBits) | digit;
  }

  double value() const {
    return any_ ? value_of(found_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  unsigned shift_{0};
  std::vector<std::uint64_t> counts_;
  std::uint64_t found_{0};
  std::uint64_t rank_{0};
  bool any_{false};
};

}  // namespace

std::vector<double> stored_medians(const ResultStore& store, std::uint64_t stage,
                                   std::size_t first_column) {
  std::vector<RankSearch> searches(store.columns().size() - first_column);
  for (unsigned shift = 64; shift > 0;) {
    shift -= kDigitBits;
    for (RankSearch& search : searches) search.begin_pass(shift);
    store.read(stage, [&](const StoredRow& row) {
      for (std::size_t i = 0; i < searches.size(); ++i)
        searches[i].add(row.values[first_column + i]);
    });
    for (RankSearch& search : searches)
      search.end_pass([](std::uint64_t count) { return (count - 1) / 2; });
  }
  std::vector<double> medians;
  for (const RankSearch& search : searches) medians.push_back(search.value());
  return medians;
}

}  // namespace twum::inline v0_1::studies
