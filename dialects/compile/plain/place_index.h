// The place index of an explicit program: for each block of the text where it begins, which line of the family it came
// from, and what the family's variables were. Kept with the text; asked with a byte offset while feeding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dripfeed::compile {

struct PlaceEntry {
  std::uint32_t offset = 0;  // of the block's first byte in the text
  std::uint32_t line = 0;    // of the printed text, 1-based
  std::uint32_t origin = 0;  // line of the family (or of the program that was converted); 0: of the frame
};

struct PlaceIndex {
  std::vector<PlaceEntry> entries;  // in the order of the text, one a block
  std::vector<std::string> names;   // of the family's variables that change from block to block
  std::vector<double> values;       // entries × names, row by row, stored units; NaN: not yet set
  // The others: parameters and what is computed once.
  std::vector<std::pair<std::string, double>> constants;

  [[nodiscard]] std::span<const double> values_of(std::size_t entry) const {
    return std::span(values).subspan(entry * names.size(), names.size());
  }
  // Index of the block that holds the byte, the first for offsets before it; entries must not be empty.
  [[nodiscard]] std::size_t at(std::uint32_t offset) const;
};

}  // namespace dripfeed::compile
