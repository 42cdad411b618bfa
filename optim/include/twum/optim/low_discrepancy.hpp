// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace twum::optim {

/// The first `count` points of the Sobol sequence (Joe and Kuo's directions) in [0, 1)^dimension,
/// none skipped, shifted modulo 1 by a random vector that follows the seed.
/// @throws InputError for a dimension of 0 or beyond 3667.
std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count,
                                              std::uint64_t seed);

}  // namespace twum::optim
