# SPDX-License-Identifier: Apache-2.0
# TWUM_WITH_MPI is on by itself where the MPI of the system is there, in what Debian calls it for pkg-config. Sanitizers would
# report what it does to its own memory.
find_package(PkgConfig REQUIRED)
set(can_build_mpi OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT TWUM_SANITIZE)
  pkg_check_modules(MPI QUIET mpi-c)
  set(can_build_mpi ${MPI_FOUND})
endif()
option(TWUM_WITH_MPI "Share the rows of a study among the processes that mpirun starts" ${can_build_mpi})
