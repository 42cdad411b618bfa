// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace twum::inline v0_1::motion {

/// A system of differential equations y' = f(t, y) with functions whose zeros are events.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  /// y'. False where there is none: the integrator then tries a shorter step.
  virtual bool rates(double time, std::span<const double> y, std::span<double> dy) = 0;
  /// Derivative of y'[i] in y[j] at jacobian[j n + i], for n states. False as above.
  virtual bool jacobian(double time, std::span<const double> y, std::span<double> jacobian) = 0;
  /// Derivative of y'[i] by parameter k, y held fixed, at slopes[k n + i]. False as above.
  virtual bool parameter_slopes(double /*time*/, std::span<const double> /*y*/,
                                std::span<double> /*slopes*/) {
    return false;
  }
  /// True if some of its own oscillations hardly decay. Formulas of high order are unstable for those, and are then left.
  virtual bool rings() const { return false; }
  /// Functions whose zeros end a step. False as above.
  virtual bool events(double time, std::span<const double> y, std::span<double> values) = 0;
};

/// How a step of the integrator ended.
enum class StepEnd : unsigned char { advanced, event, stop_time, failed };

/// Integrates a system step by step: backward differentiation of variable order and step (CVODES of SUNDIALS). With parameters it
/// integrates S = dy/dq beside y, S' = y'_y S + y'_q, in the same steps, which keep the tolerance in S, too.
class Integrator {
 public:
  /// @param event_count  of events()
  /// @param tolerance    relative
  /// @param absolute     of each state
  /// @param parameters   of parameter_slopes(), scaled so that a change of each by 1 is a whole one
  /// @throws InputError without SUNDIALS.
  Integrator(OdeSystem& system, int event_count, double tolerance, std::vector<double> absolute,
             std::size_t parameters = 0);
  ~Integrator();
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Begins anew, and goes on to `stop` at most.
  /// @param slopes  S, that of parameter k at [k n + i]; empty without parameters
  void restart(double time, std::span<const double> y, double stop,
               std::span<const double> slopes = {});
  /// One step. An exception of the system comes out of it.
  StepEnd step();

  double time() const;                ///< reached
  std::span<const double> y() const;  ///< there
  /// y within the last step, or its derivative, by the polynomial of the step.
  std::vector<double> at(double time, int derivative = 0) const;
  /// S within the last step, as restart() takes it.
  std::vector<double> slopes_at(double time) const;
  long steps() const;  ///< since it was made

 private:
  void take_parameters();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace twum::inline v0_1::motion
