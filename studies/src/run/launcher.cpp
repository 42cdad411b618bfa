// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/processes.hpp>

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace twum::inline v0_1::studies {
namespace {

// Environment variables by which launchers tell processes their count and number.
struct LauncherWords {
  const char* count;
  const char* number;
};
constexpr LauncherWords kLaunchers[] = {
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},  // mpirun of Open MPI
    {"PMI_SIZE", "PMI_RANK"},                          // mpiexec of MPICH, srun --mpi=pmi2
    {"SLURM_STEP_NUM_TASKS", "PMIX_RANK"},             // srun --mpi=pmix
};

unsigned number_in(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  unsigned value = otherwise;
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), value);
  return value;
}

unsigned told(const char* LauncherWords::*word, unsigned otherwise) {
  for (const LauncherWords& launcher : kLaunchers)
    if (std::getenv(launcher.count) != nullptr && std::getenv(launcher.number) != nullptr)
      return number_in(launcher.*word, otherwise);
  return otherwise;
}

}  // namespace

unsigned launched_processes() { return told(&LauncherWords::count, 1); }

unsigned launched_number() { return told(&LauncherWords::number, 0); }

}  // namespace twum::inline v0_1::studies
