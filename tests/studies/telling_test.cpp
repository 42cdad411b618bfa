// SPDX-License-Identifier: Apache-2.0
// What is said about an answer, and how its renderers write it.
#include "answer_support.hpp"

#include "telling/renderers.hpp"
#include "telling/tellings.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <string>

using namespace twum;
using namespace twum::test;
using namespace twum::studies::telling;
using Catch::Matchers::Contains;

namespace {

std::string typed(const telling::Part& part) { return written(part, Writing::typed); }
std::string read(const telling::Part& part) { return written(part, Writing::read); }

// A yield of 99 %, one metric with a limit, two tolerances of which the second has 4 % of the gain of the first.
OptimizeResult robust_optimum() {
  RobustReport report;
  report.yields = {{"yield", 0.99, {0.9916, 0.9906, 0.9924}, 40000, false, "holds"}};
  report.objective = 6;
  report.nominal_objective = 16;
  report.nominal_yield = {0.085, 0.08, 0.09};
  report.largest_yield = kNaN;
  report.limits = {{"stall_torque >= 0.8 N.m",
                    true,
                    "yield",
                    2.5,
                    0,
                    0.004,
                    0.75,
                    {{"amplitude", "1", 0.9}, {"preload", "1", 0.1}},
                    true},
                   {"max_pressure <= 2 MPa",
                    false,
                    "yield",
                    3,
                    0,
                    0.001,
                    0.25,
                    {{"amplitude", "1", 0.5}, {"preload", "1", 0.5}},
                    false}};
  report.tolerances = {{"preload", "%", 3, 0.0004, 1e-6, {kNaN, kNaN, kNaN}},
                       {"amplitude", "%", 2, 0.01, 1e-5, {2e-5, 1e-5, 3e-5}}};
  report.price_of_yield = 70;
  report.prices_of_yields = {{0.9, 9}, {0.95, 8}, {0.99, 6}};
  report.densities = {
      {"stall_torque", "N.m", 0.8, INFINITY, 0.7, 0.1, {0.004, 0.6, 0.396}, {0.5, 0.5, 0}}};
  OptimizeResult result;
  result.goal = {"peak_power", "W", true};
  result.found = true;
  result.best.metrics = {{"peak_power", "W", 6}};
  result.robust = report;
  return result;
}

const Section& section_of(const std::vector<Section>& list, const std::string& heading) {
  for (const Section& section : list)
    if (written(section.heading, Writing::read) == heading) return section;
  throw std::runtime_error("no section " + heading);
}

// What a path of the page names in summary.json; * stands for each of a list.
Json at_path(const Json& json, const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string key = path.substr(0, slash);
  const auto further = [&](const Json& one) {
    return slash == std::string::npos ? one : at_path(one, path.substr(slash + 1));
  };
  if (key != "*") return further(json.is_array() ? json[std::stoul(key)] : json.at(key));
  Json list = Json::array();
  for (const Json& one : json) list.push_back(further(one));
  return list;
}

}  // namespace

TEST_CASE("names and limits are typed on the terminal and read elsewhere", "[studies][telling]") {
  CHECK(typed(name_part("stall_torque")) == "stall_torque");
  CHECK(read(name_part("stall_torque")) == "stall torque");
  CHECK(read(a_name_part("output_power_at(80 rpm)")) == "an output power at 80 rpm");
  CHECK(typed(a_name_part("peak_power")) == "a peak_power");
  CHECK(read(name_part("quantile(stall_torque, 5 %)")) == "5 % quantile of the stall torque");
  CHECK(read(name_part("probability(no_load_speed >= 100 rpm)")) ==
        "probability of no-load speed ≥ 100 rpm");
  CHECK(typed(limit_part("stall_torque >= 0.8 N.m")) == "stall_torque >= 0.8 N.m");
  CHECK(read(limit_part("stall_torque >= 0.8 N.m")) == "stall torque ≥ 800 mN·m");
  CHECK(read(limit_part("145 rpm <= no_load_speed <= 155 rpm")) ==
        "145 rpm ≤ no-load speed ≤ 155 rpm");
  CHECK(read(limit_part("yield >= 99.5 %")) == "yield ≥ 99.5 %");
  CHECK(read(limit_part("stall_torque >= 2 * torque_at(100 rpm)")).find("stall torque ≥") == 0);
}

TEST_CASE("numbers have the digits they are told with", "[studies][telling]") {
  CHECK(read(value_part(1.6e-6, "m")) == "1.6 µm");
  CHECK(typed(value_part(1.6e-6, "m")) == "1.6 um");
  CHECK(read(value_part(kNaN, "m")) == "-");
  CHECK(written(value_part(2, "N"), Writing::page) == "2\u00a0N");
  // A number is not shortened to an exponent where its digits are as short.
  CHECK(read(value_part(290, "1", 2)) == "290");
  CHECK(read(change(value_part(0.02, "W", 3))) == "+20 mW");
  CHECK(read(change(value_part(-0.02, "W", 3))) == "-20 mW");
  CHECK(read(change(value_part(0, "W", 3))) == "nothing");
  // What is very small has its power of ten as a book, or a keyboard, writes it.
  CHECK(read(value_part(1.23e-10, "1", 2)) == "1.2 · 10⁻¹⁰");
  CHECK(typed(value_part(1.23e-10, "1", 2)) == "1.2e-10");
  // Of a share near one, what is missing has two digits.
  CHECK(read(share_part(0.999985)) == "99.9985 %");
  CHECK(read(share_part(0.5, 2)) == "50 %");
  CHECK(read(share_part(1, 2)) == "100 %");
  CHECK(read(share_part(kNaN)) == "-");
}

TEST_CASE("a yield says what was found and whether it is enough", "[studies][telling]") {
  RobustYield yield = robust_optimum().robust->yields.front();
  const auto said = [&] { return written(yield_phrase(yield), Writing::typed); };
  CHECK(said() ==
        "99.16 % of the motors keep all limits (99.06 % to 99.24 %, from 40000 motors "
        "drawn after the search). This reaches the required share, 99 %.");
  yield.verdict = "broken";
  CHECK_THAT(said(), Contains("This is below the required share, 99 %."));
  yield.verdict = "not-distinguishable";
  CHECK_THAT(
      said(),
      Contains("The sample is too small to distinguish this from the required share, 99 %."));
  yield = {"probability(a)", kNaN, {0.999985, 0.99998, 0.99999}, 1000, true, ""};
  CHECK_THAT(said(),
             Contains(", 15 in a million fail (") && Contains("weighted") && !Contains("required"));
}

TEST_CASE("tolerances stand by their gain, and the cheap ones may be loosened",
          "[studies][telling]") {
  const OptimizeResult result = robust_optimum();
  const std::vector<Section> list = sections(result_of(result));
  const Section& costs = section_of(list, "Cost of the tolerances");
  CHECK(written(costs.tables[0].rows[0][0], Writing::typed) == "amplitude");
  CHECK(written(costs.sentences[0], Writing::typed) ==
        "Tighten the tolerance of the amplitude (2 %) first. Solve again with a tighter tolerance "
        "to see the gain. That of preload costs less than 5 % of it: try twice the spread, and "
        "solve again.");
  OptimizeResult dear = result;
  dear.robust->tolerances[0].gain = 0.0006;  // 6 % of the first
  CHECK_THAT(written(section_of(sections(result_of(dear)), "Cost of the tolerances").sentences[0],
                     Writing::typed),
             !Contains("preload"));
  // Where the wanted yield is not reached there is no gain to speak of.
  dear.robust->largest_yield = 0.98;
  CHECK(section_of(sections(result_of(dear)), "Cost of the tolerances").sentences.empty());
  CHECK_THAT(headline_text(dear, "infeasible"),
             Contains("The required yield cannot be reached; the largest found is 98 %."));
}

TEST_CASE("a limit whose worst point is not known is not explained", "[studies][telling]") {
  const std::vector<Section> list = sections(result_of(robust_optimum()));
  const Section& risk = section_of(list, "Causes of failures");
  CHECK_THAT(written(risk.sentences[0], Writing::typed), Contains("max_pressure <= 2 MPa"));
  CHECK(written(risk.tables[0].rows[1][4], Writing::typed) == "-");
  CHECK(written(risk.tables[0].rows[0][4], Writing::typed) == "90 %");
}

TEST_CASE("the numbers of a chart are those of summary.json that it names", "[studies][telling]") {
  const OptimizeResult result = robust_optimum();
  const Json summary = answer_json(result);
  int named = 0;
  for (const Section& section : sections(result_of(result)))
    for (const Chart& chart : section.charts)
      for (const Series& series : chart.series)
        for (const Numbers* numbers : {&series.x, &series.y})
          if (!numbers->where.empty()) {
            CHECK(at_path(summary, numbers->where).get<std::vector<double>>() == numbers->values);
            ++named;
          }
  CHECK(named ==
        5);  // those without tolerances of a density; yield and goal of the price, as line and dots
}

TEST_CASE("Markdown has what the terminal has, and no markup of the names", "[studies][telling]") {
  StudyResult result = result_of(robust_optimum(), "optimal");
  result.study = "a_study";
  result.model_notes = {"Mind the *layer*"};
  const std::string text = summary_markdown(result);
  CHECK_THAT(text, Contains("# a\\_study\n"));
  CHECK_THAT(text, Contains("\n| stall torque ≥ 800 mN·m | 0.4 % | 75 % | 2.5 | 90 % | 10 % |\n"));
  CHECK_THAT(text, Contains("\n- Mind the \\*layer\\*\n"));
  // Each table has one line of dashes, with as many cells as its head.
  std::istringstream lines(text);
  std::string before, line;
  while (std::getline(lines, line)) {
    if (line.starts_with("| ---"))
      CHECK(std::count(before.begin(), before.end(), '|') ==
            std::count(line.begin(), line.end(), '|'));
    before = line;
  }
}

TEST_CASE("a terminal shows the columns that are typed, and counts the rows that it leaves out",
          "[studies][telling]") {
  Section section{{"A section"}};
  Table table{"table", {{"name"}, {"first"}, {"second"}}, {}};
  table.typed = 2;
  for (int i = 1; i <= 22; ++i)
    table.rows.push_back({{std::to_string(i)}, {value_part(i, "N")}, {"told above"}});
  section.tables = {table};
  const std::string text = terminal_text({section});
  CHECK_THAT(
      text, Contains("\n20    20 N\nand 2 more rows, see the report\n") && !Contains("told above"));
  CHECK_THAT(markdown({section}), Contains("\n| 22 | 22 N | told above |\n"));
}

TEST_CASE("a section that is nothing but a part of the page is not written", "[studies][telling]") {
  Section hook;
  hook.hook = "motor";
  CHECK(terminal_text({hook}).empty());
  CHECK(markdown(std::vector<Section>{hook}).empty());
}

TEST_CASE("in Markdown neighbouring parts that stand out share one pair of marks",
          "[studies][telling]") {
  CHECK(markdown(Phrase{"a ", strong("b"), strong(" = 2"), " c"}) == "a **b = 2** c");
  CHECK(markdown(Phrase{strong("a"), " b ", strong("c")}) == "**a** b **c**");
  CHECK(markdown(Phrase{}).empty());
}

TEST_CASE("a notebook draws neither maps nor crowds, nor what pictures alone have",
          "[studies][telling]") {
  Section section{{"Designs"}};
  Chart chart{"designs", {"designs"}, {{"preload"}, "N"}, {{"torque"}, "N.m"}};
  chart.series = {{"", Stroke::dots, {"", {1, 2}}, {"", {3, 4}}}};
  section.charts = {chart};
  CHECK_THAT(html(std::vector<Section>{section}), Contains("<svg"));
  Section printed = section;
  printed.on_page = false;
  CHECK(html(std::vector<Section>{printed}).empty());
  Section map = section;
  map.charts.front().colours = {{"power"}, "W"};
  CHECK(html(std::vector<Section>{map}).empty());
  Section crowd = section;
  crowd.charts.front().series.front().y.values.resize(100000);
  CHECK(html(std::vector<Section>{crowd}).empty());
}
