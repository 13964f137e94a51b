// F of a block.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

inline constexpr std::uint64_t kFeedWord = bit_of(ir::Address::f);

// F without a point counts 0.01 mm/rev, 1 mm/min, and in inch a hundredth of these in inch (usual parameter settings).
inline double feed_of_word(const PlainBlock& block, const Modes& modes) {
  double value = block.at(ir::Address::f);
  if (modes.feed_mode == ir::FeedMode::inverse_time) return value;
  const bool counted = (block.in_increments & kFeedWord) != 0;
  if (counted && modes.feed_mode == ir::FeedMode::per_rev) value /= 100.0;
  if (counted && modes.inch_feed) value /= 100.0;
  return modes.inch_feed ? value * 25.4 : value;
}

}  // namespace dripfeed::interpreter
