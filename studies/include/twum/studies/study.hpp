// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motion/control.hpp>
#include <twum/motion/motion.hpp>
#include <twum/motors/column_choice.hpp>
#include <twum/motors/statistic.hpp>
#include <twum/motors/varied_parameters.hpp>
#include <twum/optim/options.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/tolerance.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// @file
/// The questions of all study kinds as plain values in SI units. This is the only place of their defaults.

namespace twum::inline v0_1::io {
template <typename T>
struct Shape;
}

namespace twum::inline v0_1::studies {

class StudyKindRun;
struct StudyFile;

/// Torque-speed curves of one motor, or of a family over one parameter.
struct CurveStudy {
  static constexpr std::string_view kName{"curve"};                 ///< as in `kind:`
  static constexpr std::string_view kTitle{"torque-speed curves"};  ///< what it asks for
  static Shape<CurveStudy> shape();                                 ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// One parameter and its values.
  struct Family {
    Parameter parameter{};         ///< which one
    std::vector<double> values{};  ///< SI, at least one
  };
  std::optional<Family> family{};  ///< none: the motor alone
  std::uint64_t points{51};        ///< of each curve, at least 2
};

/// Which way a frequency is swept.
enum class SweepDirection : unsigned char { up, down, both };
/// As in a study file; static lifetime.
const char* to_string(SweepDirection value) noexcept;

/// Slow sweeps of the drive's frequency, of one motor under a voltage or of a family over one parameter.
struct FrequencyStudy {
  static constexpr std::string_view kName{"frequency"};                ///< as in `kind:`
  static constexpr std::string_view kTitle{"sweep of the frequency"};  ///< what it asks for
  static Shape<FrequencyStudy> shape();                                ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::optional<CurveStudy::Family> family{};  ///< none: the motor alone
  std::optional<double> from{};                ///< [Hz]; none: below all resonances and jumps
  std::optional<double> to{};                  ///< [Hz]; none: above all jumps
  std::uint64_t points{201};                   ///< of each sweep, at least 2
  /// Load [N m]; more than one are a family over it; none: 0, unless a speed is given.
  std::optional<std::vector<double>> torque{};
  std::optional<double> speed{};  ///< speed of the rotor [rad/s], in place of a torque
  SweepDirection direction{SweepDirection::both};  ///< of the sweeps
};

/// A map over speed and torque of what a drive that follows needs, loses and gives at each point; of one motor, or of a
/// family over one parameter.
struct MapStudy {
  static constexpr std::string_view kName{"map"};                         ///< as in `kind:`
  static constexpr std::string_view kTitle{"map over speed and torque"};  ///< what it asks for
  static Shape<MapStudy> shape();                                         ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// How many speeds and torques: 60x40.
  struct Grid {
    std::uint64_t speeds{60};   ///< 2 to 1000
    std::uint64_t torques{40};  ///< 2 to 1000

    /// The grid that a text such as "60x40" names. @throws ValueError
    static Grid parse(std::string_view text);
  };
  /// Metrics that `quantity` may be, in the order of the table; static lifetime.
  static std::span<const Metric> quantities();
  std::optional<CurveStudy::Family> family{};  ///< none: the motor alone
  std::optional<double> torque{};  ///< the largest [N m], more than 0; none: the drive's largest
  std::optional<double> speed{};   ///< the largest [rad/s], more than 0; none: the drive's largest
  Grid points{};                   ///< of the map
  /// What the pictures show, a metric at a torque and a speed; none: the efficiency of the whole motor.
  std::optional<Metric> quantity{};
  std::vector<DutyPoint> duty{};  ///< points that are marked; may be empty
};

/// Temperatures of a motor: steady ones and the warm-up under a load, and over a cycle of the motor's operation; of one motor, or
/// of a family over one parameter.
struct HeatStudy {
  static constexpr std::string_view kName{"heat"};           ///< as in `kind:`
  static constexpr std::string_view kTitle{"temperatures"};  ///< what it asks for
  static Shape<HeatStudy> shape();                           ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::optional<CurveStudy::Family> family{};  ///< none: the motor alone
  std::optional<double> torque{};              ///< of the load [N m]
  std::optional<double> speed{};  ///< of the rotor [rad/s]; with a torque the drive holds it
  std::optional<double> time{};   ///< of the warm-up [s]; none: five slowest time constants
  std::uint64_t points{101};      ///< of the warm-up, or of a cycle without a load, at least 2

  /// The load; none: the operation alone.
  std::optional<LoadPoint> load() const;
};

/// The life of a motor whose track wears, under a load or in the motor's operation; of one motor, or of a family over one
/// parameter.
struct LifeStudy {
  static constexpr std::string_view kName{"life"};   ///< as in `kind:`
  static constexpr std::string_view kTitle{"life"};  ///< what it asks for
  static Shape<LifeStudy> shape();                   ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::optional<CurveStudy::Family> family{};  ///< none: the motor alone
  std::optional<double> torque{};              ///< of the load [N m]
  std::optional<double> speed{};  ///< of the rotor [rad/s]; with a torque the drive holds it
  std::uint64_t points{51};       ///< depths between new and worn, at least 2

  /// The load; none: the operation.
  std::optional<LoadPoint> load() const;
};

/// A number of a motion that is asked for.
struct MotionMeasure {
  /// What it is.
  enum class Kind : unsigned char {
    time_to,
    settling_time,
    overshoot,
    peak,
    angle_after,
    energy,
    time_of
  };
  std::string text;               ///< as typed, such as "time_to(speed, 90 %)"
  Kind kind{Kind::time_to};       ///< what it is
  std::string column{};           ///< of those that have one; the event of time_of
  std::optional<double> share{};  ///< of the value before the drive is switched off
  double at{0};                   ///< a level in SI, or a time [s]
  double to{0};                   ///< end of an interval [s]
};

/// A number of a loop's output: a frequency or a voltage, or a rate or gain of one.
struct LoopValue {
  double value{0};                                     ///< SI
  motion::Actuator unit{motion::Actuator::frequency};  ///< that of its unit
};

/// A loop that changes the drive in a motion.
struct MotionControl {
  /// What it keeps to its reference.
  enum class Kind : unsigned char { speed, position };
  Kind kind{Kind::speed};                      ///< of the loop
  motion::Profile reference{};                 ///< of the speed [rad/s] or the angle [rad]
  double sample_time{1e-3};                    ///< [s]
  std::uint64_t delay{1};                      ///< samples
  std::optional<std::uint64_t> encoder{};      ///< counts a turn; none: the angle is exact
  std::optional<motion::Actuator> actuator{};  ///< none: that of the motor's control
  std::vector<LoopValue> range{};              ///< two, or none: the motor's range of frequencies
  std::optional<double> start_frequency{};     ///< [Hz]; none: the upper end of the range
  std::optional<double> start_voltage{};       ///< [V]; none: the motor's voltage
  std::optional<LoopValue> slew{};             ///< over time
  /// Gains of the controller.
  struct Gains {
    LoopValue kp;  ///< [Hz.s/rad or V.s/rad]
    LoopValue ki;  ///< [Hz/rad or V/rad]
  };
  std::optional<Gains> gains{};  ///< of the speed; none: those of (M8.1)
  std::optional<double> gain{};  ///< of a position [1/s]; none: that of motion::PositionControl
  double braking{0.5};           ///< of a position, beta of (M8.2) [1]
  std::uint64_t window{2};       ///< of a position, counts within which the drive stays off
  double off_time{1.5e-3};       ///< of a position, before phases are swapped [s]

  /// What it changes on a motor.
  motion::Actuator actuator_of(const MotorDesign& motor) const;
};

/// A motor in time: starts, stops, changes of load and drive; of one motor, or of a family over one parameter.
struct MotionStudy {
  static constexpr std::string_view kName{"motion"};           ///< as in `kind:`
  static constexpr std::string_view kTitle{"motion in time"};  ///< what it asks for
  static Shape<MotionStudy> shape();                           ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// What the shaft drives; what is left out is the motor's.
  struct Load {
    std::optional<motion::Profile> torque{};  ///< against positive motion [N m]
    std::optional<double> inertia{};          ///< [kg m^2]
    std::optional<double> damping{};          ///< [N m s]
    std::optional<double> friction{};         ///< [N m]
    std::optional<double> stiffness{};        ///< [N m/rad]
    std::optional<double> neutral{};          ///< [rad]
  };
  /// What is done to the drive; what is left out is the motor's.
  struct Drive {
    std::optional<motion::Profile> voltage{};           ///< [V]
    std::optional<motion::Profile> amplitude{};         ///< [m]
    std::optional<motion::Profile> frequency{};         ///< [Hz]
    std::vector<motion::Interval> switched_off{};       ///< may be empty
    std::vector<motion::Interval> reversed{};           ///< phases swapped; may be empty
    std::optional<motion::Profile> phase_difference{};  ///< [rad]; none: a quarter of a turn
  };
  /// What is stored.
  struct Output {
    std::optional<double> step{};        ///< between rows [s]; none: a thousandth of the duration
    std::vector<std::size_t> columns{};  ///< of the columns of a motion; none: all
  };
  std::optional<CurveStudy::Family> family{};                   ///< none: the motor alone
  double duration{0};                                           ///< [s]
  motion::MotionEngine engine{motion::MotionEngine::averaged};  ///< of the motion
  std::optional<double> accuracy{};                          ///< of the oscillating engine; none: 1
  motion::AxialMotion axial{motion::AxialMotion::balanced};  ///< of the averaged engine
  motion::InitialState initial{};                            ///< at rest
  Drive drive{};                                             ///< over time
  Load load{};                                               ///< over time
  std::optional<MotionControl> control{};  ///< in place of a given frequency or voltage
  Output output{};                         ///< what is stored
  std::vector<MotionMeasure> measure{};    ///< may be empty

  /// Time between rows [s].
  double step() const;
};

/// How the designs of a sweep are chosen.
enum class Sampling : unsigned char { grid, list, lhs, sobol };

/// As in `sampling:`; static lifetime.
const char* to_string(Sampling value) noexcept;

/// The metrics of a grid, list or sample of designs.
struct SweepStudy {
  static constexpr std::string_view kName{"sweep"};              ///< as in `kind:`
  static constexpr std::string_view kTitle{"sweep of designs"};  ///< what it asks for
  static Shape<SweepStudy> shape();                              ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// The values of one parameter: a list or a range.
  struct Variable {
    Parameter parameter{};                     ///< which one
    std::vector<double> values{};              ///< SI; empty: the range is used
    double min{0};                             ///< SI
    double max{0};                             ///< SI
    std::uint64_t points{5};                   ///< of a grid, both ends included
    optim::Scale scale{optim::Scale::linear};  ///< logarithmic where min > 0
  };
  std::vector<Variable> variables{};        ///< at least one
  std::vector<DerivedParameter> derived{};  ///< what follows from the variables
  Sampling sampling{Sampling::grid};        ///< how designs are chosen
  std::vector<MetricExpression> metrics{};  ///< what is computed
  std::uint64_t samples{1000};              ///< designs, of lhs and sobol
  std::uint64_t seed{1};                    ///< of lhs and sobol
};

/// Methods of sensitivity studies.
enum class SensitivityMethod : unsigned char { local, morris, sobol };
/// As in a study file; static lifetime.
const char* to_string(SensitivityMethod value) noexcept;

/// The influence of parameters on metrics.
struct SensitivityStudy {
  static constexpr std::string_view kName{"sensitivity"};   ///< as in `kind:`
  static constexpr std::string_view kTitle{"sensitivity"};  ///< what it asks for
  static Shape<SensitivityStudy> shape();                   ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  SensitivityMethod method{SensitivityMethod::sobol};  ///< derivatives, screening, or shares
  std::vector<DesignVariable> variables{};             ///< `start` counts for local only
  std::vector<Tolerance> tolerances{};                 ///< in place of the variables
  std::vector<DerivedParameter> derived{};             ///< what follows from the variables
  std::vector<MetricExpression> metrics{};             ///< of what
  /// Trajectories (morris) or base samples (sobol); none: standard_samples().
  std::optional<std::uint64_t> samples{};
  double confidence{0.95};        ///< level of the intervals
  std::optional<double> width{};  ///< sobol: doubles the samples until no interval is wider
  std::optional<std::uint64_t> max_samples{};  ///< sobol: none: 64 times the samples
  std::uint64_t seed{1};                       ///< of whatever is random
};
/// Default number of samples of a method: 32 trajectories or 1024 base samples.
std::uint64_t standard_samples(SensitivityMethod method);

/// The best design under constraints.
struct OptimizeStudy {
  static constexpr std::string_view kName{"optimize"};       ///< as in `kind:`
  static constexpr std::string_view kTitle{"optimization"};  ///< what it asks for
  static Shape<OptimizeStudy> shape();                       ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::vector<DesignVariable> variables{};   ///< what may be changed
  std::vector<DerivedParameter> derived{};   ///< what follows from the variables
  std::vector<DesignChoice> choose{};        ///< sets of parameters of which a design has one
  DesignObjective objective{};               ///< objective: a metric or a statistic
  std::vector<MotorLimit> constraints{};     ///< what must hold
  std::vector<Tolerance> tolerances{};       ///< tolerances of built motors; may be empty
  std::vector<StatisticLimit> statistics{};  ///< limits on the built motors
  std::vector<ToleranceCorrelation> correlations{};  ///< of the tolerances
  /// table of measured parts, as in UncertaintyStudy; empty: none
  std::string parts{};
  optim::SolveOptions solver{};  ///< observer, threads and stop are the run's
  std::string start{};           ///< result directory to start from; empty: the motor
};

/// The trade-off front of two or three metrics.
struct ParetoStudy {
  static constexpr std::string_view kName{"pareto"};            ///< as in `kind:`
  static constexpr std::string_view kTitle{"trade-off front"};  ///< what it asks for
  static Shape<ParetoStudy> shape();                            ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// A front takes ten times the evaluations of an optimum.
  static optim::SolveOptions standard_solver() {
    optim::SolveOptions options;
    options.budget.evaluations = 200000;
    options.scan = 0;
    return options;
  }
  std::vector<DesignVariable> variables{};    ///< what may be changed
  std::vector<DerivedParameter> derived{};    ///< what follows from the variables
  std::vector<DesignChoice> choose{};         ///< sets of parameters of which a design has one
  std::vector<DesignObjective> objectives{};  ///< two or three
  std::vector<MotorLimit> constraints{};      ///< what must hold
  std::vector<Tolerance> tolerances{};        ///< as in OptimizeStudy
  std::vector<StatisticLimit> statistics{};   ///< as in OptimizeStudy
  std::vector<ToleranceCorrelation> correlations{};  ///< of the tolerances
  /// table of measured parts, as in UncertaintyStudy; empty: none
  std::string parts{};
  std::uint64_t points{50};                       ///< of the front
  optim::SolveOptions solver{standard_solver()};  ///< as in OptimizeStudy
  std::string start{};  ///< result directory to start from; empty: the motor
};

/// A motor for a duty.
struct SizeStudy {
  static constexpr std::string_view kName{"size"};                ///< as in `kind:`
  static constexpr std::string_view kTitle{"sizing for a duty"};  ///< what it asks for
  static Shape<SizeStudy> shape();                                ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::vector<DesignVariable> variables{};   ///< what may be changed
  std::vector<DerivedParameter> derived{};   ///< what follows from the variables
  std::vector<DesignChoice> choose{};        ///< sets of parameters of which a design has one
  std::vector<MotorLimit> duty{};            ///< torque_at(SPEED) >= LOAD of each point
  DutyDrive drive{DutyDrive::fixed};         ///< how the motor reaches these points
  std::vector<MotorLimit> limits{};          ///< what else must hold
  std::vector<Tolerance> tolerances{};       ///< as in OptimizeStudy
  std::vector<StatisticLimit> statistics{};  ///< as in OptimizeStudy
  std::vector<ToleranceCorrelation> correlations{};  ///< of the tolerances
  /// table of measured parts, as in UncertaintyStudy; empty: none
  std::string parts{};
  /// objective among the motors that can do the duty
  DesignObjective prefer{parse_metric("max_pressure")};
  optim::SolveOptions solver{};  ///< as in OptimizeStudy
  std::string start{};           ///< result directory to start from; empty: the motor
};

/// How the motors of an uncertainty study are drawn.
enum class DrawMethod : unsigned char {
  plain,      ///< by their tolerances
  importance  ///< about the points where they are most likely to fail, and weighted
};
/// As in a study file; static lifetime.
const char* to_string(DrawMethod value) noexcept;

/// Spread and yield under tolerances.
struct UncertaintyStudy {
  static constexpr std::string_view kName{"uncertainty"};               ///< as in `kind:`
  static constexpr std::string_view kTitle{"spread under tolerances"};  ///< what it asks for
  static Shape<UncertaintyStudy> shape();                               ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  DrawMethod method{DrawMethod::plain};              ///< how motors are drawn
  std::vector<Tolerance> variables{};                ///< what is uncertain
  std::vector<ToleranceCorrelation> correlations{};  ///< of these; others are independent
  /// table of measured parts, drawn whole; parameters without a column keep their law; empty: none
  std::string parts{};
  std::vector<DerivedParameter> derived{};         ///< what follows from the variables
  std::vector<MetricExpression> metrics{};         ///< of what
  std::uint64_t samples{10000};                    ///< motors that are drawn
  std::vector<MotorLimit> limits{};                ///< of the yield; none: no yield
  std::vector<double> quantiles{0.05, 0.5, 0.95};  ///< probabilities in (0, 1)
  std::uint64_t seed{1};                           ///< of the draws
  /// result directory whose best design is taken as the motor; empty: the motor of the file
  std::string start{};
};

/// Solver of a calibration, in the order of optim::least_squares_solvers().
enum class FitSolver : unsigned char { own, gsl };
/// As in a study file; static lifetime.
const char* to_string(FitSolver value) noexcept;

/// Loss function of a calibration.
enum class FitLoss : unsigned char { squares, huber };
/// As in a study file; static lifetime.
const char* to_string(FitLoss value) noexcept;

/// Source of the scatter behind the intervals of a calibration: the residuals of all data, the standard deviations in
/// the data, or the residuals of each column of each table.
enum class Scatter : unsigned char { estimated, stated, by_column };
/// As in a study file; static lifetime.
const char* to_string(Scatter value) noexcept;

/// Parameters from measurements.
struct CalibrateStudy {
  static constexpr std::string_view kName{"calibrate"};     ///< as in `kind:`
  static constexpr std::string_view kTitle{"calibration"};  ///< what it asks for
  static Shape<CalibrateStudy> shape();                     ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  /// paths of the tables of measurements; none: plan the first measurements
  std::vector<std::string> data{};
  std::vector<ColumnChoice>
      columns{};  ///< which of their columns hold what, where headings do not say so
  std::vector<DesignVariable> variables{};  ///< what is estimated
  std::vector<Parameter>
      per_file{};  ///< of these: with a value of its own in each of several tables
  std::vector<DerivedParameter> derived{};  ///< what follows from the variables
  double confidence{0.95};                  ///< level of the intervals
  Scatter scatter{Scatter::estimated};      ///< what the width of the intervals follows from
  FitLoss loss{FitLoss::squares};           ///< how residuals count
  std::uint64_t starts{8};                  ///< local fits from different starts
  FitSolver solver{FitSolver::own};         ///< of each of them
  std::uint64_t seed{1};                    ///< of the starts
};

/// The question of a study: one alternative for each kind. A kind is a struct with a name, a field list and a runner.
using Study = std::variant<CurveStudy, SweepStudy, SensitivityStudy, OptimizeStudy, ParetoStudy,
                           SizeStudy, UncertaintyStudy, CalibrateStudy, FrequencyStudy, MapStudy,
                           HeatStudy, LifeStudy, MotionStudy>;

/// The kinds of study.
enum class StudyKind : unsigned char {
  curve,
  sweep,
  sensitivity,
  optimize,
  pareto,
  size,
  uncertainty,
  calibrate,
  frequency,
  map,
  heat,
  life,
  motion
};

/// The kind of a study.
inline StudyKind kind_of(const Study& study) { return static_cast<StudyKind>(study.index()); }

/// Names as in `kind:`, in the order of StudyKind; static lifetime.
std::span<const std::string_view> study_kinds();

/// The kind with a name, if there is one.
std::optional<StudyKind> find_study_kind(std::string_view name);

/// The name of a kind; static lifetime.
std::string_view to_string(StudyKind kind);

/// What a kind asks for, "optimization" of a motor; static lifetime.
std::string_view title_of(StudyKind kind);

}  // namespace twum::inline v0_1::studies
