// SPDX-License-Identifier: Apache-2.0
#include "study/distribution_entries.hpp"

#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/units/units.hpp>

#include <string>

namespace twum::studies::entries {
namespace {

class Shape {
 public:
  Shape(const YamlNode& node, const ParameterInfo& parameter)
      : node_(node), parameter_(parameter) {}

  Distribution read() const {
    const std::string name = find("distribution").scalar;
    if (name == "normal") return Distribution::normal(value("mean"), spread());
    if (name == "lognormal") return lognormal();
    ordered("min", "max");
    if (name == "triangular") {
      if (value("mode") < value("min") || value("mode") > value("max"))
        throw ValueError(quoted(find("mode").scalar), "must be from min to max");
      return Distribution::triangular(value("min"), value("mode"), value("max"));
    }
    // Whole numbers: each has the same share once draws are rounded.
    const double half = parameter_.integer ? 0.5 : 0.0;
    return Distribution::uniform(value("min") - half, value("max") + half);
  }

 private:
  const YamlNode& find(const char* name) const {
    const YamlNode* node = node_.find(name);
    if (node == nullptr) throw ValueError(std::string("no ") + name, "is needed");
    return *node;
  }
  double value(const char* name) const {
    return parse_quantity(find(name).scalar, {parameter_.unit, parameter_.example});
  }
  double spread() const {
    if (!(value("sd") > 0)) throw ValueError(quoted(find("sd").scalar), "must be more than 0");
    return value("sd");
  }
  void ordered(const char* low, const char* high) const {
    if (!(value(low) < value(high)))
      throw ValueError(quoted(find(high).scalar), "must be more than " + find(low).scalar);
  }
  Distribution lognormal() const {
    if (!(value("mean") > 0)) {
      throw ValueError(quoted(find("mean").scalar) + " as the mean of a lognormal distribution",
                       "must be more than 0");
    }
    // Beyond, the variance of the logarithm is lost in rounding, or infinite.
    const double ratio = spread() / value("mean");
    if (!(ratio >= 1e-7 && ratio <= 1e7)) {
      throw ValueError(quoted(find("mean").scalar) + " with a standard deviation of " +
                           quoted(find("sd").scalar) + ", of a lognormal distribution",
                       "the deviation must be from 1e-7 to 1e7 times the mean");
    }
    return Distribution::lognormal(value("mean"), spread());
  }

  const YamlNode& node_;
  const ParameterInfo& parameter_;
};

}  // namespace

Distribution distribution(const YamlNode& node, const ParameterInfo& parameter) {
  const double half = parameter.integer ? 0.5 : 0.0;
  return Shape(node, parameter).read().within(parameter.min - half, parameter.max + half);
}

}  // namespace twum::studies::entries
