// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/text_table.hpp>

namespace twum::inline v0_1::cli {

using studies::aligned;
using studies::TextTable;

}  // namespace twum::inline v0_1::cli
