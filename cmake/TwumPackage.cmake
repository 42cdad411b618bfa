# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, and how other programs find it.
#
#   component dev      libraries, headers, find_package(twum), pkg-config
#   component runtime  the command, its man pages and shell completions; shared libraries, if they are shared
#   component python   the Python module
#
# Each library is a component of find_package(twum) with an export set of its own, so that a program
# that only wants twum::core needs none of the packages behind twum::optim.
include(CMakePackageConfigHelpers)

set(TWUM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/twum)

# Lets what is installed in DIRECTORY of the prefix find the libraries that are installed along with it,
# from where it stands: the prefix may be moved.
function(twum_finds_libraries target directory)
  if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH way /${directory} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${way}")
  endif()
endfunction()

# Installs twum_NAME in the export set of a component, its own if none is named.
function(twum_install_library name)
  set(component ${ARGN})
  if(NOT component)
    set(component ${name})
  endif()
  install(TARGETS twum_${name} EXPORT twum-${component}
    ARCHIVE COMPONENT dev
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT dev
    RUNTIME COMPONENT dev
    FILE_SET HEADERS COMPONENT dev)
  twum_finds_libraries(twum_${name} ${CMAKE_INSTALL_LIBDIR})
  if(name STREQUAL component)
    install(EXPORT twum-${name} NAMESPACE twum:: DESTINATION ${TWUM_CMAKE_DIR} COMPONENT dev)
  endif()
endfunction()

# Installs the pkg-config file twum-NAME.pc (twum.pc for the library called twum).
# A static library brings no dependencies of its own, so they stand in the public fields then:
# `pkg-config --libs` is enough either way.
function(twum_pkg_config name)
  cmake_parse_arguments(ARG "" "DESCRIPTION;LIBRARY" "REQUIRES;PRIVATE_REQUIRES;PRIVATE_LIBS" ${ARGN})
  if(BUILD_SHARED_LIBS)
    set(private .private)
  endif()
  list(JOIN ARG_REQUIRES " " requires)
  list(JOIN ARG_PRIVATE_REQUIRES " " private_requires)
  list(JOIN ARG_PRIVATE_LIBS " " private_libs)
  string(JOIN "\n" fields
    "Name: ${name}"
    "Description: ${ARG_DESCRIPTION}"
    "URL: ${PROJECT_HOMEPAGE_URL}"
    "Version: ${PROJECT_VERSION}"
    "Cflags: -I\${includedir}")
  if(BUILD_SHARED_LIBS)
    string(APPEND fields "\nRequires: ${requires}\nRequires.private: ${private_requires}")
    string(APPEND fields "\nLibs: -L\${libdir} ${ARG_LIBRARY}\nLibs.private: ${private_libs}")
  else()
    string(APPEND fields "\nRequires: ${requires} ${private_requires}")
    string(APPEND fields "\nLibs: -L\${libdir} ${ARG_LIBRARY} ${private_libs}")
  endif()
  set(TWUM_PC_FIELDS "${fields}")
  # Relative to the file itself: the prefix may be moved.
  file(RELATIVE_PATH TWUM_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/twum.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

function(twum_install_package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/twumConfig.cmake.in
    ${PROJECT_BINARY_DIR}/package/twumConfig.cmake INSTALL_DESTINATION ${TWUM_CMAKE_DIR})
  # Before version 1 a minor version may break what programs rely on.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/twumConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES
    ${PROJECT_BINARY_DIR}/package/twumConfig.cmake
    ${PROJECT_BINARY_DIR}/package/twumConfigVersion.cmake
    DESTINATION ${TWUM_CMAKE_DIR} COMPONENT dev)

  set(solvers nlopt)
  if(TWUM_WITH_IPOPT)
    list(APPEND solvers ipopt)
  endif()
  if(TWUM_WITH_GSL)
    list(APPEND solvers gsl)
  endif()
  set(mpi "")
  if(TWUM_WITH_MPI)
    set(mpi mpi-c)
  endif()
  twum_pkg_config(twum-core DESCRIPTION "Travelling wave ultrasonic motors: the physics of one motor (C++20)"
    LIBRARY "-ltwum_core -ltwum_stator -ltwum_base" PRIVATE_LIBS -pthread)
  twum_pkg_config(twum-optim DESCRIPTION "Optimization with certificates, fronts, least squares (C++20)"
    LIBRARY "-ltwum_optim -ltwum_base" PRIVATE_REQUIRES ${solvers} PRIVATE_LIBS -pthread)
  set(integrator "")
  if(SUNDIALS_FOUND)
    set(integrator " -lsundials_cvodes")
  endif()
  twum_pkg_config(twum DESCRIPTION "Design of travelling wave ultrasonic motors: motors, files, studies (C++20)"
    LIBRARY "-ltwum_studies -ltwum_motors -ltwum_io -ltwum_motion" REQUIRES "twum-core = ${PROJECT_VERSION}" "twum-optim = ${PROJECT_VERSION}"
    PRIVATE_REQUIRES ${mpi} yaml-cpp udunits sqlite3 PRIVATE_LIBS "-pthread${integrator}")
endfunction()
