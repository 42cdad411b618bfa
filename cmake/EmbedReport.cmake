# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=FILE.cpp -DPAGE=... -DSTYLES=a;b -DSCRIPTS=a;b -P EmbedReport.cmake
#
# Writes the page's template, its styles and its scripts, each kind in one piece, as functions of C++.
function(embed name)
  set(bytes "")
  foreach(file ${ARGN})
    file(READ ${file} part HEX)
    string(APPEND bytes "${part}0a")
  endforeach()
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n"
    bytes "${bytes}")
  file(APPEND ${OUT} "namespace {\nconst unsigned char k_${name}[] = {\n${bytes}};\n}\n"
    "std::string_view ${name}() {\n"
    "  return {reinterpret_cast<const char*>(k_${name}), sizeof k_${name}};\n}\n")
endfunction()

file(WRITE ${OUT} "#include \"report/assets.hpp\"\nnamespace twum::studies::assets {\n")
embed(page ${PAGE})
embed(style ${STYLES})
embed(script ${SCRIPTS})
file(APPEND ${OUT} "}\n")
