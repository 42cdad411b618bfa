// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Each library of `studies` has a namespace of its own. A library uses the words of those below it without a prefix,
/// and so does a program that says `using namespace twum::studies`.
namespace twum::inline v0_1::io {}
namespace twum::inline v0_1::motors {
using namespace io;
}
namespace twum::inline v0_1::studies {
using namespace io;
using namespace motors;
}  // namespace twum::inline v0_1::studies
