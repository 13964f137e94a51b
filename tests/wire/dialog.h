// Dialog files: what goes over a wire, step by step, in text. This reads them; what a step does is each protocol's own.
//   # comment            == NAME  begins a dialog        after NAME  plays another dialog of the file first
//   set key=value ...    > out    < in    @ +120ms    ! event    * command    = what must hold now    ~ a late write
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::wire {

struct Step {
  char kind = 0;  // one of > < @ ! * = ~, or 's' for set
  std::string rest;
  std::string file;
  int line = 0;
};

struct Dialog {
  std::string name;
  std::vector<Step> steps;  // those of the dialogs it comes after first
};

// All dialogs of DRIPFEED_SOURCE_DIR/tests/wire/FOLDER/*.dialog, by file name. Throws std::runtime_error where one
// cannot be read.
std::vector<Dialog> load_dialogs(std::string_view folder);

std::vector<std::string> words(std::string_view text);
// "+120ms", "3us", "2s", "10min".
std::chrono::nanoseconds duration(std::string_view text);
// A mix of "quoted text" (\n \r \" \\), hex bytes and the names of control characters, as plain characters.
std::string characters(std::string_view text);

}  // namespace dripfeed::wire
