// SPDX-License-Identifier: Apache-2.0
#include "integrator.hpp"

#include <twum/base/error.hpp>
#include <twum/motion/integrator_version.hpp>

namespace twum::inline v0_1::motion {

struct Integrator::Parts {};

Integrator::Integrator(OdeSystem&, int, double, std::vector<double>, std::size_t) {
  throw InputError(
      "this twum was built without SUNDIALS, which integrates motions; install libsundials-dev and "
      "build it again");
}

Integrator::~Integrator() = default;
void Integrator::restart(double, std::span<const double>, double, std::span<const double>) {}
StepEnd Integrator::step() { return StepEnd::failed; }
double Integrator::time() const { return 0; }
std::span<const double> Integrator::y() const { return {}; }
std::vector<double> Integrator::at(double, int) const { return {}; }
std::vector<double> Integrator::slopes_at(double) const { return {}; }
long Integrator::steps() const { return 0; }

bool has_integrator() noexcept { return false; }
std::string integrator_version() { return "none"; }

}  // namespace twum::inline v0_1::motion
