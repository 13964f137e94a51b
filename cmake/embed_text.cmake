# Writes a text file as a C++ function that returns it, so that the program needs no file beside it.
#   cmake -D TEXT=FILE -D HEADER=PATH -D NAME=FUNCTION -D OUT=FILE -P embed_text.cmake
# HEADER declares std::string_view dripfeed::json::FUNCTION().
file(READ ${TEXT} text)
get_filename_component(name ${TEXT} NAME)
file(WRITE ${OUT} "// Written by cmake/embed_text.cmake from ${name}.
#include \"${HEADER}\"

namespace dripfeed::json {

std::string_view ${NAME}() { return R\"text(${text})text\"; }

}  // namespace dripfeed::json
")
