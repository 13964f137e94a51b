// A block with nothing left to compute: values by address, and what its codes do. It is what the control would see if
// the program had no variables; the machine and a stream of plain blocks hand the same thing to `apply`.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "dialects/ir/plain_batch.h"

namespace dripfeed::interpreter {

inline constexpr std::size_t kAddressCount = static_cast<std::size_t>(ir::Address::count_);
static_assert(kAddressCount <= 64);

constexpr std::uint64_t bit_of(ir::Address address) { return std::uint64_t{1} << static_cast<unsigned>(address); }
constexpr std::size_t index_of(ir::Address address) { return static_cast<std::size_t>(address); }

inline constexpr std::uint32_t kNoText = 0xFFFFFFFFU;  // as Motion::text

using ir::PlainCode;

struct PlainBlock {
  // Bits by address. Values of absent addresses are left over from other blocks: clearing them would cost more than
  // the block.
  std::uint64_t present = 0;
  std::uint64_t in_increments = 0;  // the value counts least increments: it was written without a point
  std::uint64_t absolute = 0;       // AC()
  std::uint64_t incremental = 0;    // IC()
  std::uint64_t numbered = 0;       // written with a number (X1=): a machine axis; not in `present`
  std::uint64_t unknown = 0;        // its value is not known; not in `present`
  std::array<double, kAddressCount> values{};
  std::span<const PlainCode> codes;
  std::uint32_t tool_name = kNoText;  // T="NAME": index of a text of the run
  std::int32_t named_tool = 0;        // its number in the machine's profile; 0: not known

  void clear() {
    present = in_increments = absolute = incremental = numbered = unknown = 0, codes = {}, tool_name = kNoText;
    named_tool = 0;
  }
  [[nodiscard]] bool has(ir::Address address) const { return (present & bit_of(address)) != 0; }
  [[nodiscard]] double at(ir::Address address) const { return values[index_of(address)]; }
  void set(ir::Address address, double value) {
    present |= bit_of(address);
    values[index_of(address)] = value;
  }
};

inline bool has_code(const PlainBlock& block, ir::Function function) {
  return std::ranges::find(block.codes, function, &PlainCode::function) != block.codes.end();
}

}  // namespace dripfeed::interpreter
