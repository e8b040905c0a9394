# cmake -DROOT=folder -DFILES=a,b,... -DHEADER=h.hpp -DTYPE=T -DFUNCTION=f -DOUTPUT=file.cpp -P embed_files.cmake: defines the function f() that the header declares; it
# returns a table of T, (path, text, size) of every file.
string(REPLACE "," ";" files "${FILES}")
set(text "// Made by host/cmake/embed_files.cmake.\n#include \"${HEADER}\"\n\nnamespace tyndall {\n\nconst std::span<const ${TYPE}> ${FUNCTION}()\n{\n    static const ${TYPE} files[] = {\n")
foreach(file IN LISTS files)
  file(READ ${ROOT}/${file} content HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${content}")
  string(MAKE_C_IDENTIFIER ${file} id)
  string(APPEND arrays "static const unsigned char ${id}[] = {${bytes}0};\n")
  string(APPEND text "        {\"${file}\", reinterpret_cast<const char*>(${id}), sizeof ${id} - 1},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace tyndall\n")
string(REPLACE "namespace tyndall {\n\nconst" "namespace tyndall {\n\n${arrays}\nconst" text "${text}")
file(WRITE ${OUTPUT} "${text}")
