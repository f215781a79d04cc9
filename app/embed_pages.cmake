# cmake -DPAGES=<folder of .md> -DNAMES=<regular expression> -DLIST=<function> -DOUT=<file.cpp> -P embed_pages.cmake
# Writes the manual pages as C++ string literals. A raw literal may hold 64 KiB at most, pages are far smaller.
file(GLOB pages ${PAGES}/*.md)
list(SORT pages)
set(rows "")
foreach(page ${pages})
  get_filename_component(code ${page} NAME_WE)
  if(code MATCHES "${NAMES}")
    file(READ ${page} text)
    string(APPEND rows "    ManualPage{\"${code}\", R\"page(${text})page\"},\n")
  endif()
endforeach()
string(CONCAT source
  "// Made by app/embed_pages.cmake from docs/manual.\n"
  "#include \"app/manual_pages.h\"\n\n#include <vector>\n\n"
  "namespace arelem::app {\n\n"
  "std::span<const ManualPage> ${LIST}() {\n"
  "  static const std::vector<ManualPage> pages = {\n${rows}  };\n"
  "  return pages;\n}\n\n}  // namespace arelem::app\n")
file(WRITE ${OUT} "${source}")
