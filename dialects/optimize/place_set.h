// Sets of places as bits, one row a statement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dialects/optimize/places.h"

namespace dripfeed::optimize {

class PlaceSet {
 public:
  explicit PlaceSet(std::size_t places) : words_((places + 63) / 64, 0) {}
  [[nodiscard]] bool has(Place p) const { return ((words_[p / 64] >> (p % 64)) & 1U) != 0; }
  void add(Place p) { words_[p / 64] |= std::uint64_t{1} << (p % 64); }
  void remove(Place p) { words_[p / 64] &= ~(std::uint64_t{1} << (p % 64)); }
  // Whether that changed anything.
  bool add_all(const PlaceSet& other) {
    bool changed = false;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t joined = words_[i] | other.words_[i];
      changed = changed || joined != words_[i];
      words_[i] = joined;
    }
    return changed;
  }
  [[nodiscard]] bool meets(const PlaceSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace dripfeed::optimize
