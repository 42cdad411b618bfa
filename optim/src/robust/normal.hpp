// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::optim {

/// phi(x)
double normal_density(double x);
/// Phi(x), to full relative precision in the lower tail.
double normal_cdf(double x);
/// Phi^-1(p); infinite at 0 and 1.
double normal_quantile(double p);
/// P(Z1 <= h, Z2 <= k) of standard normal numbers with correlation rho, to about 1e-14; arguments may be infinite.
double normal_cdf(double h, double k, double rho);

}  // namespace twum::optim
