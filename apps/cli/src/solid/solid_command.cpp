// SPDX-License-Identifier: Apache-2.0
#include "solid/solid_command.hpp"

#include "exit_status.hpp"
#include "formats.hpp"
#include "message.hpp"
#include "output.hpp"
#include "plot/solid_plot.hpp"
#include "scratch_folder.hpp"
#include "solid/solid_text.hpp"
#include "solid/written_share.hpp"
#include "terminal.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/motors/solid_data.hpp>

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <system_error>

namespace twum::inline v0_1::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kElements = 5;  // plate-60 then takes 40 s on two cores
constexpr std::size_t kFewestElements = 2;

void check_request(const SolidRequest& request, const MotorDesign& design) {
  if (!design.stator.geometry)
    throw InputError(request.motor.path +
                     ": --solid needs a stator given by its geometry, without the entry 'solid'");
  const std::string ending = format_of(request.folder);
  if (ending == "json" || ending == "txt" || fs::is_regular_file(request.folder))
    throw InputError("-o: " + request.folder +
                     " must be a folder, for the files of CalculiX; the result itself is printed");
  if (request.write && !design.stator.geometry->teeth)
    throw InputError(request.motor.path +
                     ": --write fits the stiffness_share of teeth; this stator has none");
}

std::string made_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path, error))
    throw OutputError(path + ": this folder cannot be made: " + error.message() +
                      "; choose another one with -o");
  return path;
}

std::optional<StatorNumbers> plate_if_any(const MotorDesign& design) {
  try {
    return numbers_of_plate(design);
  } catch (const EvaluationError& error) {
    say(std::string("note: the plate has no such wave: ") + error.what());
    return {};
  }
}

MotorDesign with_share(MotorDesign design, double share) {
  design.stator.geometry->teeth->stiffness_share = share;
  return design;
}

void compare_with_plate(SolidComparison& comparison) {
  const MotorDesign& design = comparison.file.design;
  const Stator& s = design.stator;
  comparison.plate = plate_if_any(design);
  if (!comparison.plate || !s.geometry->teeth) return;
  comparison.share =
      solid::fit_stiffness_share(*s.geometry, static_cast<int>(s.wavelengths), s.contact_radius,
                                 comparison.solid.numbers.resonance_frequency);
  if (comparison.share->share)
    comparison.fitted_plate = numbers_of_plate(with_share(design, *comparison.share->share));
}

// R where a rotor can touch: on the teeth, or on the ring. A spline through it has no kinks at edges.
std::vector<std::pair<double, double>> touched_shape(
    const stator::StatorGeometry& g, const std::vector<std::pair<double, double>>& shape) {
  const double inner = g.teeth ? g.teeth->inner_radius : g.web ? g.web->outer_radius : 0;
  const double outer = g.teeth ? g.teeth->outer_radius : g.substrate.outer_radius;
  const double slack = 1e-9 * outer;
  std::vector<std::pair<double, double>> rows;
  for (const auto& row : shape)
    if (row.first > inner - slack && row.first < outer + slack) rows.push_back(row);
  return rows;
}

// NAME-solid.yaml in the folder, or in the current one.
std::string copy_path(const SolidRequest& request) {
  const std::string stem =
      request.motor.path == "-" ? "motor" : fs::path(request.motor.path).stem().string();
  return (fs::path(request.folder) / (stem + "-solid.yaml")).string();
}

// Settings of the command line are not in the file's text.
void write_motor(const SolidRequest& request, const SolidComparison& comparison,
                 const std::optional<studies::Source>& source) {
  if (!comparison.share || !comparison.share->share) return;
  const double share = *comparison.share->share;
  studies::MotorFile copy = comparison.file;
  copy.design = with_share(copy.design, share);
  const std::string path = copy_path(request);
  Output output(path, {request.motor.path});
  output.write(source ? with_stiffness_share(*source, share) : studies::motor_text(copy));
  output.finish();
  say(path + ": the motor with this teeth_stiffness_share");
}

// solid.yaml in the folder: what `stator.solid` of a motor file reads.
void write_data(const std::string& folder, const SolidComparison& comparison) {
  const MotorDesign& design = comparison.file.design;
  const StatorNumbers& x = comparison.solid.numbers;
  const Stator& s = design.stator;
  studies::SolidData data;
  data.numbers = {
      {Parameter::resonance_frequency, x.resonance_frequency},
      {Parameter::modal_mass, x.modal_mass},
      {Parameter::force_factor, x.force_factor},
      {Parameter::blocked_capacitance, x.blocked_capacitance},
      {Parameter::neutral_plane_distance, x.tangential_ratio * s.contact_radius / s.wavelengths}};
  data.shape = touched_shape(*s.geometry, comparison.solid.shape);
  data.drawing = studies::drawing_of(design);
  data.inner_edge = s.geometry->support;
  Output output(folder + "/solid.yaml");
  output.write(studies::solid_text(data, comparison.file.name));
  output.finish();
}

}  // namespace

int run_solid_stator(const SolidRequest& request) {
  SolidComparison comparison;
  comparison.file = load_motor(request.motor);
  comparison.listed_modes = request.modes;
  check_request(request, comparison.file.design);
  // Read before the minute that follows, in which the file may change.
  std::optional<studies::Source> source;
  if (request.write && request.motor.settings.empty() && request.motor.path != "-")
    source = studies::read_source(request.motor.path);
  const std::size_t elements =
      request.mesh.empty()
          ? kElements
          : parse_count("--mesh", request.mesh, kFewestElements, solid::kMostElements);
  const std::optional<PlotFile> plot = plot_file(request.plot, {request.motor.path});
  std::unique_ptr<ScratchFolder> scratch;
  if (request.folder.empty()) scratch = std::make_unique<ScratchFolder>("CalculiX");
  const std::string folder = scratch ? scratch->path() : made_folder(request.folder);
  if (terminal_width(STDERR_FILENO)) say("CalculiX solves the stator; this takes about a minute");
  comparison.solid = solve_solid(comparison.file.design, static_cast<int>(elements), folder);
  compare_with_plate(comparison);
  Output output("");
  output.write(request.format == "json" ? solid_json(comparison) : solid_text(comparison));
  output.finish();
  if (plot) plot->draw(kSolidPlotSize, solid_plot(comparison.file, comparison.solid));
  if (!scratch) write_data(folder, comparison);
  if (!request.write) return kDone;
  write_motor(request, comparison, source);
  return comparison.share && comparison.share->share ? kDone : kNoAnswer;
}

}  // namespace twum::inline v0_1::cli
