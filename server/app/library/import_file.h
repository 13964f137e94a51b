// One file for the library: a program, or the memory of a control with many.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "server/app/library/shop_files.h"

namespace dripfeed::app {

// Called with each row when it is known.
using OnImported = std::function<void(const ImportRow&)>;

struct FileToImport {
  std::string path;     // "turning/O0012.nc": its folders become folders of the library
  std::string under{};  // the library's folder in which those lie; "": none
  std::string_view bytes{};
  bool keeps_ending = false;  // in its name: another file of its folder differs by that alone
};

// Where a file comes to lie in the library.
struct PlaceOfFile {
  std::string folder;  // "": none
  std::string file;    // its own name
};
PlaceOfFile place_of_file(std::string_view path, std::string_view under);

// A file with several programs becomes a folder with each of them. What is no text of a program is skipped.
void import_file(Importer& importer, const FileToImport& file, const OnImported& on_imported);

}  // namespace dripfeed::app
