# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=FILE.cpp -DPAGE=... -DSTYLES=a;b -DSCRIPTS=a;b -DDESIGNER_PAGE=... -DDESIGNER_SCRIPTS=a;b
#   -DDATASHEET=... [-DMODULE=core.wasm.gz] -P EmbedReport.cmake
#
# Writes the pages' templates, their styles and scripts, each kind in one piece and with its hash, and the core for pages as
# functions of C++. Scripts are modules in the tree and one script in a page: their names are told apart without `import`.
function(write_bytes name bytes)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n"
    bytes "${bytes}")
  file(APPEND ${OUT} "namespace {\nconst unsigned char k_${name}[] = {\n${bytes}};\n}\n"
    "std::string_view ${name}() {\n"
    "  return {reinterpret_cast<const char*>(k_${name}), sizeof k_${name}};\n}\n")
endfunction()

function(embed name)
  set(bytes "")
  foreach(file ${ARGN})
    file(READ ${file} part HEX)
    string(APPEND bytes "${part}0a")
  endforeach()
  write_bytes(${name} "${bytes}")
endfunction()

function(embed_with_hash name)
  embed(${name} ${ARGN})
  set(whole ${OUT}.${name})
  file(WRITE ${whole} "")
  foreach(file ${ARGN})
    file(READ ${file} part)
    file(APPEND ${whole} "${part}\n")
  endforeach()
  file(SHA256 ${whole} hash)
  write_bytes(${name}_hash ${hash})
endfunction()

# Modules become one script: `import` and `export` at the beginning of a line go, and so do comments that have lines of their own, empty lines and indents.
function(embed_modules name)
  set(bundle ${OUT}.${name}.js)
  file(WRITE ${bundle} "'use strict';\n")
  foreach(file ${ARGN})
    file(READ ${file} part)
    string(PREPEND part "\n")  # of the first line too
    string(REGEX REPLACE "\nimport [^;]*;" "" part "${part}")
    string(REPLACE "\nexport " "\n" part "${part}")
    string(REGEX REPLACE "\n */[*][*][^*]*([*]+[^*/][^*]*)*[*]+/" "" part "${part}")
    string(REGEX REPLACE "\n *//[^\n]*" "" part "${part}")
    string(REGEX REPLACE "\n[\n ]+" "\n" part "${part}")
    file(APPEND ${bundle} "${part}\n")
  endforeach()
  embed_with_hash(${name} ${bundle})
endfunction()

# Styles become one, without comments that have lines of their own and indents.
function(embed_styles name)
  set(whole ${OUT}.${name}.css)
  file(WRITE ${whole} "")
  foreach(file ${ARGN})
    file(READ ${file} part)
    string(REGEX REPLACE "(^|\n) */[*][^*]*([*]+[^*/][^*]*)*[*]+/" "" part "${part}")
    string(REGEX REPLACE "\n[\n ]+" "\n" part "${part}")
    file(APPEND ${whole} "${part}")
  endforeach()
  embed_with_hash(${name} ${whole})
endfunction()

file(WRITE ${OUT} "#include \"report/assets.hpp\"\nnamespace twum::inline v0_1::studies::assets {\n")
embed(page ${PAGE})
embed(designer_page ${DESIGNER_PAGE})
embed(datasheet_page ${DATASHEET})
embed_styles(style ${STYLES})
embed_modules(script ${SCRIPTS})
embed_modules(designer_script ${DESIGNER_SCRIPTS})
if(MODULE)
  file(READ ${MODULE} bytes HEX)
  write_bytes(core_module ${bytes})
else()
  file(APPEND ${OUT} "std::string_view core_module() { return {}; }\n")
endif()
file(APPEND ${OUT} "}\n")
