// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::motors {

/// A property of a material.
struct MaterialValue {
  std::string name;    ///< as in `materials/`, such as "youngs_modulus"
  std::string unit;    ///< SI, "1" if dimensionless
  double value;        ///< in that unit
  std::string typed;   ///< as in the catalogue, such as "110 GPa"
  std::string source;  ///< where it was published, or "typical": a usual value of the class
};

/// A material of the catalogue.
struct Material {
  std::string name;                   ///< such as "apc-840"
  std::string kind;                   ///< "metal", "piezoceramic" or "lining"
  std::string text;                   ///< what it is, in one line
  std::vector<MaterialValue> values;  ///< in the order of its file

  /// A property by its name; null if the catalogue has no value for it.
  const MaterialValue* find(std::string_view property) const;
};

/// The catalogue that comes with the program, the files of `materials/`, by name; static lifetime.
std::span<const Material> material_catalogue();

/// A material by its name; static lifetime.
/// @param kinds  admissible kinds, such as "metal"; empty: any
/// @throws ValueError for an unknown name or one of another kind, with the nearest admissible name
const Material& find_material(std::string_view name, std::span<const std::string_view> kinds = {});

}  // namespace twum::inline v0_1::motors
