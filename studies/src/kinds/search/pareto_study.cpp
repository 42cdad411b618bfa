// SPDX-License-Identifier: Apache-2.0
#include "entries/solver_entry.hpp"
#include "kinds/robust/built_motors.hpp"
#include "kinds/robust/front_points.hpp"
#include "kinds/robust/robust_front.hpp"
#include "kinds/search/search_study.hpp"
#include "problem/multi_start.hpp"

#include <twum/optim/certify.hpp>
#include <twum/optim/pareto.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// Metrics in place of statistics, each once.
std::vector<DesignObjective> nominal_goals(const ParetoStudy& asked) {
  std::vector<DesignObjective> list;
  for (const DesignObjective& goal : asked.objectives) {
    DesignObjective nominal = nominal_goal(goal, asked.constraints);
    const bool known = std::any_of(list.begin(), list.end(), [&](const DesignObjective& other) {
      return other.text() == nominal.text();
    });
    if (!known) list.push_back(std::move(nominal));
  }
  return list;
}

// A trade-off front: by gradients, or by an evolutionary search if the file says so.
class ParetoRun : public SearchRun {
 public:
  ParetoRun(const ParetoStudy& asked, const StudyFile& file)
      : SearchRun(file,
                  {{},
                   asked.variables,
                   nominal_goals(asked),
                   asked.constraints,
                   asked.derived,
                   asked.choose},
                  asked.solver, asked.start),
        points_(asked.points),
        goals_(asked.objectives),
        built_(built_motors_asked(asked, file)),
        motors_([this](const BuiltQuestion&) { return question(); }) {}

  std::vector<std::string> notes() const override {
    return built_.table.notes_after(SearchRun::notes());
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    return is_of_built_motor(asked) ? motors_.answer(asked) : SearchRun::recompute(asked);
  }

  /// Under tolerances the certificates are those of rounds, which follow from the rows before them.
  std::optional<optim::Certificate> certify(std::span<const double> variables,
                                            std::span<const ParameterValue> design) const override {
    return !built_.scatter() ? SearchRun::certify(variables, design) : std::nullopt;
  }

  KindAnswer run(RunContext& context) override {
    SearchLog log(problem(), context);
    if (built_.scatter()) return under_tolerances(log, context);
    optim::SolveOptions solve = options(log, context);
    const optim::Front front = solve.solver == kNsga2 ? by_population(log.problem(), solve)
                                                      : by_gradients(log.problem(), solve);
    context.store.flush();
    return {outcome(front.outcome, context), answer(front)};
  }

 private:
  optim::Front by_gradients(const optim::Problem& problem, const optim::SolveOptions& solve) const {
    optim::ParetoOptions options;
    options.solve = solve;
    options.points = points_;
    return optim::pareto_front(problem, options);
  }

  optim::Front by_population(const optim::Problem& problem,
                             const optim::SolveOptions& solve) const {
    optim::Nsga2Options options;
    options.solve = solve;
    options.population = std::max<std::size_t>(4, points_ + points_ % 2);
    return optim::nsga2(problem, options);
  }

  ParetoResult answer(const optim::Front& front) const {
    const DesignReporter reports = reporter();
    ParetoResult result;
    result.goals = reports.goals();
    for (const optim::FrontPoint& point : front.points) {
      DesignReport report = reports.report(point.design, point.certificate);
      const auto& values = point.evaluation.values;
      result.front.push_back(
          {{values.begin(), values.begin() + static_cast<std::ptrdiff_t>(result.goals.size())},
           std::move(report),
           {}});
    }
    if (!result.front.empty()) {
      result.ends = ends_of(result);
      result.knee = knee_of(result);
      for (std::size_t k = 0; k < result.ends.size() && certified(front); ++k)
        result.single_goal_ends.push_back(alone(k, front.points[result.ends[k]].design));
    }
    result.hypervolume = front.hypervolume;
    result.reference_point = front.reference;
    result.before_design = reports.design_of(before());
    result.before_metrics = reports.metrics_of(before());
    result.explanation = reports.explanation(front.infeasibility);
    return result;
  }

  RobustQuestion question() const {
    RobustQuestion question = built_.question(problem());
    question.design.objectives = goals_;
    return question;
  }

  // If no design has the wanted yield, checks whether a design without tolerances meets the limits at all.
  KindAnswer under_tolerances(SearchLog& log, RunContext& context) const {
    KindAnswer found =
        robust_front({question(), problem(), reporter(), options(context), points_}, context);
    auto& result = std::get<ParetoResult>(found.answer);
    result.parts = built_.table.name;
    result.part_count = built_.table.parts.rows.size();
    result.before_design = reporter().design_of(before());
    result.before_metrics = reporter().metrics_of(before());
    if (found.outcome != StudyOutcome::infeasible) return found;
    const optim::SolveOptions solve = options(log, context);
    result.explanation = reporter().explanation(
        problem().objectives.size() > 1 ? by_gradients(log.problem(), solve).infeasibility
                                        : solve_from_starts(log.problem(), solve).infeasibility);
    context.store.flush();
    return found;
  }

  // nsga2() certifies nothing.
  static bool certified(const optim::Front& front) {
    return std::any_of(front.points.begin(), front.points.end(),
                       [](const auto& p) { return !p.certificate.weights.empty(); });
  }

  // Certifies an end of the front for its own goal only. The weights of the goals are not unique there, since as many
  // limits may be active as there are variables.
  DesignReport alone(std::size_t goal, const std::vector<double>& design) const {
    DesignProblem one = problem();
    one.objectives = {problem().objectives[goal]};
    return DesignReporter(one, {}).report(design, certificate(one, design));
  }

  std::size_t points_;
  // goals of the study; those of problem() have a value without tolerances
  std::vector<DesignObjective> goals_;
  BuiltMotorsAsked built_;
  BuiltMotorRows motors_;
};

}  // namespace

std::unique_ptr<StudyKindRun> ParetoStudy::run(const StudyFile& file) const {
  return std::make_unique<ParetoRun>(*this, file);
}

}  // namespace twum::inline v0_1::studies
