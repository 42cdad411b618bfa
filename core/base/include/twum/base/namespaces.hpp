// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Each library of `studies` has a namespace of its own. A library uses the words of those below it without a prefix,
/// and so does a program that says `using namespace twum::studies`.
namespace twum::io {}
namespace twum::motors {
using namespace io;
}
namespace twum::studies {
using namespace io;
using namespace motors;
}  // namespace twum::studies
