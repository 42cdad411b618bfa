// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/designer.hpp>

#include "report/assets.hpp"
#include "report/encode.hpp"
#include "report/page_parts.hpp"
#include "report/tables.hpp"
#include "telling/renderers.hpp"

#include <twum/base/version.hpp>

namespace twum::inline v0_1::studies {
bool has_designer() noexcept { return !assets::core_module().empty(); }

std::string designer_html(const MotorFile& motor) {
  const Json data{{"version", version()},
                  {"parameters", parameters_json("")},
                  {"metrics", metrics_json("")},
                  {"reasons", reasons_json()},
                  {"contact", telling::charts_json(telling::contact_charts())},
                  {"units", units_json()},
                  {"materials", materials_json()},
                  {"left_out", left_out_metrics_json(motor.design)},
                  {"motor", stated_motor_json(motor.name, motor.design)},
                  {"core", base85(assets::core_module())}};
  std::string page = dressed(assets::designer_page(), {assets::style(), assets::style_hash()},
                             {assets::designer_script(), assets::designer_script_hash()});
  page = filled(page, "/*UNITS*/", embedded(display_units_json(data)));
  return filled(page, "/*DATA*/", embedded(data));
}

}  // namespace twum::inline v0_1::studies
