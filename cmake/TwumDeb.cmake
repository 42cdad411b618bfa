# SPDX-License-Identifier: Apache-2.0
# Debian packages: `cpack -G DEB` in a build folder configured by the preset "package".
#
#   twum          the command and the Python module; depends on what they are linked with
#   libtwum-dev   libraries and headers; depends on the -dev packages that a static library needs
if(BUILD_SHARED_LIBS)
  message(STATUS "No Debian packages of shared libraries; BUILD_SHARED_LIBS=OFF makes them of static ones")
  return()
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME twum)
set(CPACK_PACKAGE_VENDOR twum)
set(CPACK_PACKAGE_CONTACT "twum developers <twum@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime dev)
if(TWUM_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENT_RUNTIME_GROUP program)
set(CPACK_COMPONENT_PYTHON_GROUP program)
set(CPACK_COMPONENT_DEV_GROUP dev)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME twum)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Torque-speed curves, metrics with derivatives, design studies and sizing of
motors in which a bending wave drives a rotor by friction: the command twum
and the Python module of the same name.")
if(TWUM_BUILD_PYTHON)
  # The compiled part is of one version of Python.
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
endif()
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox, python3-matplotlib")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS libtwum-dev)

set(dev_packages libnlopt-dev libyaml-cpp-dev libudunits2-dev libsqlite3-dev pkg-config)
if(TWUM_WITH_IPOPT)
  list(APPEND dev_packages coinor-libipopt-dev)
endif()
if(TWUM_WITH_GSL)
  list(APPEND dev_packages libgsl-dev)
endif()
if(SUNDIALS_FOUND)
  list(APPEND dev_packages libsundials-dev)
endif()
list(JOIN dev_packages ", " dev_packages)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libtwum-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${dev_packages}")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "twum (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEV_DESCRIPTION "C++ libraries and headers, for find_package(twum) and pkg-config twum.")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/twum RENAME copyright COMPONENT runtime)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtwum-dev RENAME copyright COMPONENT dev)
include(CPack)
