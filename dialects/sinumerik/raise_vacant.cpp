// On controls with '#' variables one that was never set is empty: a word with it is ignored, and it equals only itself.
// SINUMERIK has no such value: an R parameter holds what an earlier program left. A program keeps its meaning only when
// each local variable is set on every way to its use. Common variables may hold what the operator entered; those that
// are never set are told by the validator.
//
// Forward dataflow, "set on all ways": at each statement the variables that are surely set, as a bit each; where ways
// meet, the bits of all of them.
#include <algorithm>
#include <deque>
#include <map>

#include "dialects/passes/flow_graph.h"
#include "dialects/passes/walk.h"
#include "dialects/sinumerik/raise.h"

namespace dripfeed::sinumerik {

namespace {

using Bits = std::vector<std::uint64_t>;

class SetOnAllWays {
 public:
  explicit SetOnAllWays(const Raising& raising)
      : raising_(raising), program_(raising.program), in_(program_.statements.size() + 1) {}

  void run() {
    collect();
    if (bit_of_.empty()) return;
    propagate();
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) check(i);
  }

 private:
  [[nodiscard]] bool is_watched(const ir::Variable& v) const {
    if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none) return false;
    const ir::VariableRange* range = ir::find_variable(raising_.from, v.bank, v.number);
    return range != nullptr && range->use == ir::VariableUse::local;
  }

  void collect() {
    uses_.resize(program_.statements.size());
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      for (const passes::VariableUseAt& use : passes::variables_of(program_, program_.statements[i])) {
        const ir::Variable& v = program_.at(use.variable);
        if (!is_watched(v)) continue;
        bit_of_.emplace(v.number, static_cast<std::uint32_t>(bit_of_.size()));
        uses_[i].push_back(use);
      }
    }
  }

  [[nodiscard]] static bool has(const Bits& bits, std::uint32_t bit) {
    return (bits[bit / 64] >> (bit % 64) & 1U) != 0;
  }
  [[nodiscard]] std::uint32_t bit(const passes::VariableUseAt& use) const {
    return bit_of_.at(program_.at(use.variable).number);
  }

  // A statement that was not reached yet has no bits at all; the first way in gives it its own.
  void propagate() {
    passes::FlowGraph graph(program_);
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
      for (const passes::VariableUseAt& use : uses_[i])
        if (use.set) out[bit(use) / 64] |= std::uint64_t{1} << (bit(use) % 64);
      for (const std::uint32_t next : graph.after(i)) {
        if (in_[next].empty()) {
          in_[next] = out;
          work.push_back(next);
          continue;
        }
        bool changed = false;
        for (std::size_t w = 0; w < words; ++w) {
          const std::uint64_t met = in_[next][w] & out[w];
          changed = changed || met != in_[next][w];
          in_[next][w] = met;
        }
        if (changed) work.push_back(next);
      }
    }
  }

  void check(std::uint32_t i) {
    if (in_[i].empty()) return;  // never reached
    for (const passes::VariableUseAt& use : uses_[i]) {
      const ir::Variable& v = program_.at(use.variable);
      if (use.set || has(in_[i], bit(use)) || std::ranges::find(told_, v.number) != told_.end()) continue;
      told_.push_back(v.number);
      raising_.cannot("the variable #" + std::to_string(v.number) + ", which may be empty here,", v.span);
    }
  }

  const Raising& raising_;
  ir::Program& program_;
  std::vector<Bits> in_;
  std::vector<std::vector<passes::VariableUseAt>> uses_;
  std::map<std::uint32_t, std::uint32_t> bit_of_;
  std::vector<std::uint32_t> told_;
};

}  // namespace

void raise_vacant(const Raising& raising) {
  if (raising.from.semantics.has_vacant) SetOnAllWays(raising).run();
}

}  // namespace dripfeed::sinumerik
