// Rule four of the paper: few blocks with long expressions. A value that one place reads before it is set again moves
// into the expression that reads it; the same operations run in the same order.
#include <algorithm>
#include <optional>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/readable_line.h"
#include "dialects/optimize/edit.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/value_facts.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

constexpr std::uint32_t kFarthest = 64;  // statements from an assignment to where it is read

class Merging {
 public:
  explicit Merging(Work& work)
      : work_(work),
        program_(work.program),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        liveness_(program_, places_, accesses_),
        is_target_(facts::jump_targets(program_)),
        is_parameter_(parameters_of(program_, places_, accesses_)),
        is_moved_(program_.statements.size(), false),
        into_(program_.statements.size()) {}

  bool run() {
    for (std::uint32_t i = 0; i < accesses_.size(); ++i) consider(i);
    if (std::ranges::none_of(is_moved_, [](bool moved) { return moved; })) return false;
    rewrite();
    return true;
  }

 private:
  struct Moved {
    Place place = kNoPlace;
    ExpressionId value = ExpressionId::none;
  };

  [[nodiscard]] ExpressionId value_at(std::uint32_t i) const {
    return program_.assigns[program_.statements[i].payload].value;
  }

  void consider(std::uint32_t i) {
    const ir::Statement& s = program_.statements[i];
    // What another value moves into waits for the next round; a block that is jumped to stays one.
    if (is_target_[i]) return;
    if (s.kind != StatementKind::assign || accesses_[i].is_fixed || accesses_[i].sets.size() != 1 || !into_[i].empty())
      return;
    const Place place = accesses_[i].sets.front();
    if (is_parameter_[place]) return;
    const PlaceFacts& facts = places_.at(place);
    const ExpressionId value = value_at(i);
    if (!facts.is_plain || !is_pure(program_, places_, value) || mentions_vacant(program_, value)) return;
    if (facts.type != ir::ValueType::real && !passes::is_whole(program_, value)) return;
    if (!is_number(program_, work_.control, value)) return;  // a vacant one has other effects where it is read
    const std::optional<std::uint32_t> reader = only_reader(i, place, value);
    if (!reader || !takes(*reader, place, value)) return;
    is_moved_[i] = true;
    into_[*reader].push_back({place, value});
    work_.report(Rule::merge, s.line, "the value moves into the expression that reads it");
  }

  // The one statement that reads the place before it is set again, in the same stretch of text.
  [[nodiscard]] std::optional<std::uint32_t> only_reader(std::uint32_t i, Place place, ExpressionId value) const {
    std::vector<Place> operands;
    add_places(program_, places_, value, operands);
    const bool faults = may_fault(program_, value);
    const auto end = std::min<std::uint32_t>(static_cast<std::uint32_t>(accesses_.size()), i + kFarthest);
    for (std::uint32_t j = i + 1; j < end; ++j) {
      if (is_target_[j]) return {};
      const Access& access = accesses_[j];
      const StatementKind kind = program_.statements[j].kind;
      if (std::ranges::find(access.reads, place) != access.reads.end()) {
        const bool sets_it = std::ranges::find(access.sets, place) != access.sets.end();
        const bool is_last = sets_it ? access.sets_for_sure : !liveness_.after(j, place);
        return is_last && !is_moved_[j] ? std::optional(j) : std::nullopt;
      }
      if (kind != StatementKind::assign && kind != StatementKind::block && kind != StatementKind::empty) return {};
      if (access.reads_shared || access.sets_shared || (faults && kind == StatementKind::block)) return {};
      for (const Place p : access.sets)
        if (p == place || std::ranges::find(operands, p) != operands.end()) return {};
    }
    return {};
  }

  // Whether the reader has the place once, where an expression may stand, and is short and flat enough with it.
  [[nodiscard]] bool takes(std::uint32_t reader, Place place, ExpressionId value) const {
    const ir::Statement& s = program_.statements[reader];
    if (accesses_[reader].is_fixed || std::ranges::count(accesses_[reader].reads, place) != 1) return false;
    switch (s.kind) {
      case StatementKind::assign: return fits(value_at(reader), place, value, reader);
      case StatementKind::if_begin:
        return !mentions_vacant(program_, program_.structures[s.payload].condition) &&
               fits(program_.structures[s.payload].condition, place, value, reader);
      case StatementKind::block: {
        const ir::Block& block = program_.blocks[s.payload];
        return block.rest_level == 0 && std::ranges::any_of(program_.words_of(block), [&](const ir::Word& w) {
                 return takes_any_number(w.address) && w.value != ExpressionId::none &&
                        fits(w.value, place, value, reader);
               });
      }
      default: return false;
    }
  }

  [[nodiscard]] bool fits(ExpressionId whole, Place place, ExpressionId value, std::uint32_t reader) const {
    if (count_of(program_, places_, whole, place) != 1 || mentions_vacant(program_, whole)) return false;
    const ir::ControlLimits& limits = work_.control.limits;
    std::uint32_t length = length_of(program_, whole) + length_of(program_, value);
    for (const Moved& m : into_[reader]) length += length_of(program_, m.value);
    const std::uint32_t longest =
        limits.block_length_bytes == 0 ? ir::kReadableLine : std::min(ir::kReadableLine, limits.block_length_bytes / 2);
    const std::uint32_t depth = depth_of(program_, whole) + depth_of(program_, value);
    return length <= longest && (limits.expression_nesting == 0 || depth <= limits.expression_nesting);
  }

  // In a word 60 may be 60 least increments; what a variable holds is 60.
  [[nodiscard]] ExpressionId as_number(ExpressionId value) {
    const ir::Expression e = program_.at(value);
    return e.op == ir::Operator::constant ? program_.add_constant(e.value) : value;
  }

  void rewrite() {
    passes::Rewrite out(program_);
    for (std::uint32_t i = 0; i < accesses_.size(); ++i) {
      out.at(i);
      if (is_moved_[i]) continue;
      if (into_[i].empty()) {
        out.keep();
        continue;
      }
      keep_with(program_, i, out, [&](ExpressionId id) {
        return rebuilt(program_, id, [&](ExpressionId node) {
          const Place place = place_at(program_, places_, node);
          for (const Moved& m : into_[i])
            if (m.place == place) return as_number(m.value);
          return node;
        });
      });
    }
    out.finish();
  }

  Work& work_;
  ir::Program& program_;
  Places places_;
  std::vector<Access> accesses_;
  Liveness liveness_;
  std::vector<bool> is_target_;
  std::vector<bool> is_parameter_;        // by place
  std::vector<bool> is_moved_;            // by statement: its value stands in another
  std::vector<std::vector<Moved>> into_;  // by statement
};

}  // namespace

bool merge_values(Work& work) { return Merging(work).run(); }

}  // namespace dripfeed::optimize
