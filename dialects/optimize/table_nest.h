// Where a table may stand in place of a formula: loops that count, words in them whose values take long, and what
// computes these.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/optimize/counted_loop.h"
#include "dialects/optimize/work.h"

namespace dripfeed::optimize {

struct TabulatedWord {
  std::uint32_t block = 0;  // statement
  ir::Address address = ir::Address::x;
  ir::ExpressionId value = ir::ExpressionId::none;
};

struct Nest {
  CountedLoop outer;                 // over which is interpolated
  std::optional<CountedLoop> inner;  // of which every round has its own values
  std::vector<TabulatedWord> words;
  double saved_ms = 0.0;
};

// What computes some values within a loop: statements, whole structures among them.
struct Slice {
  std::vector<bool> has;       // by statement
  std::vector<bool> computes;  // by place: set by one of them
  bool is_pure = true;         // assignments of plain numbers from such numbers, and IF and loops around them
};

class NestSearch {
 public:
  // `places` and `accesses` are of `work.program`; all must outlive it.
  NestSearch(const Work& work, const TableWish& wish, const Places& places, const std::vector<Access>& accesses);

  // The loops whose words take the longest in all their rounds.
  [[nodiscard]] std::optional<Nest> dearest() const;
  // What computes the words in a round of the outer loop, but for its counter.
  [[nodiscard]] Slice slice_of(const Nest& nest, const std::vector<TabulatedWord>& words) const;

 private:
  [[nodiscard]] std::optional<Nest> nest_at(std::uint32_t head) const;
  [[nodiscard]] std::optional<CountedLoop> counted_at(std::uint32_t head) const;
  [[nodiscard]] bool is_closed(const CountedLoop& loop) const;
  void add_words(Nest& nest, const CountedLoop& innermost, std::uint32_t i) const;
  [[nodiscard]] double round_ms(const Slice& slice, const CountedLoop& innermost) const;
  [[nodiscard]] double table_ms() const;
  void add_structure(std::uint32_t i, Slice& out, std::vector<bool>& needed) const;

  const Work& work_;
  TableWish wish_;
  const ir::Program& program_;
  const Places& places_;
  const std::vector<Access>& accesses_;
  std::vector<bool> is_target_;
  std::vector<std::uint32_t> around_;
};

}  // namespace dripfeed::optimize
