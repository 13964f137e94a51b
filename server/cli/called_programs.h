// Called programs in folders: by the file's name and the usual endings, then by the number or name that a program gives
// itself inside a file (O1234, :1234, <NAME>), as memory dumps and files with titles for names have them.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"

namespace dripfeed::cli {

// Folders are looked through in order. A number that stands in several files of one folder names none of them: which
// one the control holds is not known.
compile::FindText find_in(std::vector<std::string> folders);

}  // namespace dripfeed::cli
