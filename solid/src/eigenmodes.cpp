// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/eigenmodes.hpp>

#include <twum/base/error.hpp>

#include <cmath>
#include <istream>
#include <string>

namespace twum::inline v0_1::solid {
namespace {

// CalculiX prints seven digits, so that the two modes of a wave agree to 1e-6; different modes that are as near are not told apart.
constexpr double kSameWave = 1e-6;

// Rigid-body modes have eigenvalues of rounding size, 1e-12 of the highest.
constexpr double kRigid = 1e-4;

using Vector = std::array<double, 3>;

// What CalculiX printed of one mode, in Cartesian directions.
struct Printed {
  std::vector<Vector> real, imaginary;
  std::size_t rows{0};
};

bool has(const std::string& line, const char* words) {
  return line.find(words) != std::string::npos;
}

// Reads `count` numbers from a line; false if there are fewer.
template <std::size_t count>
bool numbers_of(const std::string& line, std::array<double, count>& numbers) {
  const char* at = line.c_str();
  for (double& number : numbers) {
    char* end = nullptr;
    number = std::strtod(at, &end);
    if (end == at) return false;
    at = end;
  }
  return true;
}

// The table of frequencies: number of nodal diameters, of the mode, eigenvalue, and the frequency in rad/s and in Hz.
std::vector<double> printed_frequencies(std::istream& dat) {
  std::vector<double> found;
  std::array<double, 5> row{};
  for (std::string line; std::getline(dat, line) && !has(line, "P A R T I C I P A T I O N");)
    if (numbers_of(line, row)) found.push_back(row[4]);
  for (double& frequency : found)
    if (frequency < kRigid * found.back()) frequency = 0;
  return found;
}

std::vector<Printed> printed_motions(std::istream& dat, std::size_t nodes) {
  std::vector<Printed> modes;
  bool imaginary = false;
  std::array<double, 4> row{};
  for (std::string line; std::getline(dat, line);) {
    if (has(line, "E I G E N V A L U E    N U M B E R")) {
      modes.push_back({std::vector<Vector>(nodes), std::vector<Vector>(nodes)});
      imaginary = false;
    } else if (has(line, "I M A G I N A R Y   P A R T")) {
      imaginary = true;
    } else if (!modes.empty() && numbers_of(line, row) && row[0] >= 1 &&
               row[0] <= static_cast<double>(nodes)) {
      auto& part = imaginary ? modes.back().imaginary : modes.back().real;
      part[static_cast<std::size_t>(row[0]) - 1] = {row[1], row[2], row[3]};
      ++modes.back().rows;
    }
  }
  return modes;
}

Eigenmode eigenmode(double frequency, const Printed& printed, const Sector& sector) {
  Eigenmode mode{frequency, {}};
  for (std::size_t i = 0; i < sector.nodes.size(); ++i) {
    const Vector &a = printed.real[i], &b = printed.imaginary[i];
    const double c = std::cos(sector.nodes[i].angle), s = std::sin(sector.nodes[i].angle);
    const std::complex<double> x{a[0], b[0]}, y{a[1], b[1]};
    mode.motion.push_back({c * x + s * y, c * y - s * x, {a[2], b[2]}});
  }
  return mode;
}

}  // namespace

std::vector<Eigenmode> read_eigenmodes(std::istream& dat, const Sector& sector) {
  const std::vector<double> frequencies = printed_frequencies(dat);
  const std::vector<Printed> printed = printed_motions(dat, sector.nodes.size());
  if (frequencies.empty() || printed.size() < frequencies.size() ||
      printed.front().rows < sector.nodes.size())
    throw InputError("CalculiX printed no modes of this sector");
  std::vector<Eigenmode> modes;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const double f = frequencies[i];
    const bool again = !modes.empty() && f > 0 && f - modes.back().frequency < kSameWave * f;
    if (!again) modes.push_back(eigenmode(f, printed[i], sector));
  }
  return modes;
}

}  // namespace twum::inline v0_1::solid
