// Long stretches of plain moves that a program was read without. Whoever runs it scans them from the text each time
// that it comes by, so that a program of a million blocks needs no statement for each of them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "dialects/ir/plain_batch.h"

namespace dripfeed::ir {

struct PlainStretch {
  std::uint32_t statement = 0;  // before which it runs
  std::uint32_t line = 0;       // its first, 1-based, of the whole text
  std::uint32_t line_count = 0;
  std::uint64_t begin = 0;  // bytes of the whole text: whole lines
  std::uint64_t end = 0;
};

struct PlainStretches {
  std::string_view text{};  // the whole one, which must outlive it
  std::function<std::unique_ptr<PlainScanner>()> make_scanner;
  std::vector<PlainStretch> all{};  // in order
};

}  // namespace dripfeed::ir
