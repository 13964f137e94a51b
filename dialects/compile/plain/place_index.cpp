// Finding the block of an offset.
#include "dialects/compile/plain/place_index.h"

#include <algorithm>

namespace dripfeed::compile {

std::size_t PlaceIndex::at(std::uint32_t offset) const {
  const auto after = std::ranges::upper_bound(entries, offset, {}, &PlaceEntry::offset);
  return after == entries.begin() ? 0 : static_cast<std::size_t>(after - entries.begin()) - 1;
}

}  // namespace dripfeed::compile
