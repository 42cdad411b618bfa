# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=FILE.cpp -DFILES=a.yaml;b.yaml -P EmbedMaterials.cmake
#
# Writes the catalogue of materials as a table of C++.
file(WRITE ${OUT} "#include \"materials/embedded.hpp\"\nnamespace twum::inline v0_1::motors {\nnamespace {\n")
set(table "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME_WE)
  string(MAKE_C_IDENTIFIER ${name} symbol)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n"
    bytes "${bytes}")
  file(APPEND ${OUT} "const unsigned char k_${symbol}[] = {\n${bytes}};\n")
  string(APPEND table "  {\"${name}\", {reinterpret_cast<const char*>(k_${symbol}), sizeof k_${symbol}}},\n")
endforeach()
file(APPEND ${OUT} "const EmbeddedFile kFiles[] = {\n${table}};\n}\n"
  "std::span<const EmbeddedFile> embedded_materials() { return kFiles; }\n}\n")
