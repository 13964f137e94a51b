// Forward dataflow, "set on all paths": at each statement the variables that are surely set, as a bit each; where paths
// meet, the bits of all of them. A path on which an equality with an empty value has failed is one on which the
// variable is not empty: after IF[#1EQ#0]THEN #1=5 it is set in either case.
#include "dialects/passes/set_on_all_paths.h"

#include <deque>
#include <map>
#include <utility>

#include "dialects/facts/flow_graph.h"
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

namespace {

using Bits = std::vector<std::uint64_t>;

struct Use {
  VariableUseAt at;
  std::uint32_t watched = 0;
  std::uint32_t bit = 0;
};

class SetOnAllPaths {
 public:
  SetOnAllPaths(const ir::Program& program, const WatchedVariable& watched)
      : program_(program), watched_(watched), in_(program.statements.size() + 1), uses_(program.statements.size()) {
    for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
      for (const VariableUseAt& use : variables_of(program, program.statements[i])) {
        const std::optional<std::uint32_t> key = watched(program.at(use.variable));
        if (!key) continue;
        const auto entry = bit_of_.emplace(*key, static_cast<std::uint32_t>(bit_of_.size())).first;
        uses_[i].push_back({use, *key, entry->second});
      }
    }
  }

  std::vector<UnsetRead> run() {
    std::vector<UnsetRead> out;
    if (bit_of_.empty()) return out;
    propagate();
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      if (in_[i].empty()) continue;  // never reached
      for (const Use& use : uses_[i])
        if (!use.at.set && !has(in_[i], use.bit)) out.push_back({i, use.at.variable, use.watched});
    }
    return out;
  }

 private:
  static bool has(const Bits& bits, std::uint32_t bit) { return (bits[bit / 64] >> (bit % 64) & 1U) != 0; }

  // A statement that was not reached yet has no bits at all; the first path in gives it its own.
  void propagate() {
    facts::FlowGraph graph(program_);
    const std::size_t words = bit_of_.size() / 64 + 1;
    std::deque<std::uint32_t> work;
    for (const std::uint32_t entry : graph.entries()) {
      in_[entry] = Bits(words, 0);
      work.push_back(entry);
    }
    while (!work.empty()) {
      const std::uint32_t i = work.front();
      work.pop_front();
      if (i >= program_.statements.size()) continue;
      Bits out = in_[i];
      for (const Use& use : uses_[i])
        if (use.at.set && program_.statements[i].skip_level == 0)
          out[use.bit / 64] |= std::uint64_t{1} << (use.bit % 64);
      const std::vector<std::uint32_t> successors = graph.after(i);
      for (const std::uint32_t next : successors) {
        Bits there = out;
        if (successors.size() == 2 && successors[0] != successors[1]) note_asked(i, next, there);
        if (meet(in_[next], there)) work.push_back(next);
      }
    }
  }

  // The condition of a statement with two paths: a jump's goes on when it fails, a structure's when it holds.
  void note_asked(std::uint32_t i, std::uint32_t next, Bits& bits) const {
    const ir::Statement& s = program_.statements[i];
    if (s.skip_level != 0) return;
    if (s.kind == ir::StatementKind::go_to) return surely(program_.jumps[s.payload].condition, next != i + 1, bits);
    if (s.kind == ir::StatementKind::if_begin || s.kind == ir::StatementKind::while_begin)
      surely(program_.structures[s.payload].condition, next == i + 1, bits);
  }

  // What is not empty where `condition` is `holds`.
  void surely(ir::ExpressionId condition, bool holds, Bits& bits) const {
    if (condition == ir::ExpressionId::none) return;
    const ir::Expression& e = program_.at(condition);
    const ir::Operator both = holds ? ir::Operator::logic_and : ir::Operator::logic_or;
    if (e.op == ir::Operator::logic_not) return surely(e.a, !holds, bits);
    if (e.op == both) {
      surely(e.a, holds, bits);
      return surely(e.b, holds, bits);
    }
    if (e.op != (holds ? ir::Operator::not_equal : ir::Operator::equal)) return;
    for (const auto& [one, other] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      if (program_.at(one).op != ir::Operator::variable || program_.at(other).op != ir::Operator::vacant) continue;
      const auto key = watched_(program_.at(program_.at(one).variable));
      const auto bit = key ? bit_of_.find(*key) : bit_of_.end();
      if (bit != bit_of_.end()) bits[bit->second / 64] |= std::uint64_t{1} << (bit->second % 64);
    }
  }

  // True when `there` lost bits or was reached for the first time.
  static bool meet(Bits& there, const Bits& with) {
    if (there.empty()) {
      there = with;
      return true;
    }
    bool changed = false;
    for (std::size_t w = 0; w < there.size(); ++w) {
      const std::uint64_t met = there[w] & with[w];
      changed = changed || met != there[w];
      there[w] = met;
    }
    return changed;
  }

  const ir::Program& program_;
  const WatchedVariable& watched_;
  std::vector<Bits> in_;
  std::vector<std::vector<Use>> uses_;
  std::map<std::uint32_t, std::uint32_t> bit_of_;
};

}  // namespace

std::vector<UnsetRead> reads_before_set(const ir::Program& program, const WatchedVariable& watched) {
  return SetOnAllPaths(program, watched).run();
}

}  // namespace dripfeed::passes
