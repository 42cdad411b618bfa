// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/report/designer.hpp>

#include "report/assets.hpp"
#include "report/encode.hpp"
#include "report/page_parts.hpp"
#include "report/tables.hpp"

#include <twum/base/version.hpp>

namespace twum::studies {
namespace {

// What the browser compares a script or a style with before it uses it.
std::string hash_source(std::string_view hash) { return "'sha256-" + base64(hash) + "'"; }

}  // namespace

bool has_designer() noexcept { return !assets::core_module().empty(); }

std::string designer_html(const MotorFile& motor) {
  const Json data{{"version", version()},
                  {"parameters", parameters_json()},
                  {"metrics", metrics_json()},
                  {"reasons", reasons_json()},
                  {"units", units_json()},
                  {"materials", materials_json()},
                  {"motor", stated_motor_json(motor.name, motor.design)},
                  {"core", base64(assets::core_module())}};
  std::string page =
      filled(assets::designer_page(), "@SCRIPT_HASH@", hash_source(assets::designer_script_hash()));
  page = filled(page, "@STYLE_HASH@", hash_source(assets::designer_style_hash()));
  page = filled(page, "/*STYLE*/", assets::designer_style());
  page = filled(page, "/*SCRIPT*/", assets::designer_script());
  return filled(page, "/*DATA*/", embedded(data));
}

}  // namespace twum::studies
