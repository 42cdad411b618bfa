// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/studies/study.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// The designs of a sweep. Each is computed from its number only, so that a million designs take no memory.
///
/// grid: all combinations, the last variable fastest. list: the n-th value of every variable together. lhs and sobol:
/// a point u of the unit cube, mapped to the range of each variable on a linear or logarithmic scale; integers and
/// listed values have equal shares of u.
class DesignSampler {
 public:
  explicit DesignSampler(const SweepStudy& study);

  const std::vector<Parameter>& variables() const noexcept { return variables_; }
  Sampling sampling() const noexcept { return sampling_; }
  std::uint64_t count() const noexcept { return count_; }
  /// Seed of the random numbers; 0 if there are none.
  std::uint64_t seed() const noexcept { return seed_; }
  /// Values of design `index` < count() [SI]; `design` has room for all variables.
  void design(std::uint64_t index, std::span<double> design) const;

 private:
  // The values of one variable: a list or a range.
  struct Axis {
    std::vector<double> values;
    double min{0};
    double max{0};
    std::uint64_t points{0};
    optim::Scale scale{optim::Scale::linear};
    bool whole{false};

    std::uint64_t size() const { return values.empty() ? points : values.size(); }
    double at(std::uint64_t point) const;
    double share(double u) const;
  };

  static Axis axis_of(const SweepStudy::Variable& variable);

  Sampling sampling_;
  std::vector<Parameter> variables_;
  std::vector<Axis> axes_;
  std::uint64_t count_{0};
  std::uint64_t seed_{0};
  std::optional<optim::LatinHypercube> hypercube_;
  std::optional<optim::SobolSequence> sobol_;
};

}  // namespace twum::inline v0_1::studies
