// SPDX-License-Identifier: Apache-2.0
#include "study/shapes.hpp"

#include <twum/studies/study/study_file.hpp>

#include <array>
#include <utility>

namespace twum::studies {
namespace {

using namespace shapes;

constexpr std::array<std::string_view, 8> kKinds{"curve",  "sweep", "sensitivity", "optimize",
                                                 "pareto", "size",  "uncertainty", "calibrate"};

// Lines for files to start from.
constexpr const char* kRanges =
    "amplitude: {min: 0.8 um, max: 2.2 um}\n"
    "preload: {min: 60 N, max: 300 N}\n"
    "thickness: {min: 0.1 mm, max: 1 mm, scale: log}";
constexpr const char* kSweep =
    "amplitude: {min: 0.8 um, max: 2.2 um, points: 8}\n"
    "preload: [100 N, 160 N, 220 N]";
constexpr const char* kTolerances =
    "preload: {distribution: normal, mean: 160 N, sd: 8 N}\n"
    "kinetic_friction: {distribution: uniform, min: 0.17, max: 0.23}";
constexpr const char* kEstimates =
    "kinetic_friction: {min: 0.05, max: 0.5}\n"
    "youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}";

Schema curve_study() {
  return mapping("one motor, or a family over one parameter",
                 {optional("family",
                           by_parameter(values_of, "one parameter and its values",
                                        "amplitude: [1.0 um, 1.5 um, 2.0 um]"),
                           "the motor alone"),
                  optional("points", count("points of each curve", "51", 2, 1e6), "51")});
}

Schema sweep_study() {
  return mapping(
      "a grid, list or sample of designs",
      {needed("variables", by_parameter(sweep_range, "what is varied", kSweep)),
       needed("sampling", word("how designs are chosen", {"grid", "list", "lhs", "sobol"})),
       needed("metrics", metrics()),
       hidden(optional("samples", samples(), "1000, for lhs and sobol")),
       hidden(optional("seed", seed(), "1, for lhs and sobol"))});
}

Schema sensitivity_study() {
  Schema method =
      word("local derivatives, screening, or variance shares", {"local", "morris", "sobol"});
  method.example = "sobol";
  return mapping(
      "which parameter matters",
      {needed("method", method),
       needed("variables", by_parameter(range, "what is varied", kRanges)),
       needed("metrics", metrics()),
       optional("samples",
                count("trajectories (morris), or base samples of variables + 2 motors each (sobol, "
                      "rounded up to a power of two, at least 256)",
                      "1024", 1, 1e9),
                "32 for morris, 1024 for sobol"),
       optional("confidence", fraction("level of the confidence intervals", "0.95"), "0.95"),
       hidden(optional(
           "width",
           fraction("sobol: double the samples until no interval is wider than this", "0.05"),
           "one round")),
       hidden(optional("max_samples",
                       count("base samples at which to stop nevertheless", "65536", 1, 1e12),
                       "64 times samples")),
       optional("seed", seed(), "1")});
}

Schema optimize_study() {
  return mapping(
      "best design under constraints",
      {needed("variables", by_parameter(range, "what may be changed", kRanges)),
       either("maximize", metric("what is to be large"), "minimize"),
       instead("minimize", metric("what is to be small"), "maximize"),
       optional("constraints", constraints(), "none"), optional("solver", solver(), "auto"),
       hidden(optional("start", folder(), "the motor as it is"))});
}

Schema objective() {
  return mapping("one objective", {either("maximize", metric("what is to be large"), "minimize"),
                                   instead("minimize", metric("what is to be small"), "maximize")});
}

Schema pareto_study() {
  Schema objectives = list("two or three objectives", objective());
  objectives.min_items = 2;
  objectives.max_items = 3;
  objectives.sample = "- maximize: stall_torque\n- maximize: no_load_speed";
  return mapping("trade-off front of two or three metrics",
                 {needed("variables", by_parameter(range, "what may be changed", kRanges)),
                  needed("objectives", objectives), optional("constraints", constraints(), "none"),
                  optional("points", count("points of the front", "50", 2, 1e5), "50"),
                  optional("solver", solver("200000"), "auto"),
                  hidden(optional("start", folder(), "the motor as it is"))});
}

Schema preferred() {
  Schema schema = metric("what is minimized among the motors that will do");
  schema.example = "max_pressure";
  return schema;
}

Schema size_study() {
  Schema duty = list("operating points the motor must reach",
                     mapping("one operating point",
                             {needed("torque", quantity("load torque", "N.m", "0.5 N.m")),
                              needed("speed", quantity("rotor speed", "rad/s", "100 rpm"))}));
  duty.sample = "- {torque: 0.5 N.m, speed: 100 rpm}";
  return mapping(
      "a motor for a duty",
      {needed("variables", by_parameter(range, "what may be changed", kRanges)),
       needed("duty", duty), optional("limits", constraints(), "none"),
       optional("prefer", preferred(), "max_pressure"), optional("solver", solver(), "auto"),
       hidden(optional("start", folder(), "the motor as it is"))});
}

Schema uncertainty_study() {
  Schema quantiles = list("probabilities", fraction("a probability", "0.05"));
  quantiles.example = "[0.05, 0.5, 0.95]";
  return mapping(
      "spread and yield under tolerances",
      {needed("variables", by_parameter(distribution, "what is uncertain", kTolerances)),
       needed("metrics", metrics()), optional("samples", samples(), "10000"),
       optional("limits", constraints(), "no yield"),
       optional("quantiles", quantiles, "0.05, 0.5, 0.95"), optional("seed", seed(), "1"),
       hidden(optional("start",
                       path("result directory of another study, whose best design or fitted motor "
                            "is varied",
                            "results/first"),
                       "the motor as it is"))});
}

Schema calibrate_study() {
  return mapping(
      "parameters from measured torque-speed points",
      {needed("data",
              path("CSV file with the columns speed [unit] and torque [unit], and if wanted one of "
                   "weight (factor of the point's squared residual; only ratios count) and "
                   "torque_sd [unit] (standard deviation s of the torque: the weight is 1/s^2, and "
                   "the scatter is tested against it)",
                   "points.csv")),
       needed("variables", by_parameter(range, "what is estimated", kEstimates)),
       optional("confidence", fraction("level of the confidence intervals", "0.95"), "0.95"),
       optional("starts", count("local fits from different starts", "8", 1, 10000), "8"),
       optional("seed", seed(), "1")});
}

}  // namespace

std::span<const std::string_view> study_kinds() { return kKinds; }

std::string_view to_string(StudyKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<StudyKind> find_study_kind(std::string_view name) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == name) return static_cast<StudyKind>(i);
  }
  return {};
}

Schema study_schema(StudyKind kind) {
  constexpr std::array<Schema (*)(), 8> kShapes{
      curve_study,  sweep_study, sensitivity_study, optimize_study,
      pareto_study, size_study,  uncertainty_study, calibrate_study};
  Schema schema = kShapes[static_cast<std::size_t>(kind)]();
  SchemaEntry selector =
      needed("kind", word("what the study asks", {std::string(to_string(kind))}));
  schema.entries.insert(schema.entries.begin(), std::move(selector));
  return schema;
}

const Schema& study_file_schema() {
  static const Schema schema = [] {
    Schema study;
    study.kind = ValueKind::variant;
    study.text = "what is asked";
    study.selector = "kind";
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
      study.words.emplace_back(kKinds[i]);
      study.alternatives.push_back(study_schema(static_cast<StudyKind>(i)));
    }
    Schema motor;
    motor.kind = ValueKind::any_of;
    motor.text = "the motor: a path beside this file, or its entries";
    motor.alternatives = {path("a motor file", "ring-60.yaml"), motor_schema()};
    return mapping(
        "a study for twum",
        {motor_file_schema().entries.front(), needed("motor", motor),
         optional("set", by_parameter(value_of, "overrides of the motor", "preload: 140 N"),
                  "the motor as it is"),
         needed("study", study)});
  }();
  return schema;
}

}  // namespace twum::studies
