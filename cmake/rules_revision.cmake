# Writes the revision of the code that judges programs as C++: a hash over all its sources. Verdicts of another revision are stale.
#   cmake -D SOURCES=LIST -D ROOT=DIR -D OUT=FILE -P rules_revision.cmake
# SOURCES: a file with a path a line, below ROOT. A name counts as well as what is in the file.
file(STRINGS ${SOURCES} paths)
list(SORT paths)
set(all "")
foreach(path IN LISTS paths)
  file(SHA256 ${path} hash)
  file(RELATIVE_PATH name ${ROOT} ${path})
  string(APPEND all "${name} ${hash}\n")
endforeach()
string(SHA256 revision "${all}")
string(SUBSTRING ${revision} 0 16 revision)
file(WRITE ${OUT} "// Written by cmake/rules_revision.cmake from the sources of what judges.
#include \"server/cli/rules_revision.h\"

namespace dripfeed::cli {

std::string_view rules_revision() { return \"${revision}\"; }

}  // namespace dripfeed::cli
")
