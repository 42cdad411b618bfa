// SPDX-License-Identifier: Apache-2.0
// A kind of study as an exercise: its fields, its runner, its part of summary.json, and what is said of its answer.
#include "entries/entry_shapes.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "results/answers.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

class SqueezeRun : public StudyKindRun {
 public:
  SqueezeRun(std::uint64_t points, const MotorDesign& motor)
      : points_(points),
        motor_(motor),
        evaluator_(VariedParameters(motor, {Parameter::preload}, {}),
                   {parse_metric("holding_torque")}) {}

  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return 1; }

  KindAnswer run(RunContext& context) override {
    const bool complete = store_rows(context, 0, points_);
    SqueezeResult result;
    context.store.read([&](const StoredRow& row) {
      result.preloads.push_back(row.values[0]);
      result.torques.push_back(row.values[1]);
    });
    return {complete ? StudyOutcome::done : StudyOutcome::interrupted, std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index >= points_) return {};
    StoredRow row{0, asked.index, {}, "ok", {}};
    const double share = static_cast<double>(asked.index) / static_cast<double>(points_ - 1);
    const double preload = motor_.preload * std::lerp(0.5, 2.0, share);
    evaluator_.evaluate({&preload, 1}, row);
    return row;
  }

 private:
  std::uint64_t points_;
  MotorDesign motor_;
  RowEvaluator evaluator_;
};

}  // namespace

Shape<SqueezeStudy> SqueezeStudy::shape() {
  using namespace shapes;
  return mapping<SqueezeStudy>(
      "the holding torque over the preload",
      {kind_field<SqueezeStudy>(),
       standard<SqueezeStudy>("points", count("preloads", "5", 2, 1e6), &SqueezeStudy::points)});
}

std::unique_ptr<StudyKindRun> SqueezeStudy::run(const StudyFile& file) const {
  return std::make_unique<SqueezeRun>(points, file.motor.design);
}

Json answer_json(const SqueezeResult& result) {
  return {{"preloads", result.preloads}, {"torques", result.torques}};
}

namespace telling {

Headline headline_of(const SqueezeResult& answer, const StudyResult& /*result*/) {
  const std::size_t last = answer.torques.size() - 1;
  return {Headline::Look::plain,
          "",
          {{"A preload of ", value_part(answer.preloads[last], "N"), " holds ",
            strong(value_part(answer.torques[last], "N.m")), "."}},
          {}};
}

std::vector<Section> sections_of(const SqueezeResult& answer, const Sources& /*sources*/) {
  Section section{{"Held by the preload"}, {"Friction holds as much as it is squeezed."}};
  Chart chart{"squeeze", {"torque over preload"}, {{"preload"}, "N"}, {{"torque"}, "N.m", true}};
  chart.series = {{"", Stroke::line, {"preloads", answer.preloads}, {"torques", answer.torques}}};
  section.charts = {chart};
  Table table{"squeeze", {{"preload"}, {"torque"}}, {}};
  for (std::size_t i = 0; i < answer.torques.size(); ++i)
    table.rows.push_back(
        {{value_part(answer.preloads[i], "N")}, {value_part(answer.torques[i], "N.m")}});
  section.tables = {table};
  return {section};
}

}  // namespace telling
}  // namespace twum::inline v0_1::studies
