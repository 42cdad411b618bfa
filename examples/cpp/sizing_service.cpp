// SPDX-License-Identifier: Apache-2.0
// Sizes motors on request. Each line of standard input is a duty, such as "0.5 N.m, 100 rpm", and is answered with a motor
// for it. The line "cancel" stops the request before it. No request takes longer than ten seconds.
#include <twum/twum.hpp>

#include <iostream>
#include <thread>

namespace {

using namespace twum::studies;

// What may vary, and what must hold for every motor.
DesignProblem question() {
  DesignProblem problem{twum::MotorDesign{}};
  problem.vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um");
  problem.limit("max_pressure <= 10 MPa").limit("wear_intensity_at(100 rpm) <= 10 kW/m^2");
  return problem;
}

DutyPoint parse_duty(const std::string& line) {
  const auto comma = line.find(',');
  if (comma == std::string::npos) throw twum::InputError("expected a torque and a speed");
  return duty_point(line.substr(0, comma), line.substr(comma + 1));
}

std::string answer(const std::string& line, std::stop_token stop) try {
  twum::optim::SolveOptions options;
  options.stop = std::move(stop);
  options.budget.seconds = 10;
  const DesignAnswer best = size(question(), parse_duty(line), options);
  const std::string outcome = to_string(best.search.outcome);
  if (best.search.outcome != twum::optim::Outcome::optimal) return outcome;
  return outcome + ": preload " + std::to_string(best.motor.preload) + " N, amplitude " +
         std::to_string(1e6 * best.motor.stator.amplitude) + " um";
} catch (const twum::InputError& error) {
  return std::string("refused: ") + error.what();
}

}  // namespace

int main() {
  std::jthread request;
  for (std::string line; std::getline(std::cin, line);) {
    if (line == "cancel") {
      request.request_stop();
      continue;
    }
    if (request.joinable()) request.join();
    request = std::jthread([line](std::stop_token stop) {
      std::cout << line + " -> " + answer(line, std::move(stop)) + "\n" << std::flush;
    });
  }
  if (request.joinable()) request.join();
}
