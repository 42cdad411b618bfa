# SPDX-License-Identifier: Apache-2.0
# TWUM_BUILD_PYTHON is on by itself where pybind11, NumPy and the headers of Python are there.
#
# The interpreter is the system's, whatever comes first on PATH: NumPy is its package. It has to be
# found before pybind11, which takes the first python3 otherwise. A sanitizer would need an
# interpreter of its own kind.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that the module is built for")
endif()
set(can_build_python OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT TWUM_SANITIZE)
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
  if(Python_FOUND)
    find_package(pybind11 2.10 CONFIG QUIET)
    set(can_build_python ${pybind11_FOUND})
  endif()
endif()
option(TWUM_BUILD_PYTHON "Build the Python module" ${can_build_python})
