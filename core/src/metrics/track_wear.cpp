// SPDX-License-Identifier: Apache-2.0
// Each radius of the track wears by itself (V3.1 to V3.3): rates and their Jacobian.
#include <twum/core/track_wear.hpp>

#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "design/thermal_design.hpp"
#include "design/wear_design.hpp"
#include "heat/small_matrix.hpp"
#include "metrics/track_load.hpp"
#include "model/mapped_motor.hpp"
#include "model/track.hpp"
#include "wear/worn_design.hpp"

#include <twum/base/error.hpp>
#include <twum/base/gauss_rule.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace twum::inline v0_1 {

using namespace core;

namespace {

constexpr int kNodesOfAuto = 16;
constexpr double kWholeTurn = 2 * std::numbers::pi;

// Directions of the derivatives in a node: the depth of the rotor in the layer, the worn depth of the node itself, the wave, and the
// mean depth, which the layer's inertia follows. The speed has one of its own.
constexpr int kRotor = 0, kNode = 1, kWave = 2, kMean = 3;

std::vector<TrackNode> nodes_of(const Stator& stator) {
  const int given = std::abs(stator.radial_slices);
  const int count = stator.radial_slices == kAutoSlices ? kNodesOfAuto : given;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width;
  std::vector<TrackNode> nodes;
  for (const GaussRule::Node& node : gauss_rule(count).nodes)
    nodes.push_back(
        {inner + node.place * stator.contact_width, node.weight * stator.contact_width});
  return nodes;
}

double area_of(const TrackNode& node) { return kWholeTurn * node.radius * node.width; }

// u of (V3.2)
double mean_of(const std::vector<TrackNode>& nodes, std::span<const double> depths) {
  double sum = 0, area = 0;
  for (std::size_t j = 0; j < nodes.size(); ++j)
    sum += area_of(nodes[j]) * depths[j], area += area_of(nodes[j]);
  return sum / area;
}

MotorDesign worn_at(const MotorDesign& design, const std::vector<TrackNode>& nodes,
                    std::span<const double> depths) {
  const double mean = mean_of(nodes, depths);
  MotorDesign worn = worn_design(design, mean);
  worn.stator.radial_slices = static_cast<int>(nodes.size());
  worn.wear->deviations.clear();
  for (const double depth : depths) worn.wear->deviations.push_back(depth - mean);
  return worn;
}

// The motor with derivatives in the directions above, at its nodes that touch.
DrivenMotor<ModelDual> differentiated(const MotorDesign& design, const DrivenMotor<double>& m) {
  auto dual = mapped<ModelDual>(m, [](double x) { return ModelDual(x); });
  dual.indentation.d[kRotor] = 1, dual.indentation.d[kNode] = -1;
  dual.thickness.d[kNode] = -worn_track(m)->thickness_share;
  dual.mean.amplitude.d[kWave] = 1;
  if (!design.layer.given_inertia)  // goes with the square of the thickness (T1.4)
    dual.inertia.d[kMean] = -worn_track(m)->thickness_share * 2 * m.inertia / m.thickness;
  for (Slice<ModelDual>& s : dual.annulus)
    s = slice_at(dual, ModelDual(s.radius.v), ModelDual(s.width.v));
  return dual;
}

// What is summed over the nodes, of one of them.
struct NodeNumbers {
  std::size_t node;
  ModelDual load, pressure;
  PointNumbers<ModelDual> point;
};

std::vector<NodeNumbers> numbers_of(const MotorDesign& design, const SolvedLoad& at,
                                    const std::vector<TrackNode>& nodes) {
  const DrivenMotor<ModelDual> dual = differentiated(design, at.motor);
  const auto points =
      at.point.differentiated_slices(dual, ModelDual::variable(at.speed, kSpeedDirection));
  std::vector<NodeNumbers> numbers;
  std::size_t node = 0;
  for (std::size_t k = 0; k < dual.annulus.size(); ++k) {
    const Slice<ModelDual>& s = dual.annulus[k];
    while (node + 1 < nodes.size() && nodes[node].radius < s.radius.v - 0.5 * nodes[node].width)
      ++node;
    PointNumbers<ModelDual> point{};  // nothing slips where there is no periodic state
    if (!points.empty()) point = points[k];
    numbers.push_back({node, s.load, s.contact.max_pressure, point});
  }
  return numbers;
}

// |H|^2 in the contact's reactive force, its power and the amplitude (D2.4).
struct BalanceSlopes {
  double by_force{0}, by_power{0}, by_amplitude{0};
};

BalanceSlopes balance_slopes(const MotorDesign& design, const SolvedLoad& at) {
  using contact::MotionDual;
  const auto modes = constant_modes<MotionDual>(*stator_modes(design));
  const PointNumbers<double>& n = at.point.numbers;
  const auto square = [&](const MotionDual& amplitude, const MotionDual& force,
                          const MotionDual& power) {
    const MotionDual omega(at.motor.omega);
    const auto drive =
        drive_balance(modes, wave_balance(modes, amplitude, omega, force, power), amplitude, omega);
    return drive.real * drive.real + drive.imaginary * drive.imaginary;
  };
  const double A = at.motor.mean.amplitude;
  const MotionDual of_contact = square(MotionDual(A), MotionDual::variable(n.reactive_force, 0),
                                       MotionDual::variable(n.stator_power, 1));
  const MotionDual of_wave =
      square(MotionDual::variable(A, 0), MotionDual(n.reactive_force), MotionDual(n.stator_power));
  return {of_contact.d[0], of_contact.d[1], of_wave.d[0]};
}

constexpr std::array kUnknowns{kRotor, kSpeedDirection, kWave};

// How depth of the rotor, speed and wave follow the worn depths under a load: the preload (V3.2), the torque and the drive's force stay
// what they have to be. A speed or a wave that is given does not move.
class Followers {
 public:
  Followers(const MotorDesign& design, const LoadPoint& load, const SolvedLoad& at,
            const std::vector<NodeNumbers>& numbers)
      : at_torque_(load.argument == Argument::torque), driven_(design.stator.voltage.has_value()) {
    if (driven_) balance_ = balance_slopes(design, at);
    Matrix3 by_unknown{};
    by_mean_[0] = design.wear->preload_spring;
    for (const NodeNumbers& one : numbers) {
      by_mean_ = plus(by_mean_, 1, conditions(one, kMean));
      for (std::size_t c = 0; c < kUnknowns.size(); ++c) {
        const Vector3 g = conditions(one, kUnknowns[c]);
        for (std::size_t row = 0; row < 3; ++row) by_unknown[row][c] += g[row];
      }
    }
    if (driven_) by_unknown[2][2] += balance_.by_amplitude;
    if (!at_torque_) by_unknown[1] = {0, 1, 0};
    if (!driven_) by_unknown[2] = {0, 0, 1};
    inverse_ = inverse(by_unknown);
  }

  /// For the depth of a node.
  /// @param own    null: it does not touch
  /// @param share  of the area: how much of its depth is that of the mean
  Vector3 moves(const NodeNumbers* own, double share) const {
    const Vector3 of_node = own ? conditions(*own, kNode) : Vector3{0, 0, 0};
    const Vector3 x = inverse_ * plus(of_node, share, by_mean_);
    return {-x[0], -x[1], -x[2]};
  }

 private:
  Vector3 conditions(const NodeNumbers& one, int direction) const {
    const PointNumbers<ModelDual>& p = one.point;
    return {one.load.d[direction], at_torque_ ? p.torque.d[direction] : 0,
            driven_ ? balance_.by_force * p.reactive_force.d[direction] +
                          balance_.by_power * p.stator_power.d[direction]
                    : 0};
  }

  bool at_torque_, driven_;
  BalanceSlopes balance_;
  Vector3 by_mean_{0, 0, 0};
  Matrix3 inverse_{};
};

// Adds what a load does to the rates.
class RateSum {
 public:
  RateSum(TrackRates& sum, const MotorDesign& design, const std::vector<TrackNode>& nodes)
      : sum_(sum), design_(design), nodes_(nodes) {
    for (const TrackNode& node : nodes) area_ += area_of(node);
  }

  void add(const LoadPhase& phase, const SolvedLoad& at) {
    const std::vector<NodeNumbers> numbers = numbers_of(design_, at, nodes_);
    TrackLoad load = told(at, numbers);
    load.share = phase.time;
    for (const NodeNumbers& one : numbers)
      sum_.rates[one.node] += phase.time * rate(one, one.point.friction_power.v);
    sum_.turns += phase.time * std::fabs(at.speed) / kWholeTurn;
    if (!at.point.special) add_slopes(phase, at, numbers);
    sum_.loads.push_back(std::move(load));
  }

 private:
  // (V1.1), of a node's friction power or its slope.
  double rate(const NodeNumbers& one, double power) const {
    return specific_wear_of_both(design_) / design_.friction.kinetic * power /
           area_of(nodes_[one.node]);
  }

  TrackLoad told(const SolvedLoad& at, const std::vector<NodeNumbers>& numbers) const {
    const PointNumbers<double>& n = at.point.numbers;
    TrackLoad load{.speed = at.speed,
                   .torque = n.torque,
                   .amplitude = at.motor.mean.amplitude,
                   .friction_power = n.friction_power};
    for (auto* list : {&load.loads, &load.pressures, &load.stiffness, &load.wear_stiffness})
      list->resize(nodes_.size());
    for (const NodeNumbers& one : numbers) {
      load.loads[one.node] = one.load.v, load.pressures[one.node] = one.pressure.v;
      load.stiffness[one.node] = one.load.d[kRotor];
      load.wear_stiffness[one.node] = rate(one, one.point.friction_power.d[kRotor]);
    }
    return load;
  }

  void add_slopes(const LoadPhase& phase, const SolvedLoad& at,
                  const std::vector<NodeNumbers>& numbers) {
    const std::size_t n = nodes_.size();
    const Followers followers(design_, *phase.load, at, numbers);
    for (std::size_t k = 0; k < n; ++k) {
      const auto own = std::ranges::find(numbers, k, &NodeNumbers::node);
      const double share = area_of(nodes_[k]) / area_;
      const Vector3 x = followers.moves(own == numbers.end() ? nullptr : &*own, share);
      for (const NodeNumbers& one : numbers) {
        const ModelDual& power = one.point.friction_power;
        double slope = share * power.d[kMean] + (one.node == k ? power.d[kNode] : 0);
        for (std::size_t c = 0; c < kUnknowns.size(); ++c) slope += power.d[kUnknowns[c]] * x[c];
        sum_.jacobian[k * n + one.node] += phase.time * rate(one, slope);
      }
      sum_.turn_slopes[k] += phase.time * std::copysign(x[1] / kWholeTurn, x[1] * at.speed);
    }
  }

  TrackRates& sum_;
  const MotorDesign& design_;
  const std::vector<TrackNode>& nodes_;
  double area_{0};
};

std::vector<LoadPhase> mission(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  if (load) return {{load, 1, {}}};
  double period = 0;
  for (const LoadPhase& phase : design.operation) period += phase.time;
  std::vector<LoadPhase> loads;
  for (LoadPhase phase : design.operation) {
    phase.time /= period;
    if (phase.load) loads.push_back(phase);
  }
  return loads;
}

// The first coefficient by which temperatures change the motor or its wear; empty if none does.
std::string drift_of(const MotorDesign& design) {
  if (!design.thermal) return {};
  if (design.thermal->drift.specific_wear.value_or(0) != 0) return "drift_specific_wear";
  for (const DriftRow& row : kDrifts)
    if (is_given(design, row.coefficient) && get(design, row.coefficient) != 0)
      return std::string(info(row.coefficient).name);
  return {};
}

void require_free_wear(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  require_motor(design);
  if (!design.wear) throw InputError("the motor needs 'wear' for its life");
  if (const std::string wrong = free_profile_complaint(design); !wrong.empty())
    throw InputError(wrong);
  if (!load && design.operation.empty())
    throw InputError("the motor needs 'operation' for its life");
  for (const LoadPhase& phase : mission(design, load))
    if (phase.load->argument != Argument::torque && phase.load->argument != Argument::speed)
      throw InputError(
          "a load with torque and speed, which the drive follows, needs wear.profile: even");
}

}  // namespace

struct TrackWear::Parts {
  // A load with the wave that it had last.
  struct Followed {
    LoadPhase phase;
    std::optional<LoadWave> wave{};
  };

  MotorDesign design;
  std::vector<TrackNode> nodes;
  std::vector<Followed> loads{};
};

TrackWear::TrackWear(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  const HeldTraps traps;
  require_free_wear(design, load);
  parts_ = std::make_unique<Parts>(Parts{design, nodes_of(design.stator)});
  keep_plate(parts_->design);
  for (const LoadPhase& phase : mission(design, load)) parts_->loads.push_back({phase});
}

TrackWear::~TrackWear() = default;

const std::vector<TrackNode>& TrackWear::nodes() const { return parts_->nodes; }

double TrackWear::worn_through() const {
  return parts_->design.layer.thickness / thickness_share(parts_->design);
}

double TrackWear::mean(std::span<const double> depths) const {
  return mean_of(parts_->nodes, depths);
}

TrackRates TrackWear::at(std::span<const double> depths) {
  const HeldTraps traps;
  const std::size_t n = parts_->nodes.size();
  TrackRates sum;
  sum.rates.resize(n), sum.jacobian.resize(n * n), sum.turn_slopes.resize(n);
  try {
    const MotorDesign worn = worn_at(parts_->design, parts_->nodes, depths);
    for (Parts::Followed& load : parts_->loads) {
      MotorDesign in_phase = worn;
      if (load.phase.voltage && worn.stator.voltage) in_phase.stator.voltage = load.phase.voltage;
      const SolvedLoad found = solved_load(in_phase, *load.phase.load, load.wave);
      load.wave = found.wave();
      RateSum(sum, in_phase, parts_->nodes).add(load.phase, found);
    }
  } catch (const SearchFailure& failure) {
    return {.status = failure.status};
  } catch (const EvaluationError&) {
    return {.status = MetricStatus::unresolved};
  } catch (const InputError&) {  // a worn motor that is none
    return {.status = MetricStatus::undefined};
  }
  return sum;
}

WearStability wear_stability(const TrackRates& at) {
  if (at.status != MetricStatus::ok || at.loads.empty()) return WearStability::unknown;
  int falling = 0;
  double sum = 0;
  for (std::size_t j = 0; j < at.rates.size(); ++j) {
    double f = 0, D = 0, time = 0;
    for (const TrackLoad& load : at.loads)
      f += load.share * load.stiffness[j], D += load.share * load.wear_stiffness[j],
          time += load.share;
    if (!(f > 0)) continue;  // it does not touch
    if (!std::isfinite(D)) return WearStability::unknown;
    if (!(D > 0)) ++falling;
    sum += f / time / D;
  }
  const bool stable = falling == 0 || (falling == 1 && sum < 0);
  return stable ? WearStability::even : WearStability::uneven;
}

std::string free_profile_complaint(const MotorDesign& design) {
  if (design.stator.radial_slices == 1)
    return "radial_slices must be auto or more than 1 with wear.profile: free, but is 1";
  if (design.stator.radial_motion)
    return "radial_motion must be false with wear.profile: free, but is true";
  if (design.stator.branch != Branch::running)
    return "branch must be running with wear.profile: free, but is dead";
  if (const std::string drift = drift_of(design); !drift.empty())
    return drift + " must be left out with wear.profile: free, but is given";
  return {};
}

MotorDesign worn_motor(const MotorDesign& design, std::span<const double> depths) {
  require_motor(design);
  if (!design.wear) throw InputError("the motor needs 'wear' for its life");
  if (depths.size() < 2) throw InputError("a worn track needs the depths of two nodes or more");
  MotorDesign kept = design;
  kept.stator.radial_slices = static_cast<int>(depths.size());
  const auto nodes = nodes_of(kept.stator);
  const HardEnd end = hard_end(design);
  const double deepest = *std::ranges::max_element(depths), mean = mean_of(nodes, depths);
  const bool through = thickness_share(design) * deepest >= design.layer.thickness;
  if (!(mean >= 0) || !(mean < end.depth) || through)
    throw InputError("a depth beyond the lining or the preload");
  return worn_at(kept, nodes, depths);
}

}  // namespace twum::inline v0_1
