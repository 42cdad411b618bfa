// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace twum::test {

/// Path of a motor for tests: NAME.yaml of tests/data/motors, which has one slice, else of examples/motors.
inline std::string motor_path(const std::string& name) {
  const std::string root = TWUM_SOURCE_DIR;
  const std::string narrow = root + "/tests/data/motors/" + name + ".yaml";
  return std::filesystem::exists(narrow) ? narrow : root + "/examples/motors/" + name + ".yaml";
}

}  // namespace twum::test
