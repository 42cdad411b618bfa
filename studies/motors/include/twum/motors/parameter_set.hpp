// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/shape.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

/// A named set of parameters, such as those of one lining.
struct ParameterSet {
  std::string name{};  ///< its name in results
  std::string file{};  ///< path of the file with its values; empty if there is none
  std::vector<ParameterValue> values{};  ///< SI, each parameter once

  /// True if the set gives this parameter or its alternative.
  bool gives(Parameter parameter) const;
};

/// Shape of a file with a set: any parameters of a motor file, in the same blocks. Static lifetime.
const Shape<std::vector<ParameterValue>>& parameter_set_shape();

/// Reads the text of a file with a set.
/// @throws FileError with everything that is wrong in it; also for a file without parameters.
std::vector<ParameterValue> read_parameter_set(const Source& source);

}  // namespace twum::inline v0_1::motors
