// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "message.hpp"
#include "output.hpp"
#include "plot/study/told_pictures.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/stored_result.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kPlotExamples = R"text(Examples:
  twum plot results/study             every picture of the study, into results/study/plots
  twum plot results/study -o figures  into another directory

Each picture is a file NAME.svg and a file NAME.png with twice as many pixels. Their names are printed.)text";

struct PlotOptions {
  std::string directory;
  std::string into;
};

std::string made_directory(const PlotOptions& options) {
  namespace fs = std::filesystem;
  const fs::path path =
      options.into.empty() ? fs::path(options.directory) / "plots" : fs::path(options.into);
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path, error))
    throw OutputError(path.string() + ": this directory cannot be made: " +
                      (error ? error.message() : "a file has this name") +
                      "; choose another one with -o");
  return path.string();
}

int run_plot(const PlotOptions& options) {
  std::vector<Picture> pictures;
  const StopOnInterrupt stop;
  studies::read_result(
      options.directory,
      [&](const studies::StudyFile& file, const studies::StudyResult& result,
          const studies::ResultStore& store) {
        pictures = told_pictures({file, result, store});
      },
      stop.token());
  if (pictures.empty()) {
    say("twum: this study has no answer to draw; " + options.directory + "/report.html says why");
    return kNoAnswer;
  }
  const std::string directory = made_directory(options);
  Output output("");
  for (const Picture& picture : pictures) {
    for (const char* ending : {".svg", ".png"}) {
      const std::string path =
          (std::filesystem::path(directory) / (picture.name + ending)).string();
      PlotFile(path, {}).draw(picture.size, picture.script);
      output.say(path + "\n");
    }
  }
  output.finish();
  return kDone;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command =
      app.add_subcommand("plot", "Draws the results of a study into SVG and PNG files");
  command->add_option("DIR", options->directory, "Directory that 'twum run' wrote")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("-o,--output", options->into, "Directory of the pictures (default: DIR/plots)")
      ->type_name("DIR");
  command->footer(kPlotExamples);
  command->callback([options, &action] { action = [options] { return run_plot(*options); }; });
}

}  // namespace twum::inline v0_1::cli
