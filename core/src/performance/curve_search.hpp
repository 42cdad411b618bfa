// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/point_derivatives.hpp"
#include "performance/speed_roots.hpp"

#include <twum/core/performance/metrics.hpp>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace twum::performance {

/// What a metric says that needs a point without an answer.
MetricStatus metric_status(PointStatus status);

/// How a supremum over speed is reached.
enum class PeakKind : unsigned char {
  smooth,          ///< slope zero inside
  rest,            ///< at speed 0
  plateau_end,     ///< where the torque leaves its plateau
  beyond_plateau,  ///< just beyond, where it jumps to a higher value
  kink             ///< at another kink or jump: the one-sided limit there
};

struct Peak {
  double speed{0}, value{0};
  PeakKind kind{PeakKind::smooth};
};

/// A speed where the torque takes a value.
struct Crossing {
  double speed{0};
  /// It has no slope there to tell how the speed moves: a jump, or a maximum.
  bool slopeless{false};
};

/// What is searched for over the torque-speed curve. Each result is found once and kept.
class CurveSearch {
 public:
  explicit CurveSearch(const DrivenMotor<double>& model);

  double stall_torque();             ///< (T7.12)
  Crossing no_load();                ///< (T7.14)
  double plateau_end();              ///< (T7.17)
  Peak max_torque();                 ///< (T7.13)
  Peak peak_power();                 ///< (T7.16)
  Peak working_peak();               ///< the same, of a motor that has a stall torque
  Peak max_efficiency();             ///< (T7.18)
  Crossing speed_at(double torque);  ///< (T7.15)

 private:
  enum class Goal : unsigned char { torque, power, efficiency };
  struct Node {
    double speed, torque, stator_power;
    bool plateau;
    std::uint64_t itinerary;  ///< kNoState where the point has no answer
    MetricStatus status;
    WarmStart start;  ///< for neighbouring points
    long lost{0};     ///< zones followed in vain, without an answer
    bool ok() const { return status == MetricStatus::ok; }
  };
  struct Stretch {
    /// With the same sequence of zones and without a jump, if there were not too many to tell apart.
    Node first, last;
    std::vector<double>
        inside;  ///< speeds between, close enough for torque to be steady between neighbours
  };
  // Between rest and the crest speed. Between two neighbouring nodes torque is taken to have no more than one maximum
  // (with mu_0 > mu: one in each stretch with the same sequence of zones).
  static constexpr int kIntervals = 20;
  static constexpr double kScanAccuracy = 1e-7;  // of the nodes
  static constexpr double kInset =
      1e-7;  // share of a stretch at its ends, which stand for themselves
  static constexpr double kWorth = 0.7;  // share of a value above which jumps nearby may pass it
  static constexpr std::uint64_t kNoState = ~std::uint64_t{0};
  struct Sloped {
    double value, slope;
  };

  // With a trail, the point begins with what its neighbours know.
  Node node(double speed, Trail* trail = nullptr, double accuracy = 0) const;
  Node scanned(double speed, Trail& trail) const;
  std::size_t highest(Goal goal, const std::vector<Node>& nodes) const;
  Node answered(double speed, Trail* trail = nullptr) const;
  void scan();
  std::vector<Node> skip_plateau(double step, Trail& trail);
  void require_drive();
  double value(Goal goal, const Node& node) const;
  const TorqueSlope& torque_slope_at(double speed, Trail* trail = nullptr);
  Sloped sloped(Goal goal, double speed, Trail* trail = nullptr);
  Peak peak(Goal goal);
  void add_ripples(Goal goal, std::vector<Node>& nodes) const;
  Peak smooth_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top);
  Peak peak_beside(Goal goal, const std::vector<Node>& nodes, std::size_t top);
  Peak sharp_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top);
  bool plateau_may_top(Goal goal, const std::vector<Node>& nodes, double best);
  Peak rough_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top);
  double likely_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top,
                     double& curvature) const;
  std::optional<Peak> peak_near(Goal goal, const std::vector<Node>& nodes, std::size_t top);
  std::optional<Peak> peak_between(Goal goal, double low, double high);
  const Node& halved(double speed);
  std::vector<Peak> peaks_inside(Goal goal, const Stretch& stretch, double worth);
  std::vector<Stretch> stretches(const Node& low, const Node& end);
  void add_between(const Node& low, const Node& high, std::vector<Node>& nodes);
  bool is_steady(const Node& low, const Node& high);
  std::pair<Node, Node> stretch_end(const Node& low, const Node& end);
  Node past_jump(const Node& end, double inside);
  Peak named(Peak peak);
  std::vector<Node> working_nodes();
  std::vector<Node> nodes_around(double torque);
  static std::size_t after_last(const std::vector<Node>& nodes, double torque);
  bool starts_on_plateau();
  Crossing falls_through(double torque, const Node& low, const Node& high) const;
  std::optional<double> zero_near(double torque, const Node& low, const Node& high) const;

  const DrivenMotor<double>& m_;
  double holding_, crest_;
  bool rough_;               // mu_0 > mu: torque may jump
  std::vector<Node> nodes_;  // from rest to the first speed past no-load
  std::optional<MetricStatus> scan_failure_;
  bool scanned_{false};
  std::optional<Crossing> no_load_;
  std::optional<double> plateau_end_;
  std::optional<Peak> peaks_[3];
  std::deque<std::pair<double, TorqueSlope>> slopes_;  // by speed; references stay valid
  std::map<double, Node> halved_;                      // nodes of halvings, the same for every goal
  long lost_{0};                                       // by halving in this search
};

}  // namespace twum::performance
