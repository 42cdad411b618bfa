// SPDX-License-Identifier: Apache-2.0
// Results side by side: what stands in a summary.json is found again, and what only one has is a gap.
#include "support/scratch_folder.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/comparison.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

// Directories of results that hold nothing but these summaries.
class Results {
 public:
  explicit Results(const std::vector<std::string>& summaries) {
    for (const std::string& summary : summaries) {
      names_.push_back(folder_.path(std::string(1, static_cast<char>('a' + names_.size()))));
      std::filesystem::create_directory(names_.back());
      std::ofstream(names_.back() + "/summary.json") << summary;
    }
  }
  const std::vector<std::string>& names() const { return names_; }
  Comparison compared() const { return compare_results(names_); }

 private:
  test::ScratchFolder folder_;
  std::vector<std::string> names_;
};

const ComparisonRow& row(const Comparison& comparison, const std::string& group,
                         const std::string& name) {
  for (const ComparisonRow& one : comparison.rows) {
    if (one.group == group && one.name == name) return one;
  }
  throw std::runtime_error("no row " + group + ": " + name);
}

std::size_t rows_of(const Comparison& comparison, const std::string& group) {
  std::size_t count = 0;
  for (const ComparisonRow& one : comparison.rows) count += one.group == group ? 1 : 0;
  return count;
}

using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("optima are compared by design, metrics and certificate", "[studies][compare]") {
  const Results results(
      {R"json({"study": "a", "kind": "optimize", "outcome": "optimal", "evaluations": 120, "seed": 1,
               "failures": {"lift-off": 3, "no-load": 4},
               "best": {"design": {"amplitude": 1.5e-6, "preload": 150},
                        "metrics": {"peak_power": 4.5, "torque_at(50 rpm)": 0.5},
                        "certificate": {"passed": true}}})json",
       R"json({"study": "b", "kind": "size", "outcome": "feasible", "evaluations": 80, "seed": 1,
               "failures": {},
               "best": {"design": {"preload": 180}, "certificate": {"passed": false},
                        "metrics": {"peak_power": null}}})json",
       R"json({"study": "c", "kind": "optimize", "outcome": "failed", "best": null})json"});
  const Comparison comparison = results.compared();
  CHECK(comparison.names == results.names());
  CHECK(row(comparison, "study", "kind").words == Words{"optimize", "size", "optimize"});
  CHECK(row(comparison, "study", "outcome").words == Words{"optimal", "feasible", "failed"});
  CHECK(row(comparison, "study", "evaluations").words == Words{"120", "80", ""});
  CHECK(row(comparison, "study", "failures").words == Words{"7", "0", "0"});
  CHECK(row(comparison, "study", "certified").words == Words{"yes", "no", ""});
  // Rows of a group stand together, though the certificate comes last in the file.
  CHECK(comparison.rows[rows_of(comparison, "study") - 1].name == "certified");

  const ComparisonRow& preload = row(comparison, "best design", "preload");
  CHECK(preload.unit == "N");
  CHECK(preload.values[0] == 150);
  CHECK(preload.values[1] == 180);
  CHECK(std::isnan(preload.values[2]));
  CHECK(preload.words.empty());
  const ComparisonRow& amplitude = row(comparison, "best design", "amplitude");
  CHECK(amplitude.values[0] == 1.5e-6);
  CHECK(std::isnan(amplitude.values[1]));
  CHECK(std::isnan(row(comparison, "metrics there", "peak_power").values[1]));  // null
  CHECK(row(comparison, "metrics there", "peak_power").unit == "W");
  CHECK(row(comparison, "metrics there", "torque_at(50 rpm)").unit == "N.m");
}

TEST_CASE("an optimum without a certificate is neither certified nor not", "[studies][compare]") {
  const Results results({R"({"best": {"design": {"preload": 150}, "metrics": {}}})",
                         R"({"best": {"design": {"preload": 160}, "certificate": {}}})",
                         R"({"best": {"design": {"preload": 170}, "certificate": null}})"});
  const Comparison comparison = results.compared();
  CHECK(row(comparison, "best design", "preload").values == Numbers{150, 160, 170});
  CHECK_THROWS_AS(row(comparison, "study", "certified"), std::runtime_error);
}

TEST_CASE("fronts are compared by how far they reach", "[studies][compare]") {
  const Results results({R"({"front": [{"metrics": {"peak_power": 3, "max_pressure": 2e6}},
                     {"metrics": {"peak_power": 1, "max_pressure": null}},
                     {"metrics": {"peak_power": 2, "max_pressure": 5e6}}], "hypervolume": 7.5})",
                         R"({"front": [], "hypervolume": null})", R"({"front": null})"});
  const Comparison comparison = results.compared();
  CHECK(row(comparison, "front", "points").words == Words{"3", "0", ""});
  CHECK(row(comparison, "front", "hypervolume").values[0] == 7.5);
  CHECK(std::isnan(row(comparison, "front", "hypervolume").values[1]));
  CHECK(row(comparison, "front", "least peak_power").values[0] == 1);
  CHECK(row(comparison, "front", "most peak_power").values[0] == 3);
  CHECK(row(comparison, "front", "most peak_power").unit == "W");
  CHECK(row(comparison, "front", "least max_pressure").values[0] == 2e6);
  CHECK(row(comparison, "front", "most max_pressure").values[0] == 5e6);
  CHECK(std::isnan(row(comparison, "front", "most max_pressure").values[2]));
}

TEST_CASE("spreads, yields and estimates are compared by name", "[studies][compare]") {
  const Results results(
      {R"({"metrics": {"stall_torque": {"min": 0.4, "median": 0.5, "max": 0.7, "count": 12}}})",
       R"({"metrics": {"stall_torque": {"mean": {"value": 0.55, "low": 0.5, "high": 0.6}, "sd": 0.1},
                       "peak_power": 3},
           "yield": {"value": 0.9, "low": 0.8, "high": 1}})",
       R"({"estimates": {"kinetic_friction": {"value": 0.2, "low": 0.1}, "youngs_modulus": {}},
           "residual_rms": 0.012})"});
  const Comparison comparison = results.compared();
  for (const auto& [name, value] : {std::pair{"min", 0.4}, {"median", 0.5}, {"max", 0.7}}) {
    const ComparisonRow& one = row(comparison, name, "stall_torque");
    CHECK(one.values[0] == value);
    CHECK(std::isnan(one.values[1]));
    CHECK(one.unit == "N.m");
  }
  CHECK(row(comparison, "mean", "stall_torque").values[1] == 0.55);  // of a value with an interval
  CHECK(row(comparison, "sd", "stall_torque").values[1] == 0.1);     // of a bare one
  CHECK(row(comparison, "yield", "yield").values[1] == 0.9);
  CHECK(row(comparison, "estimate", "kinetic_friction").values[2] == 0.2);
  CHECK(row(comparison, "estimate", "kinetic_friction").unit == "1");
  CHECK(std::isnan(row(comparison, "estimate", "youngs_modulus").values[2]));
  CHECK(row(comparison, "estimate", "residual_rms").values[2] == 0.012);
  // Every row is as wide as there are results.
  for (const ComparisonRow& one : comparison.rows) CHECK(one.words.size() + one.values.size() == 3);
}

TEST_CASE("indices are compared by metric and variable, in their units", "[studies][compare]") {
  const Results results(
      {R"({"indices": {"stall_torque": {"preload": {"first": {"value": 0.3}, "total": {"value": 0.4}},
                                        "amplitude": null},
                       "peak_power": null}})",
       R"({"indices": {"stall_torque": {"preload": {"mu_star": 0.05, "sigma": 0.01}}}})",
       R"({"indices": {"stall_torque": {"preload": {"elasticity": 1, "gradient": 0.004}}}})"});
  const Comparison comparison = results.compared();
  CHECK(row(comparison, "first of stall_torque", "preload").values[0] == 0.3);
  CHECK(row(comparison, "total of stall_torque", "preload").values[0] == 0.4);
  CHECK(row(comparison, "total of stall_torque", "preload").unit == "1");
  CHECK(row(comparison, "mu_star of stall_torque", "preload").values[1] == 0.05);
  CHECK(row(comparison, "mu_star of stall_torque", "preload").unit == "N.m");
  CHECK(row(comparison, "elasticity of stall_torque", "preload").values[2] == 1);
  CHECK(row(comparison, "elasticity of stall_torque", "preload").unit == "1");
  CHECK(rows_of(comparison, "first of stall_torque") == 1);
}

TEST_CASE("curves are compared one by one, and strange names have no unit", "[studies][compare]") {
  const Results results({R"({"motor": "m", "seed": null, "curves": [
      {"metrics": {"stall_torque": 0.6}}, {"metrics": {"stall_torque": 0.7, "zeal": 3}}]})"});
  const Comparison comparison = results.compared();
  CHECK(row(comparison, "curve 1", "stall_torque").values == Numbers{0.6});
  CHECK(row(comparison, "curve 2", "stall_torque").values == Numbers{0.7});
  CHECK(row(comparison, "curve 2", "zeal").unit == "1");
  CHECK(row(comparison, "study", "seed").words == Words{"null"});
}

TEST_CASE("what a later result adds stands with its group", "[studies][compare]") {
  const Results results(
      {R"({"kind": "optimize", "failures": {"a": 2, "b": null, "c": "many"},
           "best": {"design": {"preload": 150}, "metrics": {"stall_torque": 1, "peak_power": 2}},
           "yield": 0.9})",
       R"({"outcome": "done", "best": {"design": {"amplitude": 1e-6, "thickness": 3e-4, "preload": 1},
                                       "metrics": {"no_load_speed": 10, "max_torque": 1}}})"});
  const Comparison comparison = results.compared();
  CHECK(row(comparison, "study", "failures").words == Words{"2", "0"});  // what is no count is none
  Words order;
  for (const ComparisonRow& one : comparison.rows) order.push_back(one.group + ": " + one.name);
  CHECK(order == Words{"study: kind", "study: failures", "study: outcome", "best design: preload",
                       "best design: amplitude", "best design: thickness",
                       "metrics there: stall_torque", "metrics there: peak_power",
                       "metrics there: no_load_speed", "metrics there: max_torque",
                       "yield: yield"});
}

TEST_CASE("what is no result is refused by the name of its directory",
          "[studies][compare][errors]") {
  const auto refusal = [](const std::vector<std::string>& directories) -> std::string {
    try {
      compare_results(directories);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  const Results results({"{}", "[]", "{", R"({"best": {"certificate": {"passed": "perhaps"}}})"});
  const auto& names = results.names();
  CHECK(refusal({names[0], names[0]}) == "accepted");
  CHECK(refusal({names[0], names[1]}) == names[1] + "/summary.json: is damaged: not a JSON object");
  CHECK(refusal({names[2]}) == names[2] + "/summary.json: is damaged: not a JSON object");
  CHECK_THAT(refusal({names[3]}), Contains(names[3] + "/summary.json: is damaged: "));
  CHECK_THROWS_AS(compare_results(std::vector{names[3]}), StoreError);

  const test::ScratchFolder folder;
  CHECK(refusal({folder.path("none")}) ==
        folder.path("none") + ": no such directory; give one that 'twum run' wrote");
  CHECK(refusal({folder.folder()}) ==
        folder.folder() + ": holds no result: there is no summary.json");
  CHECK_THROWS_AS(compare_results(std::vector{folder.folder()}), InputError);
  // A directory in the place of the file opens, but gives nothing to read.
  std::filesystem::create_directory(folder.path("summary.json"));
  CHECK_THAT(refusal({folder.folder()}),
             EndsWith("summary.json: cannot be read: it is not an ordinary file"));
}
