// Forward dataflow, "set on all ways": at each statement the variables that are surely set, as a bit each; where ways
// meet, the bits of all of them.
#include "dialects/passes/set_on_all_ways.h"

#include <deque>
#include <map>

#include "dialects/passes/flow_graph.h"
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

namespace {

using Bits = std::vector<std::uint64_t>;

struct Use {
  VariableUseAt at;
  std::uint32_t watched = 0;
  std::uint32_t bit = 0;
};

class SetOnAllWays {
 public:
  SetOnAllWays(const ir::Program& program, const WatchedVariable& watched)
      : program_(program), in_(program.statements.size() + 1), uses_(program.statements.size()) {
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

  // A statement that was not reached yet has no bits at all; the first way in gives it its own.
  void propagate() {
    FlowGraph graph(program_);
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
        if (use.at.set) out[use.bit / 64] |= std::uint64_t{1} << (use.bit % 64);
      for (const std::uint32_t next : graph.after(i)) {
        if (meet(in_[next], out)) work.push_back(next);
      }
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
  std::vector<Bits> in_;
  std::vector<std::vector<Use>> uses_;
  std::map<std::uint32_t, std::uint32_t> bit_of_;
};

}  // namespace

std::vector<UnsetRead> reads_before_set(const ir::Program& program, const WatchedVariable& watched) {
  return SetOnAllWays(program, watched).run();
}

}  // namespace dripfeed::passes
