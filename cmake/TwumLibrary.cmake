# SPDX-License-Identifier: Apache-2.0
# twum_library(NAME SOURCES ... HEADERS ... [COMPONENT ...] [PUBLIC ...] [PRIVATE ...])
#
# Makes the target twum_NAME with the alias twum::NAME, its public headers (each must compile alone:
# target all_verify_interface_header_sets) and the project's compile flags, kept private. It is
# installed as twum::NAME, by itself or with others as COMPONENT of the package (TwumPackage.cmake).
include(CheckLinkerFlag)
check_linker_flag(CXX LINKER:--default-symver TWUM_LINKER_VERSIONS_SYMBOLS)
function(twum_library name)
  cmake_parse_arguments(ARG "" "COMPONENT" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  add_library(twum_${name})
  add_library(twum::${name} ALIAS twum_${name})
  target_sources(twum_${name}
    PRIVATE ${ARG_SOURCES}
    PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${ARG_HEADERS})
  target_compile_features(twum_${name} PUBLIC cxx_std_20)
  target_link_libraries(twum_${name}
    PUBLIC ${ARG_PUBLIC}
    PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:twum::compile>)
  set_target_properties(twum_${name} PROPERTIES
    CXX_EXTENSIONS OFF
    POSITION_INDEPENDENT_CODE ON
    DEFINE_SYMBOL ""
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    VERIFY_INTERFACE_HEADER_SETS ON
    OPTIMIZE_DEPENDENCIES ON  # no library waits for those below it
    UNITY_BUILD ${TWUM_UNITY}
    UNITY_BUILD_BATCH_SIZE 12)
  # A plugin of someone else's that takes static libraries passes none of their symbols on. Shared ones export all of theirs, with
  # their file's name and version as version of the symbol: plugins of one program may use different versions.
  if(NOT BUILD_SHARED_LIBS)
    set_target_properties(twum_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  elseif(TWUM_LINKER_VERSIONS_SYMBOLS)
    target_link_options(twum_${name} PRIVATE LINKER:--default-symver)
  endif()
  if(TWUM_INSTALL)
    twum_install_library(${name} ${ARG_COMPONENT})
  endif()
endfunction()

# twum_takes_eigen(TARGET OWNER [DEFINITION...]): Eigen and Spectra under names of OWNER's. They are templates, of which the linker
# keeps one for a whole program. A program with its own Eigen, or another library of ours, would share them. But Eigen aligns
# memory as its options say, and -mavx2 changes that: what one side allocates the other cannot free.
function(twum_takes_eigen target owner)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:Eigen3::Eigen>)
  target_compile_definitions(${target} PRIVATE Eigen=Eigen_of_${owner} Spectra=Spectra_of_${owner} ${ARGN})
endfunction()
