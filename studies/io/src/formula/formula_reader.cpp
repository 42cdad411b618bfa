// SPDX-License-Identifier: Apache-2.0
#include "formula/formula_builder.hpp"
#include "text/utf8.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

using Operation = Formula::Operation;

struct Function {
  std::string_view name;
  Operation operation;
  bool two;  // operands
};

constexpr std::array<Function, 6> kFunctions{{{"sqrt", Operation::sqrt, false},
                                              {"abs", Operation::abs, false},
                                              {"exp", Operation::exp, false},
                                              {"log", Operation::log, false},
                                              {"min", Operation::min, true},
                                              {"max", Operation::max, true}}};

constexpr const char* kBlanksRound =
    "a unit extends to the next blank; put blanks round an operator that follows it";

const Function* find_function(std::string_view name) {
  for (const Function& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_bracket(char c) { return std::string_view("()[]{},").find(c) != std::string_view::npos; }

// Recursive descent:
//   sum = product {("+" | "-") product}      product = signed {("*" | "/") signed}
//   signed = ("+" | "-") signed | power      power = operand ["^" signed]
//   operand = number [unit] | name ["(" ... ")"] | "(" sum ")"
class Reader {
 public:
  Reader(std::string_view text, const FormulaNames& names) : text_(text), names_(names) {}

  Formula read() {
    skip_blanks();
    const FormulaPart whole = sum();
    if (at_ < text_.size()) refuse_rest(whole);
    return std::move(builder_).finish(whole);
  }

 private:
  // Depth of parentheses and signs, which the stack of the process has to hold.
  struct Level {
    explicit Level(Reader& reader) : depth(reader.depth_) {
      constexpr int kMostLevels = 200;
      if (++depth > kMostLevels)
        throw ValueError("more than 200 levels of parentheses and signs",
                         "write a simpler expression", reader.at_);
    }
    ~Level() { --depth; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    int& depth;
  };

  void skip_blanks() {
    while (const std::size_t blank = leading_blank(text_.substr(at_))) at_ += blank;
  }

  bool ended() const { return at_ == text_.size(); }
  bool sees(char c) const { return !ended() && text_[at_] == c; }

  // Takes one of some characters if it is next, with the blanks after it.
  std::optional<char> take(std::string_view any) {
    if (ended() || any.find(text_[at_]) == std::string_view::npos) return {};
    const char found = text_[at_++];
    skip_blanks();
    return found;
  }

  FormulaPart sum() {
    const Level level(*this);
    FormulaPart left = product();
    for (std::size_t sign = at_; const auto found = take("+-"); sign = at_)
      left = builder_.binary(*found == '+' ? Operation::add : Operation::subtract, left, product(),
                             sign);
    return left;
  }

  FormulaPart product() {
    FormulaPart left = with_sign();
    for (std::size_t sign = at_; const auto found = take("*/"); sign = at_) {
      if (sees('*')) throw ValueError("found '**'", "write a power with '^'", sign);
      left = builder_.binary(*found == '*' ? Operation::multiply : Operation::divide, left,
                             with_sign(), sign);
    }
    return left;
  }

  FormulaPart with_sign() {
    const Level level(*this);
    const std::size_t sign = at_;
    const auto found = take("+-");
    if (!found) return power();
    const FormulaPart operand = with_sign();
    return *found == '-' ? builder_.unary(Operation::negate, operand, sign) : operand;
  }

  FormulaPart power() {
    const FormulaPart base = operand();
    const std::size_t sign = at_;
    if (!take("^")) return base;
    return builder_.binary(Operation::power, base, with_sign(), sign);
  }

  FormulaPart operand() {
    if (ended()) throw ValueError(at_ == 0 ? "empty" : "ends too early", names_.expected, at_);
    const char next = text_[at_];
    if (is_digit(next) || next == '.') return number();
    if (begins_name(next)) return named();
    if (next != '(') throw ValueError("found " + rest(), names_.expected, at_);
    const std::size_t open = at_;
    take("(");
    FormulaPart inside = sum();
    close(open);
    return inside;
  }

  void close(std::size_t open) {
    if (take(")")) return;
    if (!ended()) throw ValueError("found " + rest(), "expected an operator or ')'", at_);
    throw ValueError(io::quoted(text_.substr(open)) + " has no ')'", "close the parenthesis", at_);
  }

  // The text up to the next blank.
  std::string rest() const {
    std::size_t end = at_;
    while (end < text_.size() && leading_blank(text_.substr(end)) == 0) ++end;
    return io::quoted(text_.substr(at_, end - at_));
  }

  [[noreturn]] void refuse_rest(const FormulaPart& before) const {
    throw ValueError("found " + rest() + " after " + io::quoted(before.text),
                     sees(')')
                         ? "it closes no parenthesis; in a YAML list, quote text that holds a comma"
                         : "expected an operator: '+', '-', '*', '/' or '^'",
                     at_);
  }

  FormulaPart number() {
    const std::size_t begin = at_;
    const std::size_t length = number_prefix(text_.substr(at_));
    if (length == 0) throw ValueError(rest() + " is not a number", names_.expected, at_);
    at_ += length;
    std::string text(text_.substr(begin, length));
    skip_blanks();
    const std::size_t unit_at = at_;
    const std::string_view unit = take_unit();
    if (unit.find('+') != std::string_view::npos)  // UDUNITS takes "W+3" for W^3
      throw ValueError(io::quoted(unit) + " is not a unit", kBlanksRound, unit_at);
    if (!unit.empty()) text += " " + std::string(unit);
    try {
      return builder_.number(parse_measure(text), text);
    } catch (const ValueError& error) {
      if (unit.empty() || error.position() == 0)
        throw ValueError(error.found(), error.expected(), begin);
      throw ValueError(error.found(), unit_remedy(unit, error), unit_at);
    }
  }

  // Advice for an unknown unit, which may be an operator without blanks, or a name after a number.
  std::string unit_remedy(std::string_view unit, const ValueError& error) const {
    if (unit.find_first_of("+-*/^") != std::string_view::npos) return kBlanksRound;
    try {
      names_.read(unit, false);
    } catch (const ValueError&) {
      return error.expected();
    }
    return "write '*' between a number and a name";
  }

  // A unit begins with a letter, "%", or "1/" and a letter: after a number, "1/s" can be nothing else.
  bool begins_unit() const {
    const std::string_view text = text_.substr(at_);
    const std::string_view unit = text.starts_with("1/") ? text.substr(2) : text;
    return !unit.empty() && (begins_name(unit[0]) || text[0] == '%');
  }

  // The unit after a number, up to the next blank, bracket or comma; "(m.K)" in "W/(m.K)" belongs to it.
  std::string_view take_unit() {
    const std::size_t begin = at_;
    if (!begins_unit()) return {};
    while (!ended() && leading_blank(text_.substr(at_)) == 0) {
      if (sees('(') && std::string_view("./*").find(text_[at_ - 1]) != std::string_view::npos) {
        at_ = closing(at_);
        if (!ended()) ++at_;
        continue;
      }
      if (is_bracket(text_[at_])) break;
      ++at_;
    }
    const std::string_view unit = text_.substr(begin, at_ - begin);
    skip_blanks();
    return unit;
  }

  // Place of the parenthesis that closes the one at `open`; the end of the text if there is none.
  std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t i = open; i < text_.size(); ++i) {
      if (text_[i] == '(') ++depth;
      if (text_[i] == ')' && --depth == 0) return i;
    }
    return text_.size();
  }

  FormulaPart named() {
    const std::size_t begin = at_;
    while (!ended() && leading_blank(text_.substr(at_)) == 0 &&
           (begins_name(text_[at_]) || is_digit(text_[at_])))
      ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    skip_blanks();
    const Function* function = find_function(name);
    if (function != nullptr) return called(*function, begin);
    return referred(begin, begin + name.size());
  }

  // A name with its argument in parentheses, read by the caller's function.
  FormulaPart referred(std::size_t begin, std::size_t end) {
    if (sees('(')) {
      end = closing(at_) + 1;
      if (end > text_.size())
        throw ValueError(io::quoted(text_.substr(begin)) + " has no ')'", "close the parenthesis",
                         text_.size());
    }
    const std::string_view reference = text_.substr(begin, end - begin);
    at_ = end;
    skip_blanks();
    const bool whole_text = ended() && trimmed(text_) == reference;
    try {
      return builder_.name(names_.read(reference, whole_text));
    } catch (const ValueError& error) {
      throw ValueError(error.found(), error.expected(), begin + error.position());
    }
  }

  FormulaPart called(const Function& function, std::size_t begin) {
    const std::string name(function.name);
    const std::string usage = "expected '" + name + (function.two ? "(A, B)'" : "(A)'");
    if (!take("("))
      throw ValueError(io::quoted(name) + " needs " + (function.two ? "two values" : "a value") +
                           " in parentheses",
                       usage, at_);
    const FormulaPart first = sum();
    if (!function.two) {
      close(begin);
      return builder_.unary(function.operation, first, begin);
    }
    if (!take(","))
      throw ValueError(io::quoted(text_.substr(begin, at_ - begin)) + " has one value",
                       usage + "; in a YAML list, quote text that holds a comma", at_);
    const FormulaPart second = sum();
    close(begin);
    return builder_.binary(function.operation, first, second, begin);
  }

  std::string_view text_;
  const FormulaNames& names_;
  FormulaBuilder builder_;
  std::size_t at_{0};
  int depth_{0};
};

}  // namespace

Formula read_formula(std::string_view text, const FormulaNames& names) {
  return Reader(text, names).read();
}

}  // namespace twum::inline v0_1::io
