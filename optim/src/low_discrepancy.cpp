// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/random.hpp>

#include <boost/random/sobol.hpp>
#include <cmath>

namespace twum::optim {

std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count,
                                              std::uint64_t seed) {
  constexpr std::size_t kDimensions = 3667;  // of the direction numbers that Boost carries
  if (dimension == 0 || dimension > kDimensions)
    throw InputError("Sobol sequence: dimension " + std::to_string(dimension) +
                     " is outside 1 to 3667");
  boost::random::sobol engine(dimension);
  Random random(seed, 0x50B01, 0);
  std::vector<double> shift(dimension);
  for (double& s : shift) s = random.uniform();
  std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
  // Boost's sequence begins behind the origin: the origin is put back as the first point.
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < dimension; ++j) {
      const double base = i == 0 ? 0.0 : static_cast<double>(engine()) * 0x1.0p-64;
      const double sum = base + shift[j];
      points[i][j] = sum >= 1.0 ? sum - 1.0 : sum;
    }
  }
  return points;
}

}  // namespace twum::optim
