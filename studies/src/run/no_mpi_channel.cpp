// SPDX-License-Identifier: Apache-2.0
#include "run/channel.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/processes.hpp>

namespace twum::inline v0_1::studies {

struct Channel::State {};

Channel::Channel() {
  throw InputError("started " + std::to_string(launched_processes()) +
                   " times at once, but this build has no MPI, so that each process would run the "
                   "whole study; start it "
                   "once, with --jobs for more threads, or build with -DTWUM_WITH_MPI=ON");
}

Channel::~Channel() = default;
unsigned Channel::number() const noexcept { return 0; }
unsigned Channel::count() const noexcept { return 1; }
unsigned Channel::on_node() const noexcept { return 1; }
void Channel::send(unsigned /*to*/, int /*lane*/, const std::string& /*message*/) {}
std::string Channel::receive(unsigned /*from*/, int /*lane*/) { return {}; }

}  // namespace twum::inline v0_1::studies
