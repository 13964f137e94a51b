// Slices are taken without regard to the order of statements: what may matter, counts.
#include "dialects/optimize/table_nest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/facts/flow_graph.h"
#include "dialects/optimize/expressions.h"
#include "dialects/passes/structure_parts.h"

namespace dripfeed::optimize {

using ir::ExpressionId;
using ir::StatementKind;

NestSearch::NestSearch(const Work& work, const TableWish& wish, const Places& places,
                       const std::vector<Access>& accesses)
    : work_(work),
      wish_(wish),
      program_(work.program),
      places_(places),
      accesses_(accesses),
      is_target_(facts::jump_targets(program_)),
      around_(heads_around(program_)) {}

std::optional<Nest> NestSearch::dearest() const {
  std::optional<Nest> best;
  for (std::uint32_t i = 0; i < accesses_.size(); ++i) {
    if (!passes::begins_loop(program_.statements[i].kind)) continue;
    std::optional<Nest> found = nest_at(i);
    if (found && (!best || found->saved_ms > best->saved_ms)) best = std::move(found);
  }
  return best;
}

std::optional<Nest> NestSearch::nest_at(std::uint32_t head) const {
  const std::optional<CountedLoop> innermost = counted_at(head);
  if (!innermost) return {};
  Nest nest{.outer = *innermost, .inner = {}, .words = {}};
  if (wish_.nested) {
    const std::optional<CountedLoop> outer = around_[head] == ir::kNoIndex ? std::nullopt : counted_at(around_[head]);
    if (!outer || innermost->step != 1.0 || std::trunc(innermost->start) != innermost->start) return {};
    nest.outer = *outer;
    nest.inner = innermost;
  }
  if (wish_.spans >= nest.outer.rounds || !is_closed(nest.outer)) return {};
  for (std::uint32_t i = innermost->first + 1; i < innermost->last; ++i)
    if (around_[i] == innermost->first) add_words(nest, *innermost, i);
  return nest.words.empty() ? std::nullopt : std::optional(nest);
}

std::optional<CountedLoop> NestSearch::counted_at(std::uint32_t head) const {
  if (!passes::begins_loop(program_.statements[head].kind)) return {};
  return counted_loop(program_, places_, accesses_, is_target_, head);
}

// No jump into it or out of it, and nothing in it that others may look at or change.
bool NestSearch::is_closed(const CountedLoop& loop) const {
  for (std::uint32_t i = loop.first; i <= loop.last; ++i) {
    const StatementKind kind = program_.statements[i].kind;
    if (is_target_[i] || kind == StatementKind::go_to || kind == StatementKind::subprogram_return ||
        kind == StatementKind::program_end || accesses_[i].sets_shared)
      return false;
  }
  return true;
}

void NestSearch::add_words(Nest& nest, const CountedLoop& innermost, std::uint32_t i) const {
  const ir::Statement& s = program_.statements[i];
  if (s.kind != StatementKind::block || s.skip_level != 0) return;
  const ir::Block& block = program_.blocks[s.payload];
  if (block.rest_level != 0) return;
  for (const ir::Word& word : program_.words_of(block)) {
    const bool is_place = word.address >= ir::Address::x && word.address <= ir::Address::z;
    if (!is_place || word.mode == ir::WordMode::incremental || word.value == ExpressionId::none) continue;
    const TabulatedWord made{.block = i, .address = word.address, .value = word.value};
    const Slice slice = slice_of(nest, {made});
    const double ms = round_ms(slice, innermost) + cost_of(program_, work_.cost, word.value) - table_ms();
    if (!slice.is_pure || !(ms > 0.0)) continue;
    nest.words.push_back(made);
    nest.saved_ms += ms * nest.outer.rounds * (nest.inner ? nest.inner->rounds : 1);
  }
}

// Of the assignments of the slice in a round of the innermost loop.
double NestSearch::round_ms(const Slice& slice, const CountedLoop& innermost) const {
  double ms = 0.0;
  for (std::uint32_t i = innermost.first + 1; i < innermost.last; ++i) {
    const ir::Statement& s = program_.statements[i];
    if (!slice.has[i] || s.kind != StatementKind::assign || i == innermost.increment) continue;
    ms += work_.cost.block_ms + cost_of(program_, work_.cost, program_.assigns[s.payload].value);
  }
  return ms;
}
double NestSearch::table_ms() const {
  constexpr double kReads = 5.0, kIndexed = 3.0, kOperators = 7.0;
  return kReads * work_.cost.number_read_ms + kIndexed * work_.cost.indexed_ms + kOperators * work_.cost.operator_ms;
}

Slice NestSearch::slice_of(const Nest& nest, const std::vector<TabulatedWord>& words) const {
  Slice out{.has = std::vector<bool>(accesses_.size(), false), .computes = std::vector<bool>(places_.count(), false)};
  std::vector<bool> needed(places_.count(), false);
  const auto need = [&needed](const std::vector<Place>& reads) {
    for (const Place p : reads) needed[p] = true;
  };
  for (const TabulatedWord& word : words) {
    std::vector<Place> reads;
    add_places(program_, places_, word.value, reads);
    need(reads);
    out.is_pure = out.is_pure && is_pure(program_, places_, word.value);
    for (std::uint32_t head = around_[word.block]; head != nest.outer.first; head = around_[head])
      add_structure(head, out, needed);
  }
  if (nest.inner) needed[nest.inner->counter] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = nest.outer.first + 1; i < nest.outer.last; ++i) {
      const Access& access = accesses_[i];
      const bool sets = std::ranges::any_of(access.sets, [&](Place p) { return needed[p]; });
      if (out.has[i] || !sets || i == nest.outer.increment) continue;
      changed = true;
      need(access.reads);
      if (program_.statements[i].kind != StatementKind::assign) {
        add_structure(i, out, needed);
        continue;
      }
      out.has[i] = true;
      out.is_pure = out.is_pure && !access.is_fixed && access.sets.size() == 1 && access.sets_for_sure &&
                    is_pure(program_, places_, program_.assigns[program_.statements[i].payload].value) &&
                    access.sets.front() != nest.outer.counter;
      for (std::uint32_t head = around_[i]; head != nest.outer.first; head = around_[head])
        add_structure(head, out, needed);
    }
  }
  for (std::uint32_t i = 0; i < accesses_.size(); ++i)
    if (out.has[i])
      for (const Place p : accesses_[i].sets) out.computes[p] = true;
  return out;
}

// Its head, its ELSE and its end.
void NestSearch::add_structure(std::uint32_t i, Slice& out, std::vector<bool>& needed) const {
  if (!ir::is_structure(program_.statements[i].kind)) {
    out.is_pure = false;  // a block or a call that sets numbers
    return;
  }
  std::uint32_t part = passes::ends_loop(program_.statements[i].kind) ? passes::structure_at(program_, i).partner : i;
  const std::uint32_t head = part;
  while (part != ir::kNoIndex && !out.has[part]) {
    out.has[part] = true;
    out.is_pure = out.is_pure && !accesses_[part].reads_outside && !accesses_[part].is_fixed;
    for (const Place p : accesses_[part].reads) needed[p] = true;
    part = passes::structure_at(program_, part).partner;
    if (part == head) break;
  }
}

}  // namespace dripfeed::optimize
