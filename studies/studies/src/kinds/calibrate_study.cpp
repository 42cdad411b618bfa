// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibration.hpp"
#include "kinds/executor.hpp"
#include "kinds/measured_fit.hpp"
#include "kinds/metric_gradients.hpp"
#include "kinds/study_kind.hpp"
#include "kinds/unit_box.hpp"

#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/engineering.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <mutex>

namespace twum::studies {
namespace {

// A path that leads nowhere is the study's mistake; what is wrong inside the file is the file's.
MeasuredPoints points_of(const std::string& path) {
  try {
    return read_measured_points(path);
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) +
                     "; expected measured points, from the folder of the study: a CSV file with "
                     "the columns 'speed [rpm],torque [N.m]'");
  }
}

std::vector<std::string> unit_notes(const MeasuredPoints& table) {
  std::string names;
  for (const std::string& heading : table.without_unit)
    names += (names.empty() ? "" : ", ") + heading;
  if (names.empty()) return {};
  return {"the headings of the measured points have no unit, so that they are read in SI units: " +
          names};
}

// The fit that is asked for, and what is to be said of its points.
struct AskedFit {
  MeasuredFit fit;
  std::vector<std::string> notes;
};

// What a column sets cannot be estimated as well.
void refuse_set(const MeasuredPoints& table, const CalibrateStudy& asked, const std::string& path) {
  std::vector<Parameter> given = parameters_of(asked.variables);
  for (const DerivedParameter& rule : asked.derived) given.push_back(rule.parameter);
  for (const MeasuredPoint& point : table.points) {
    for (const auto& [parameter, value] : point.set) {
      const ParameterInfo& row = info(parameter);
      const bool twice = std::any_of(given.begin(), given.end(), [&](Parameter other) {
        return other == row.parameter || row.twin == other;
      });
      if (twice)
        throw InputError(path + ": the column '" + std::string(row.name) +
                         "' sets what the study estimates; leave out the column, or the variable");
    }
  }
}

AskedFit fit_of(const CalibrateStudy& asked, const StudyFile& file) {
  std::vector<MeasuredPoints> tables;
  std::string paths;
  for (const std::string& name : asked.data) {
    const std::string path = (std::filesystem::path(file.folder) / name).string();
    paths += (paths.empty() ? "" : ", ") + path;
    tables.push_back(points_of(path));
    refuse_set(tables.back(), asked, path);
  }
  MeasuredPoints table = joined(std::move(tables));
  std::vector<MeasuredPoint>& points = table.points;
  if (points.size() < asked.variables.size())
    throw InputError(paths + ": " + counted(points.size(), "point") + " cannot determine " +
                     counted(asked.variables.size(), "parameter") +
                     "; measure more points or estimate fewer parameters");
  if (points.front().deviation == 0 && asked.scatter == Scatter::stated)
    throw InputError(
        paths +
        ": no standard deviations, on which 'scatter: stated' stands; add a column such "
        "as 'torque_sd [mN.m]', or leave out 'scatter'");
  std::vector<std::string> notes = unit_notes(table);
  return {{file.motor.design, asked.variables, std::move(points), asked.derived}, std::move(notes)};
}

// How far the fits are, for the eye.
class Teller {
 public:
  Teller(const RunContext& context, std::string unit) : context_(context), unit_(std::move(unit)) {}

  void see(double rms) {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (!(rms >= best_)) best_ = rms;
    if (!context_.progress) return;
    const std::string text = std::isnan(best_) ? "" : "residual_rms " + engineering(best_, unit_);
    context_.progress({.done = done_, .best = text});
  }

 private:
  const RunContext& context_;
  std::string unit_;
  std::mutex mutex_;
  std::uint64_t done_{0};
  double best_{std::numeric_limits<double>::quiet_NaN()};
};

// How often the search for intervals may find a better fit; more than one is rare.
constexpr int kMostRounds = 4;

class CalibrateRun final : public StudyKindRun {
 public:
  CalibrateRun(const CalibrateStudy& asked, AskedFit fit)
      : fit_(std::move(fit.fit)),
        notes_(std::move(fit.notes)),
        starts_(asked.starts),
        solver_(optim::least_squares_solvers()[static_cast<std::size_t>(asked.solver)].name),
        seed_(asked.seed),
        confidence_(asked.confidence),
        stated_(asked.scatter == Scatter::stated) {}

  std::vector<Column> columns() const override {
    std::vector<Column> columns;
    for (const DesignVariable& range : fit_.parameters()) {
      const ParameterInfo& row = info(range.parameter);
      columns.push_back({std::string(row.name), std::string(row.unit)});
    }
    columns.push_back({"residual_rms", fit_.unit()});
    return columns;
  }

  std::size_t variables() const override { return fit_.parameters().size(); }
  std::uint64_t seed() const override { return seed_; }
  std::vector<std::string> notes() const override { return notes_; }

  KindAnswer run(RunContext& context) override {
    const auto starts = start_values();
    Teller teller(context, fit_.unit());
    auto fits = in_order<optim::LeastSquaresResult>(
        context, starts_, [&](std::uint64_t i) { return one_fit(context, i, starts[i], teller); });
    std::vector<ProfiledInterval> found;
    std::uint64_t stage = starts_;
    for (int round = 0; round < kMostRounds && best_fit(fit_, fits); ++round) {
      found = intervals(context, fits[*best_fit(fit_, fits)], stage, teller);
      stage += 2 * variables();
      const std::vector<double> better = better_place(found);
      if (better.empty() || context.stop.stop_requested()) break;
      fits.push_back(one_fit(context, stage++, better, teller));
    }
    return calibration(fit_, fits, confidence_, found);
  }

  std::optional<Row> recompute(const Row& asked) const override {
    const std::span values(asked.values.data(), variables());
    return row(asked.stage, asked.index, values, fit_.residuals(values));
  }

 private:
  // The evaluations of one stage: those that are stored, and on from where they end. A stage is a function of the study
  // alone, so that it goes the same way again.
  class StageLog {
   public:
    StageLog(const CalibrateRun& run, RunContext& context, std::uint64_t stage, Teller& teller)
        : run_(run), context_(context), stage_(stage), teller_(teller) {
      context.store.read(stage, [&](const Row& row) {
        if (row.index == stored_.size()) stored_.push_back(row);
      });
    }

    optim::Residuals residuals(std::span<const double> values) {
      const std::uint64_t at = next_++;
      const bool known = at < stored_.size();
      if (known && !run_.same_design(stored_[at], values))
        throw StoreError("the stored evaluations do not belong to this study");
      const Row one = known ? stored_[at] : context_.executor.row(question(stage_, at, values));
      if (!known) context_.store.add(one);
      teller_.see(one.values.back());
      return run_.answer_of(one);
    }

   private:
    const CalibrateRun& run_;
    RunContext& context_;
    std::uint64_t stage_;
    Teller& teller_;
    std::vector<Row> stored_;
    std::uint64_t next_{0};
  };

  template <typename Item, typename Make>
  static std::vector<Item> in_order(RunContext& context, std::uint64_t count, Make make) {
    std::vector<Item> items;
    run_indexed(
        {0, count, context.executor.lanes(), [&] { return !context.stop.stop_requested(); }}, make,
        [&](std::uint64_t, auto& found) { std::ranges::move(found, std::back_inserter(items)); });
    return items;
  }

  optim::LeastSquaresOptions options(const RunContext& context) const {
    optim::LeastSquaresOptions options;
    options.solver = solver_;
    options.confidence = confidence_;
    if (stated_) options.deviation = fit_.stated_deviation();
    options.stop = context.stop;
    return options;
  }

  optim::LeastSquaresResult one_fit(RunContext& context, std::uint64_t stage,
                                    std::span<const double> start, Teller& teller) const {
    StageLog log(*this, context, stage, teller);
    return optim::least_squares(
        fit_.variables(start), [&](auto values) { return log.residuals(values); },
        options(context));
  }

  // A place that the search for intervals met and that fits better than the fit.
  static std::vector<double> better_place(const std::vector<ProfiledInterval>& intervals) {
    for (const ProfiledInterval& one : intervals) {
      for (const auto& end : {one.low, one.high})
        if (end && !end->better.empty()) return end->better;
    }
    return {};
  }

  // Two stages for each parameter. Nothing is to be found where the residuals are
  // rounding, nor for a parameter that is held or not determined.
  std::vector<ProfiledInterval> intervals(RunContext& context,
                                          const optim::LeastSquaresResult& best,
                                          std::uint64_t stage, Teller& teller) const {
    const std::size_t n = best.estimates.size();
    std::vector<ProfiledInterval> list(n);
    const bool ended =
        best.outcome == optim::Outcome::optimal || best.outcome == optim::Outcome::feasible;
    if (!ended || fit_.exact(root_mean(best, fit_))) return list;
    const auto ends = in_order<std::optional<optim::ProfileEnd>>(
        context, 2 * n, [&](std::uint64_t i) { return profiled(context, best, i, stage, teller); });
    for (std::size_t i = 0; i < ends.size(); ++i)
      (i % 2 == 0 ? list[i / 2].low : list[i / 2].high) = ends[i];
    return list;
  }

  std::optional<optim::ProfileEnd> profiled(RunContext& context,
                                            const optim::LeastSquaresResult& best,
                                            std::uint64_t number, std::uint64_t stage,
                                            Teller& teller) const {
    const optim::Estimate& e = best.estimates[number / 2];
    if (e.at_bound || !(e.standard_deviation > 0)) return {};
    StageLog log(*this, context, stage + number, teller);
    const optim::ProfileEnd end = optim::profile_end(
        fit_.variables({}), [&](auto values) { return log.residuals(values); }, options(context),
        best, number / 2, number % 2 == 0 ? optim::IntervalEnd::low : optim::IntervalEnd::high);
    if (context.stop.stop_requested()) return {};  // unfinished
    return end;
  }

  // Empty for the first: where the study or the motor says.
  std::vector<std::vector<double>> start_values() const {
    std::vector<std::vector<double>> starts{{}};
    if (starts_ < 2) return starts;
    const UnitBox box(fit_.parameters());
    for (const auto& unit : optim::sobol_points(box.size(), starts_ - 1, seed_))
      starts.push_back(box.values(unit));
    return starts;
  }

  Row row(std::uint64_t stage, std::uint64_t index, std::span<const double> values,
          const optim::Residuals& residuals) const {
    Row row;
    row.stage = stage;
    row.index = index;
    row.values.assign(values.begin(), values.end());
    if (!residuals.failure.empty()) {
      row.values.push_back(std::numeric_limits<double>::quiet_NaN());
      row.status = residuals.failure;
      return row;
    }
    row.values.push_back(fit_.rms(residuals.values));
    std::vector<double> numbers = residuals.values;
    numbers.insert(numbers.end(), residuals.jacobian.begin(), residuals.jacobian.end());
    row.detail = packed(numbers);
    return row;
  }

  static Row question(std::uint64_t stage, std::uint64_t index, std::span<const double> values) {
    return {stage, index, {values.begin(), values.end()}, "ok", {}};
  }

  optim::Residuals answer_of(const Row& row) const {
    optim::Residuals residuals;
    if (row.status != "ok") {
      residuals.failure = row.status;
      return residuals;
    }
    const std::vector<double> numbers = unpacked(row.detail);
    const std::size_t count = fit_.points().size();
    if (numbers.size() != count * (1 + variables()))
      throw StoreError("the stored evaluations are damaged: a row has a wrong length");
    const auto values_end = numbers.begin() + static_cast<std::ptrdiff_t>(count);
    residuals.values.assign(numbers.begin(), values_end);
    residuals.jacobian.assign(values_end, numbers.end());
    return residuals;
  }

  bool same_design(const Row& row, std::span<const double> values) const {
    return std::memcmp(row.values.data(), values.data(), values.size_bytes()) == 0;
  }

  MeasuredFit fit_;
  std::vector<std::string> notes_;
  std::uint64_t starts_;
  std::string solver_;
  std::uint64_t seed_;
  double confidence_;
  bool stated_;  // the intervals stand on the standard deviations of the data
};

}  // namespace

std::unique_ptr<StudyKindRun> CalibrateStudy::run(const StudyFile& file) const {
  return std::make_unique<CalibrateRun>(*this, fit_of(*this, file));
}

}  // namespace twum::studies
