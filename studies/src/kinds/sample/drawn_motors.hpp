// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/earlier_result.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/measured_parts.hpp"

#include <twum/optim/correlation.hpp>
#include <twum/optim/failure_shares.hpp>
#include <twum/studies/tolerance.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A parameter with its distribution.
struct DrawnVariable {
  Parameter parameter;
  Distribution distribution;
  double inadmissible;
  bool normal;

  double draw(double u) const {
    const double value = distribution.quantile(u);
    return info(parameter).integer ? std::round(value) : value;
  }
};

/// A limit and the position of its metric.
struct LimitPlace {
  MotorLimit limit;
  std::size_t metric;
};

/// What the methods of an uncertainty study share: the motor, its tolerances, the limits, and the counts of the motors that break
/// them; internal.
class DrawnMotors : public StudyKindRun {
 public:
  std::uint64_t seed() const override { return seed_; }
  std::optional<MotorDesign> own_motor() const override { return design_; }
  std::vector<std::string> notes() const override;
  std::string_view grows_by() const override { return "study.samples"; }

 protected:
  static constexpr double kConfidence = 0.95;

  DrawnMotors(const UncertaintyStudy& asked, const StudyFile& file);

  /// The answer without numbers.
  UncertaintyResult frame() const;

  /// Which motors break the limits, and why.
  struct Broken {
    optim::FailureShares any;                    ///< of all limits
    std::vector<optim::FailureShares> of_limit;  ///< of each
  };
  Broken nothing_broken() const;
  /// Counts a motor.
  /// @param metrics  its values
  /// @param normals  its standard normal numbers, independent ones; called if it breaks a limit
  void count(Broken& broken, std::uint64_t index, double weight, const double* metrics,
             const std::function<std::vector<double>()>& normals) const;
  /// Sets the shares of the tolerances in the failures, as far as they are known.
  void tell_causes(const Broken& broken, UncertaintyResult& result) const;

  EarlierDesign start_;
  MotorDesign design_;
  std::vector<Tolerance> tolerances_;
  std::vector<DrawnVariable> variables_;
  optim::Correlation correlation_;
  PartsTable table_;
  std::vector<MetricExpression> metrics_;
  std::vector<LimitPlace> limits_;
  VariedParameters varied_;
  RowEvaluator evaluator_;
  std::uint64_t seed_;
  std::string start_name_;
  std::vector<Parameter> nominal_;
};

/// The method `plain`.
std::unique_ptr<StudyKindRun> make_plain_uncertainty(const UncertaintyStudy& asked,
                                                     const StudyFile& file);

}  // namespace twum::inline v0_1::studies
