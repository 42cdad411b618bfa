// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/units/dimension.hpp>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {

/// What a name in a formula stands for.
struct FormulaName {
  std::string text;       ///< how the canonical text has it, such as "torque_at(100 rpm)"
  Dimension dimension;    ///< of its value
  std::size_t number{0};  ///< place of its value among those that the formula is evaluated with
};

/// The names that a formula may hold.
struct FormulaNames {
  /// Reads a name with what stands in its parentheses, such as "torque_at(100 rpm)"; `alone` if the formula is nothing else.
  /// @throws ValueError with the position in the reference
  std::function<FormulaName(std::string_view reference, bool whole_text)> read;
  std::string
      expected;  ///< what is right where nothing stands, such as "expected a metric such as 'stall_torque'"
};

/// A formula with its derivatives by each name.
struct FormulaDerivative {
  double value{0};              ///< SI; NaN where the formula is not defined
  std::vector<double> by_name;  ///< in the order of the names' numbers; NaN where there is none
  bool kinked{false};  ///< at a kink of abs, min or max: of the branch that the value lies on
};

/// A formula over named quantities: numbers with units, names, + - * / ^, parentheses, sqrt, abs, exp, log (natural), min and
/// max of two. Dimensions were checked when it was read, so evaluation is arithmetic with SI numbers. Constant, and safe
/// from any number of threads.
class Formula {
 public:
  /// What one step of the evaluation does.
  enum class Operation : unsigned char {
    number,
    name,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    sqrt,
    abs,
    exp,
    log,
    min,
    max
  };

  /// One step; operands are earlier steps.
  struct Step {
    Operation operation{};  ///< what is done
    std::size_t left{0};    ///< first operand; number of a name
    std::size_t right{0};   ///< second operand
    double value{0};        ///< of a constant step, SI
    bool constant{false};   ///< no name takes part
  };

  /// The number 0; to be replaced.
  Formula() : Formula({{Operation::number, 0, 0, 0, true}}, "0", {}) {}
  /// Of steps in the order of evaluation, the last of which is the result.
  Formula(std::vector<Step> steps, std::string text, Dimension dimension);

  /// The same formula with blanks and parentheses where they belong; reads back as the same formula.
  const std::string& text() const noexcept { return text_; }
  /// Of its value.
  const Dimension& dimension() const noexcept { return dimension_; }
  /// True if no name stands in it; then value({}) is its value.
  bool constant() const noexcept { return steps_.back().constant; }
  /// True if it is a name and nothing else.
  bool is_name() const noexcept { return steps_.size() == 1 && !constant(); }

  /// Value, SI; NaN where a step has none: a quotient by zero, sqrt or log of a negative number, a number too large.
  double value(std::span<const double> names) const;
  /// Value and exact derivatives (reverse mode), in about twice the time of the value. min, max and abs are told as kinked
  /// where their branches are nearer than 1e-9 of the size of what they compare.
  FormulaDerivative differentiate(std::span<const double> names) const;

 private:
  std::vector<double> values(std::span<const double> names) const;

  std::vector<Step> steps_;
  std::string text_;
  Dimension dimension_;
};

/// Reads a formula. A unit follows its number and extends to the next blank, bracket or comma: "5 W/h" is five watts per
/// hour, "5 W / frequency" divides. "^" binds before a sign, and from the right.
/// @throws ValueError with the position in the text: what was found and what would be right
Formula read_formula(std::string_view text, const FormulaNames& names);

/// Refuses two formulas of different dimension on the two sides of a sign such as ">=".
/// @throws ValueError that names both, with the position of the sign
void require_same_dimension(const Formula& left, const Formula& right, std::string_view sign,
                            std::size_t position);

}  // namespace twum::studies
