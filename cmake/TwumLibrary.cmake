# SPDX-License-Identifier: Apache-2.0
# twum_library(NAME SOURCES ... HEADERS ... [COMPONENT ...] [PUBLIC ...] [PRIVATE ...])
#
# Makes the target twum_NAME with the alias twum::NAME, its public headers (each must compile alone:
# target all_verify_interface_header_sets) and the project's compile flags, kept private. It is
# installed as twum::NAME, by itself or with others as COMPONENT of the package (TwumPackage.cmake).
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
    DEFINE_SYMBOL ""  # every symbol is visible: objects are the same for static and shared libraries
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    VERIFY_INTERFACE_HEADER_SETS ON
    OPTIMIZE_DEPENDENCIES ON  # no library waits for those below it
    UNITY_BUILD ${TWUM_UNITY}
    UNITY_BUILD_BATCH_SIZE 40)
  if(TWUM_INSTALL)
    twum_install_library(${name} ${ARG_COMPONENT})
  endif()
endfunction()

# twum_batches(TARGET BATCH PATTERN [PART]): with TWUM_UNITY the sources of a target whose paths match are one batch, the
# others another. What uses the same heavy templates belongs in one batch, because each batch instantiates them anew. Two
# sources of a batch may not give different things the same name. A PART of twum_optimized() is for these sources alone. The batch
# that is made last comes first in the library: of a function that several batches contain the linker takes that one.
function(twum_batches target batch pattern)
  get_target_property(others ${target} SOURCES)
  set(chosen ${others})
  list(FILTER chosen INCLUDE REGEX "${pattern}")
  list(REMOVE_ITEM others ${chosen})
  set_target_properties(${target} PROPERTIES SOURCES "${chosen};${others}")
  set_source_files_properties(${chosen} PROPERTIES UNITY_GROUP ${batch})
  foreach(other IN LISTS others)
    get_source_file_property(group ${other} UNITY_GROUP)
    if(NOT group)
      set_source_files_properties(${other} PROPERTIES UNITY_GROUP others)
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  if(ARGC GREATER 3)
    if(TWUM_UNITY)  # options of its sources would take them out of the batch
      set(chosen ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${batch}_cxx.cxx)
    endif()
    set_source_files_properties(${chosen} PROPERTIES COMPILE_OPTIONS "${level_of_${ARGV3}}")
  endif()
endfunction()

# twum_takes_eigen(TARGET OWNER [DEFINITION...]): Eigen and Spectra under names of OWNER's. They are templates, of which the linker
# keeps one for a whole program. A program with its own Eigen, or another library of ours, would share them. But Eigen aligns
# memory as its options say, and -mavx2 changes that: what one side allocates the other cannot free.
function(twum_takes_eigen target owner)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:Eigen3::Eigen>)
  target_compile_definitions(${target} PRIVATE Eigen=Eigen_of_${owner} Spectra=Spectra_of_${owner} ${ARGN})
endfunction()
