// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/io/publish.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kSchemaExamples = R"text(Examples:
  twum schema motor -o motor.schema.json
  twum schema study --format markdown

In an editor with YAML support, begin a motor file with
  # yaml-language-server: $schema=motor.schema.json)text";

struct SchemaOptions {
  std::string kind;
  std::string format{"json"};
  std::string path;
};

std::string schema_text(const SchemaOptions& options) {
  if (options.kind == "motor") {
    return studies::json_schema(studies::motor_file_shape().schema, "twum motor file",
                                "urn:twum:motor:1");
  }
  if (options.format == "markdown") return studies::study_reference();
  return studies::json_schema(studies::study_file_schema(), "twum study file", "urn:twum:study:1");
}

int run_schema(const SchemaOptions& options) {
  if (options.kind == "motor" && options.format == "markdown")
    throw InputError("the page of the motor file is 'twum parameters --format markdown'");
  require_ending(options.path, {options.format == "markdown" ? "markdown" : "json"});
  Output output(options.path);
  output.write(schema_text(options));
  output.finish();
  return kDone;
}

}  // namespace

void add_schema(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SchemaOptions>();
  CLI::App* command = app.add_subcommand("schema", "JSON Schema of the files, for editors");
  command->add_option("KIND", options->kind, "The kind of file")
      ->required()
      ->check(one_of({"motor", "study"}))
      ->type_name("motor|study");
  command
      ->add_option("--format", options->format,
                   "JSON Schema, or the reference page of the study file (default: json)")
      ->check(one_of({"json", "markdown"}))
      ->type_name("json|markdown");
  command->add_option("-o,--output", options->path, "Write the result to this file")
      ->type_name("FILE");
  command->footer(kSchemaExamples);
  command->callback([options, &action] { action = [options] { return run_schema(*options); }; });
}

}  // namespace twum::inline v0_1::cli
