// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/scaling.hpp"
#include "problem/session.hpp"

#include <cmath>
#include <optional>

namespace twum::inline v0_1::optim {

struct Term {
  std::size_t index{0};
  double factor{1.0};
};

/// lower <= sum of factors times scaled responses, plus sum of factors times extra unknowns <= upper.
struct LinearForm {
  std::vector<Term> responses;
  std::vector<Term> extras;
  double lower{-kInfinity};
  double upper{kInfinity};
};

/// The problem of one solver run. Objective and constraints are linear in the scaled responses and a few extra
/// unknowns, which covers the plain problem, the elastic one, and every point of a front.
struct Formulation {
  LinearForm objective;  ///< to be minimized; its limits are not used
  std::vector<LinearForm> rows;
  std::vector<double> extra_lower;
  std::vector<double> extra_upper;
  /// a smaller box for the scaled variables; empty: their whole range
  std::vector<double> unit_lower;
  std::vector<double> unit_upper;
};

/// Minimize one objective under the problem's constraints.
Formulation plain_formulation(const Problem& problem, const Scaling& scaling,
                              std::size_t objective = 0);

/// Values and gradients of a formulation at one point z = (unit variables, extra unknowns).
struct NlpValue {
  double f{0.0};
  std::vector<double> c;
  std::vector<double> df;
  std::vector<double> dc;  ///< rows() x size(), row-major
};

/// Solvers multiply squares of their inputs. If that overflows or underflows they divide zero by zero, and their
/// inner loops may never end (seen with COBYLA, BOBYQA and SLSQP). Scaled responses are of order 1, so values this
/// large are refused and values this small are set to zero.
inline bool can_be_reckoned_with(double x) { return std::abs(x) <= 1e30; }  // false for NaN
inline double without_dust(double x) { return std::abs(x) < 1e-100 ? 0.0 : x; }

/// A point in the archive.
struct Candidate {
  std::vector<double> z;
  double f{kInfinity};
  double violation{
      kInfinity};  ///< relative to what the limits tolerate; at most the tolerance if all are kept
  double excess{kInfinity};    ///< largest violation, scaled: ranks points that break limits
  std::vector<double> values;  ///< responses, user units
};

/// A formulation as solvers see it, with its own archive of the best point seen.
class Nlp {
 public:
  Nlp(Session& session, const Scaling& scaling, Formulation formulation);

  std::size_t size() const { return lower_.size(); }
  std::size_t units() const { return scaling_.size(); }
  std::size_t rows() const { return formulation_.rows.size(); }
  const LinearForm& row(std::size_t i) const { return formulation_.rows[i]; }
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }
  bool equality(std::size_t i) const { return row(i).lower == row(i).upper; }

  /// Null if the design cannot be evaluated, if a required derivative does not exist, or if a number is too large for
  /// solvers. Points are clamped into the bounds first. Checks the time limit and stop requests each time, even if
  /// nothing has to be evaluated.
  /// @throws Stop, and what the evaluator throws.
  const NlpValue* at(std::span<const double> z, bool gradient);

  /// Largest violation of a row, scaled.
  double excess(const NlpValue& value) const;

  /// Scaled violation that a row tolerates at the last point: the least of its sides.
  double tolerance(std::size_t row) const;

  /// The whole box of the scaled variables.
  const std::vector<double>& least() const { return formulation_.unit_lower; }
  const std::vector<double>& most() const { return formulation_.unit_upper; }

  /// Restricts the box of the scaled variables to a neighbourhood of a point; radius 0 restores it.
  void restrict_box(std::span<const double> centre, double radius);

  /// An optimum that is known already: reached_known() tells when a search has come to it.
  void expect(std::span<const double> optimum);

  /// Whether the last two designs lie within a tenth of the variables' magnitudes of that optimum.
  bool reached_known() const { return beside_ >= 2; }

  /// Best point so far: feasible ones before others, then by objective or violation.
  const std::optional<Candidate>& best() const { return best_; }

  std::vector<double> design(std::span<const double> z) const;
  const Scaling& scaling() const { return scaling_; }
  Session& session() { return session_; }

 private:
  bool fill(const Evaluation& e, std::span<const double> z, bool gradient);
  void flatten_kept();
  bool usable(bool gradient) const;
  double row_value(const LinearForm& row, const Evaluation& e, std::span<const double> z) const;
  void row_gradient(const LinearForm& row, const Evaluation& e, double* out) const;
  double side_tolerance(std::size_t row, double bound) const;
  double violation() const;
  void note_terms(const Evaluation& e);
  void keep(std::span<const double> z, const Evaluation& e);
  bool beside_known() const;

  Session& session_;
  const Scaling& scaling_;
  Formulation formulation_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> point_;
  std::vector<double> design_;
  NlpValue value_;
  std::vector<double> terms_;  // magnitude of each response's terms where it was last known
  bool known_{false};
  bool has_gradient_{false};
  std::optional<Candidate> best_;
  std::optional<Scaling> around_;  // the known optimum, in units of its magnitudes
  std::vector<double> optimum_;
  int beside_{0};  // designs in a row that lie beside it
};

/// Whether a is the better candidate: feasible first, then the smaller objective or violation.
bool better(const Candidate& a, const Candidate& b, double feasibility_tolerance);

}  // namespace twum::inline v0_1::optim
