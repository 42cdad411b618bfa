// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/design_sampler.hpp"

#include "entries/spacing.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {

// A grid point. Integers are rounded, which removes rounding errors of the logarithm.
double DesignSampler::Axis::at(std::uint64_t point) const {
  if (!values.empty()) return values[point];
  const double t = points > 1 ? static_cast<double>(point) / static_cast<double>(points - 1) : 0.0;
  const double value = between(min, max, t, scale);
  return whole ? std::round(value) : value;
}

// The value of a share u in [0, 1): k of n values have the share [k / n, (k + 1) / n) in a list and
// among whole numbers, where on a logarithmic scale the number k has that from log k to log (k + 1).
double DesignSampler::Axis::share(double u) const {
  if (!values.empty()) {
    const auto k = static_cast<std::size_t>(u * static_cast<double>(values.size()));
    return values[std::min(k, values.size() - 1)];
  }
  if (!whole) return between(min, max, u, scale);
  return std::clamp(std::floor(between(min, max + 1, u, scale)), min, max);
}

DesignSampler::Axis DesignSampler::axis_of(const SweepStudy::Variable& variable) {
  return {variable.values, variable.min,   variable.max,
          variable.points, variable.scale, info(variable.parameter).integer};
}

DesignSampler::DesignSampler(const SweepStudy& study) : sampling_(study.sampling) {
  for (const SweepStudy::Variable& variable : study.variables) {
    variables_.push_back(variable.parameter);
    axes_.push_back(axis_of(variable));
  }
  if (sampling_ == Sampling::grid) {
    count_ = 1;
    for (const Axis& axis : axes_) count_ *= axis.size();
    return;
  }
  if (sampling_ == Sampling::list) {
    count_ = axes_.front().size();
    return;
  }
  count_ = study.samples;
  seed_ = study.seed;
  if (sampling_ == Sampling::lhs) hypercube_.emplace(axes_.size(), count_, seed_);
  if (sampling_ == Sampling::sobol) sobol_.emplace(axes_.size(), seed_);
}

void DesignSampler::design(std::uint64_t index, std::span<double> design) const {
  if (sampling_ == Sampling::grid) {
    for (std::size_t i = axes_.size(); i-- > 0;) {
      design[i] = axes_[i].at(index % axes_[i].size());
      index /= axes_[i].size();
    }
    return;
  }
  if (sampling_ == Sampling::list) {
    for (std::size_t i = 0; i < axes_.size(); ++i) design[i] = axes_[i].at(index);
    return;
  }
  if (hypercube_) {
    hypercube_->point(index, design);
  } else {
    sobol_->point(index, design);
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) design[i] = axes_[i].share(design[i]);
}

}  // namespace twum::inline v0_1::studies
