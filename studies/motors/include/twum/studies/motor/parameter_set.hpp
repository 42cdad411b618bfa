// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/schema/shape.hpp>

#include <string>
#include <vector>

namespace twum::studies {

/// Parameters that belong together, such as those of one lining.
struct ParameterSet {
  std::string name;                    ///< what results call it
  std::string file;                    ///< path of the file with its values; empty: there is none
  std::vector<ParameterValue> values;  ///< SI, each parameter once

  /// True if the set gives this parameter, or its twin, which says the same in another way.
  bool gives(Parameter parameter) const;
};

/// The values in a file of a set: any of the parameters of a motor file, in the same blocks; static lifetime.
const Shape<std::vector<ParameterValue>>& parameter_set_shape();

/// Reads the text of a file of a set.
/// @throws FileError with everything that is wrong in it; a file without a parameter is wrong.
std::vector<ParameterValue> read_parameter_set(const Source& source);

}  // namespace twum::studies
