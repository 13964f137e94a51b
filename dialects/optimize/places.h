// The scalar variables of a program, each with a small number, so that sets of them are bits. Elements of arrays,
// computed numbers (R[R1], #[#1]) and system variables are no places: nothing is concluded from them.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::optimize {

using Place = std::uint32_t;
inline constexpr Place kNoPlace = ir::kNoIndex;

// Numbers of a bank, both ends included.
struct NumberRange {
  ir::Bank bank = ir::Bank::hash;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  [[nodiscard]] bool has(ir::Bank of, std::uint32_t number) const {
    return of == bank && number >= first && number <= last;
  }
};

struct PlaceFacts {
  ir::Bank bank = ir::Bank::hash;
  std::uint32_t number = 0;
  ir::SymbolId symbol = ir::SymbolId::none;  // bank named
  ir::ValueType type = ir::ValueType::real;
  // No program but this one reads it, and no program that it calls.
  bool is_own = false;
  // A real number that only assignments change.
  bool is_plain = false;
};

class Places {
 public:
  // `own`: numbers that no other program reads, as whoever asks states; local variables and names of the program are
  // its own as far as it calls no others. `program` must outlive it.
  Places(const ir::Program& program, const ir::Control& control, std::span<const NumberRange> own);

  // kNoPlace where it is none.
  [[nodiscard]] Place of(const ir::Variable& variable) const;
  [[nodiscard]] const PlaceFacts& at(Place place) const { return facts_[place]; }
  [[nodiscard]] std::size_t count() const { return facts_.size(); }
  // Whether a computed number or a call may reach it.
  [[nodiscard]] bool is_shared(Place place) const { return facts_[place].bank != ir::Bank::named; }

 private:
  using Key = std::pair<ir::Bank, std::uint32_t>;
  std::map<Key, Place> by_key_;
  std::vector<PlaceFacts> facts_;
};

}  // namespace dripfeed::optimize
