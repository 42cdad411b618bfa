// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/motor.hpp>

#include <string>

namespace twum::python {

/// A motor as Python sees it: named, ready to be asked, immutable.
struct PyMotor {
  std::string name;
  Motor motor;
};

}  // namespace twum::python
