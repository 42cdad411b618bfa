// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metrics.hpp>
#include <twum/io/result_store.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/telling.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

using namespace twum;
using namespace twum::studies;

namespace {

// A sweep run in a folder of its own, and its rows.
struct Sweep {
  explicit Sweep(const std::string& entries, unsigned jobs = 2) {
    const std::string path = folder.path("sweep.yaml");
    std::ofstream(path) << "twum: 1\nmotor: " << test::motor_path("ring-60")
                        << "\nstudy:\n  kind: sweep\n"
                        << entries;
    file = read_study_file(path);
    RunOptions options;
    options.jobs = jobs;
    result = run_study(file, folder.path("out"), options);
    ResultStore(folder.path("out/results.db")).read([&](const StoredRow& row) {
      rows.push_back(row);
    });
  }
  const SweepResult& answer() const { return std::get<SweepResult>(result.answer); }

  test::ScratchFolder folder;
  StudyFile file{};
  StudyResult result;
  std::vector<StoredRow> rows;
};

double metric(const MotorDesign& design, Metric metric) {
  return evaluate(Motor(design), MetricRequest{metric, Argument::none, 0}).value;
}

}  // namespace

TEST_CASE("each stratum of a Latin hypercube holds one point", "[studies][sweep][identity]") {
  const std::uint64_t count = GENERATE(1U, 2U, 3U, 5U, 16U, 17U, 1000U, 4097U);
  const std::uint64_t seed = GENERATE(1U, 2U, 99U);
  CAPTURE(count, seed);
  const optim::LatinHypercube hypercube(4, count, seed);
  std::vector<std::vector<int>> hits(4, std::vector<int>(count, 0));
  std::vector<double> point(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    hypercube.point(i, point);
    for (std::size_t j = 0; j < 4; ++j) {
      REQUIRE((point[j] >= 0 && point[j] < 1));
      ++hits[j][static_cast<std::size_t>(point[j] * static_cast<double>(count))];
    }
  }
  for (const auto& column : hits)
    CHECK(std::all_of(column.begin(), column.end(), [](int n) { return n == 1; }));
}

TEST_CASE("the coordinates of a Latin hypercube are shuffled apart", "[studies][sweep]") {
  // Of independent permutations of n, the rank correlation has mean 0 and variance 1 / (n - 1); six
  // standard deviations are met once in 5e8 pairs.
  const std::uint64_t count = 2000;
  const optim::LatinHypercube hypercube(5, count, 1);
  const double middle = (static_cast<double>(count) - 1) / 2;
  const double variance = (static_cast<double>(count * count) - 1) / 12;
  const auto place = [&](std::uint64_t i, std::size_t j) {
    return j == 5 ? static_cast<double>(i) : static_cast<double>(hypercube.stratum(i, j));
  };
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double sum = 0;
      for (std::uint64_t i = 0; i < count; ++i)
        sum += (place(i, a) - middle) * (place(i, b) - middle);
      CAPTURE(a, b);
      CHECK(std::abs(sum / static_cast<double>(count) / variance) < 6 / std::sqrt(count - 1.0));
    }
  }
}

TEST_CASE("a grid is all combinations, the last variable fastest", "[studies][sweep]") {
  const Sweep sweep(
      "  variables:\n    preload: [100 N, 160 N]\n"
      "    amplitude: {min: 1 um, max: 2 um, points: 3}\n    wavelengths: {min: 8, max: 10, "
      "points: 3}\n"
      "  sampling: grid\n  metrics: [stall_torque, contact_half_length]\n");
  REQUIRE(sweep.rows.size() == 18);
  std::size_t next = 0;
  for (const double preload : {100.0, 160.0}) {
    for (const double amplitude : {1e-6, 1.5e-6, 2e-6}) {
      for (const double waves : {8.0, 9.0, 10.0}) {
        const StoredRow& row = sweep.rows[next++];
        CAPTURE(next);
        CHECK(row.values[0] == preload);
        CHECK(row.values[1] == Approx(amplitude).epsilon(1e-15));  // one rounding of the step
        CHECK(row.values[2] == waves);
        // The same motor built by hand: nothing is left to rounding.
        MotorDesign design = sweep.file.motor.design;
        design.preload = preload;
        design.stator.amplitude = row.values[1];
        design.stator.wavelengths = waves;
        CHECK(row.values[3] == metric(design, Metric::stall_torque));
        CHECK(row.values[4] == metric(design, Metric::contact_half_length));
      }
    }
  }
}

TEST_CASE("the lists of a list sweep go together", "[studies][sweep]") {
  const Sweep sweep(
      "  variables: {preload: [100 N, 160 N, 130 N], mu: [0.3, 0.2, 0.1]}\n"
      "  sampling: list\n  metrics: [holding_torque]\n");
  REQUIRE(sweep.rows.size() == 3);
  const double radius = sweep.file.motor.design.stator.contact_radius;
  const double preload[] = {100, 160, 130};
  const double friction[] = {0.3, 0.2, 0.1};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(sweep.rows[i].values[0] == preload[i]);
    CHECK(sweep.rows[i].values[1] == friction[i]);
    // mu_0 F_N r, three factors and so a rounding each; mu_0 keeps its ratio 1 to mu.
    CHECK(sweep.rows[i].values[2] == Approx(friction[i] * preload[i] * radius).epsilon(1e-15));
  }
}

TEST_CASE("a hypercube sweep meets each part of every range once", "[studies][sweep]") {
  const Sweep sweep(
      "  variables:\n    preload: {min: 60 N, max: 300 N}\n"
      "    thickness: {min: 0.1 mm, max: 1 mm, scale: log}\n    wavelengths: {min: 7, max: 11}\n"
      "    amplitude: [1 um, 2 um]\n"
      "  sampling: lhs\n  samples: 200\n  seed: 5\n  metrics: [max_pressure]\n");
  REQUIRE(sweep.rows.size() == 200);
  std::vector<double> preloads;
  std::vector<double> logs;
  std::map<double, int> waves;
  std::map<double, int> amplitudes;
  for (const StoredRow& row : sweep.rows) {
    preloads.push_back((row.values[0] - 60) / 240 * 200);
    logs.push_back(std::log10(row.values[1] / 1e-4) * 200);
    ++waves[row.values[2]];
    ++amplitudes[row.values[3]];
  }
  std::sort(preloads.begin(), preloads.end());
  std::sort(logs.begin(), logs.end());
  for (std::size_t i = 0; i < 200; ++i) {
    // Points keep 2^-21 of a part away from its borders, rounding moves them by 200 eps at most.
    CHECK(std::floor(preloads[i]) == static_cast<double>(i));
    CHECK(std::floor(logs[i]) == static_cast<double>(i));
  }
  // 200 strata fall into 5 equal shares, and into 2, without remainder.
  CHECK(waves == std::map<double, int>{{7, 40}, {8, 40}, {9, 40}, {10, 40}, {11, 40}});
  CHECK(amplitudes == std::map<double, int>{{1e-6, 100}, {2e-6, 100}});
}

TEST_CASE("a Sobol sweep takes the points of the sequence in their order", "[studies][sweep]") {
  const Sweep sweep(
      "  variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 1 um, max: 2 um}}\n"
      "  sampling: sobol\n  samples: 100\n  seed: 3\n  metrics: [stall_torque]\n");
  const auto points = optim::sobol_points(2, 100, 3);
  REQUIRE(sweep.rows.size() == 100);
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(sweep.rows[i].values[0] == 60 + points[i][0] * 240);
    CHECK(sweep.rows[i].values[1] == Approx(1e-6 + points[i][1] * 1e-6).epsilon(1e-15));
  }
}

TEST_CASE("a Sobol sequence fills the intervals of its base evenly", "[studies][sweep][identity]") {
  // A (t, s)-sequence in base 2 with t = 0 in each coordinate: 2^m points, one in each of the 2^m
  // intervals. The shift modulo 1 keeps the distances: sorted, neighbours are exactly 2^-m apart.
  const optim::SobolSequence sequence(6, 11);
  std::vector<std::vector<double>> columns(6);
  std::vector<double> point(6);
  for (std::uint64_t i = 0; i < 256; ++i) {
    sequence.point(i, point);
    for (std::size_t j = 0; j < 6; ++j) columns[j].push_back(point[j]);
  }
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    for (std::size_t i = 1; i < 256; ++i)
      CHECK(column[i] - column[i - 1] == Approx(1.0 / 256).margin(1e-15));  // rounding of the shift
  }
  CHECK_THROWS_AS(sequence.point(std::uint64_t{1} << 60U, point), InputError);
}

TEST_CASE("the answer of a sweep is that of its sorted rows", "[studies][sweep]") {
  const std::string samples = GENERATE("1", "2", "77", "400");
  const Sweep sweep(
      "  variables: {preload: {min: 60 N, max: 300 N}, mu: {min: 0.01, max: 0.4}}\n"
      "  sampling: lhs\n  samples: " +
      samples + "\n  metrics: [stall_torque, speed_at(0.5 N.m), contact_ratio]\n");
  CAPTURE(samples);
  std::uint64_t failed = 0;
  for (const StoredRow& row : sweep.rows) failed += row.status == "ok" ? 0 : 1;
  CHECK(sweep.answer().failed == failed);
  CHECK(sweep.answer().stored == sweep.rows.size());
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> values;
    for (const StoredRow& row : sweep.rows)
      if (!std::isnan(row.values[2 + i])) values.push_back(row.values[2 + i]);
    std::sort(values.begin(), values.end());
    const SweepResult::Metric& found = sweep.answer().metrics[i];
    CHECK(found.count == values.size());
    if (values.empty()) {
      CHECK(std::isnan(found.median));
      continue;
    }
    CHECK(found.min == values.front());
    CHECK(found.median == values[(values.size() - 1) / 2]);
    CHECK(found.max == values.back());
    CHECK(sweep.rows[found.highest.index].values[2 + i] == values.back());
    CHECK(found.lowest.variables[0] == sweep.rows[found.lowest.index].values[0]);
  }
}

TEST_CASE("a sweep does not depend on the number of threads", "[studies][sweep]") {
  const std::string entries =
      "  variables: {preload: {min: 60 N, max: 300 N}, h: {min: 0.1 mm, max: 1 mm, scale: log}}\n"
      "  sampling: sobol\n  samples: 300\n  metrics: [peak_power]\n";
  const Sweep one(entries, 1);
  const Sweep eight(entries, 8);
  REQUIRE(one.rows.size() == eight.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i)
    CHECK(one.rows[i].values == eight.rows[i].values);
}

TEST_CASE("what a sweep stored is verified from its directory alone", "[studies][sweep][verify]") {
  const Sweep sweep(
      "  variables: {mu_0: {min: 0.1, max: 0.3}, preload: {min: 60 N, max: 300 N}}\n"
      "  sampling: lhs\n  samples: 120\n  metrics: [stall_torque, speed_at(0.5 N.m)]\n");
  VerifyOptions options;
  options.samples = 50;
  const Verification found = verify_study(sweep.folder.path("out"), options);
  CAPTURE(found.complaints);
  CHECK(found.holds());
  CHECK(found.rows == 120);
  CHECK(found.rows_checked == 50);
  CHECK(found.designs == 4);
  CHECK(found.deviation == 0);
  CHECK(found.answer_checked);
  CHECK_THROWS_AS(verify_study(sweep.folder.path("none")), InputError);
}

TEST_CASE("a concave front is verified as well", "[studies][verify]") {
  const test::ScratchFolder folder;
  const std::string path = folder.path("front.yaml");
  std::ofstream(path)
      << "twum: 1\nmotor: " << test::motor_path("ring-60")
      << "\nstudy:\n  kind: pareto\n"
         "  variables: {A: {min: 0.8 um, max: 2.2 um}, F_N: {min: 60 N, max: 300 N}}\n"
         "  objectives: [{maximize: stall_torque}, {maximize: no_load_speed}]\n"
         "  constraints: [max_pressure <= 2.5 MPa]\n  points: 5\n";
  run_study(read_study_file(path), folder.path("out"), {});
  const Verification found = verify_study(folder.path("out"));
  CAPTURE(found.complaints);
  CHECK(found.holds());
  CHECK(found.certificates > 0);
}

TEST_CASE("a number of waves that no mode of the plate carries has a status",
          "[studies][sweep][plate]") {
  // Of a free, thin plate each mode of one nodal diameter is orthogonal to the tilt, so it changes its sign; the lowest of nine
  // does not.
  const test::ScratchFolder folder;
  std::ofstream(folder.path("disc.yaml")) << R"text(twum: 1
motor:
  stator:
    wavelengths: 9
    contact_radius: 26.5 mm
    contact_width: 2 mm
    frequency_ratio: 1.046
    voltage: 20 V
    quality_factor: 153
    geometry:
      substrate: {inner_radius: 3 mm, outer_radius: 30 mm, thickness: 0.3 mm, material: phosphor-bronze-c51000}
      ceramic: {inner_radius: 22 mm, outer_radius: 30 mm, thickness: 0.1 mm, material: apc-840}
      electrodes: {waves_per_phase: 0.5}
      support: {inner_edge: free}
  contact_layer: {thickness: 0.5 mm, youngs_modulus: 0.9 GPa, poisson_ratio: 0.38, density: 1500 kg/m^3, loss_factor: 0.05}
  friction: {kinetic: 0.23}
  preload: 1 N
)text";
  std::ofstream(folder.path("sweep.yaml")) << R"text(twum: 1
motor: disc.yaml
study:
  kind: sweep
  variables: {wavelengths: {min: 1, max: 9, points: 2}}
  sampling: grid
  metrics: [holding_torque]
)text";
  run_study(read_study_file(folder.path("sweep.yaml")), folder.path("out"), {});
  std::vector<std::string> status;
  ResultStore(folder.path("out/results.db")).read([&](const StoredRow& row) {
    status.push_back(row.status);
  });
  CHECK(status == std::vector<std::string>{"no-ring-mode", "ok"});
}

TEST_CASE("a map of a large grid draws some lines of its cells, each with its own value",
          "[studies][sweep][closed-form]") {
  const Sweep sweep(
      "  variables: {preload: {min: 60 N, max: 300 N, points: 600}, mu: {min: 0.1, max: 0.4, "
      "points: 3}}\n"
      "  sampling: grid\n  metrics: [holding_torque]\n");
  const ResultStore rows(sweep.folder.path("out/results.db"));
  const auto list = telling::sections(sweep.result, {&sweep.file, &rows, nullptr});
  const auto map = std::find_if(list.begin(), list.end(),
                                [](const auto& section) { return section.hook == "map"; });
  REQUIRE(map != list.end());
  CHECK(map->sentences.size() == 1);  // says so
  const telling::Series& cells = map->charts.front().series.front();
  const std::vector<double>&x = cells.x.values, &y = cells.y.values, &z = cells.z.values;
  CHECK(std::set<double>(x.begin(), x.end()).size() == 200);
  REQUIRE(x.size() == 600);
  REQUIRE((y.size() == x.size() && z.size() == x.size()));
  const double radius = sweep.file.motor.design.stator.contact_radius;
  for (std::size_t i = 0; i < x.size(); ++i)
    CHECK(z[i] == Approx(y[i] * x[i] * radius).epsilon(1e-12));  // mu F_N r
}
