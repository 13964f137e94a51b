// A walk over the statements that may follow.
#include <algorithm>
#include <array>
#include <set>

#include "dialects/compile/translate/lathe_facts.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/called_cycle.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

// A turning cycle leaves the modes as they were. HOLES1 may call a program of the shop's.
bool is_cycle(const ir::Program& program, const ir::Statement& s) {
  if (s.kind != StatementKind::call) return false;
  const ir::CalledCycle* cycle = program.calls[s.payload].cycle;
  return cycle != nullptr && cycle->sort != ir::CalledSort::holes_in_row &&
         cycle->sort != ir::CalledSort::holes_on_circle && cycle->sort != ir::CalledSort::holes_anywhere;
}
// … and these do not cut with the feed that is in effect.
bool brings_its_feed(const ir::Program& program, const ir::Statement& s) {
  const ir::Call& call = program.calls[s.payload];
  return ir::is_called(call, ir::CalledSort::removal) || ir::is_called(call, ir::CalledSort::thread);
}

// What a statement does to something that stays in effect.
enum class Use : std::uint8_t { none, sets, needs };

// Where the program goes on elsewhere, or it is not known how: what is in effect may be needed there.
bool leaves(const ir::Program& program, const ir::Statement& s) {
  constexpr std::array kElsewhere = {StatementKind::subprogram_return, StatementKind::return_to,
                                     StatementKind::modal_call,        StatementKind::modal_call_end,
                                     StatementKind::repeat_section,    StatementKind::execute_text};
  if (s.kind == StatementKind::native) return !program.natives[s.payload].effects_known;
  return std::ranges::find(kElsewhere, s.kind) != kElsewhere.end();
}

// On some path after the statement. `use_of`: of a block or a call.
template <class UseOf>
bool is_needed_after(const ir::Program& program, std::uint32_t statement, UseOf use_of) {
  facts::FlowGraph graph(program);
  std::set<std::uint32_t> seen;  // a few as a rule
  std::vector<std::uint32_t> open = graph.after(statement);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (i >= program.statements.size() || !seen.insert(i).second) continue;
    const ir::Statement& s = program.statements[i];
    if (leaves(program, s)) return true;
    const bool uses = s.kind == StatementKind::block || s.kind == StatementKind::call;
    const Use use = uses ? use_of(s) : Use::none;
    if (use == Use::needs) return true;
    if (use == Use::sets && s.skip_level == 0) continue;
    const std::vector<std::uint32_t> next = graph.after(i);
    open.insert(open.end(), next.begin(), next.end());
  }
  return false;
}

}  // namespace

bool needs_feed_after(const ir::Program& program, std::uint32_t statement) {
  return is_needed_after(program, statement, [&](const ir::Statement& s) {
    if (s.kind == StatementKind::call) return brings_its_feed(program, s) ? Use::none : Use::needs;
    const ir::Block& block = program.blocks[s.payload];
    const auto words = program.words_of(block);
    if (std::ranges::find(words, Address::f, &ir::Word::address) != words.end()) return Use::sets;
    const bool cuts = std::ranges::any_of(program.codes_of(block), [](const ir::Code& c) {
      // A thread whose lead changes states an F of its own.
      return c.group == ir::ModalGroup::motion && c.function != Function::rapid && c.function != Function::thread;
    });
    return cuts ? Use::needs : Use::none;
  });
}

bool needs_motion_after(const ir::Program& program, std::uint32_t statement) {
  return is_needed_after(program, statement, [&](const ir::Statement& s) {
    if (s.kind == StatementKind::call) return is_cycle(program, s) ? Use::none : Use::needs;
    const ir::Block& block = program.blocks[s.payload];
    const auto codes = program.codes_of(block);
    if (std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group) != codes.end()) return Use::sets;
    return program.words_of(block).empty() ? Use::none : Use::needs;
  });
}

}  // namespace dripfeed::compile
