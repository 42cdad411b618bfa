// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/formula.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// Precedence of the outermost operation of a text, which decides whether it needs parentheses.
enum class Binding : unsigned char { sum, product, sign, power, quantity, atom };

/// A part of a formula that is being read.
struct FormulaPart {
  std::size_t step{0};  ///< its last step
  std::string text;     ///< canonical
  Binding binding{};    ///< of the text
  Dimension dimension;  ///< of its value
};

/// Builds a formula step by step: checks dimensions, evaluates constant parts, and writes the canonical text.
class FormulaBuilder {
 public:
  using Operation = Formula::Operation;

  /// @param text  the number with its unit
  FormulaPart number(const Measure& measure, std::string text);
  FormulaPart name(const FormulaName& name);
  /// An operator between two parts, or min and max.
  /// @param at  position of the operator, for errors
  FormulaPart binary(Operation operation, const FormulaPart& left, const FormulaPart& right,
                     std::size_t at);
  /// A sign or a function of one part.
  FormulaPart unary(Operation operation, const FormulaPart& operand, std::size_t at);
  /// The formula that ends with a part.
  Formula finish(const FormulaPart& part) &&;

 private:
  FormulaPart add(Formula::Step step, std::string text, Binding binding, const Dimension& dimension,
                  std::size_t at);
  Dimension dimension_of(Operation operation, const FormulaPart& left, const FormulaPart& right,
                         std::size_t at) const;
  Dimension power_dimension(const FormulaPart& base, const FormulaPart& exponent,
                            std::size_t at) const;

  std::vector<Formula::Step> steps_;
};

}  // namespace twum::inline v0_1::io
