// A block at a time. Where the count of a hole stands, the cycle in effect says what K means.
#include "dialects/macro_b/writer/write_other_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "dialects/facts/facts.h"
#include "dialects/ir/hole_pattern.h"
#include "dialects/macro_b/reader/other_forms.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

using ir::Address;
using ir::ExpressionId;
using ir::Function;

namespace {

// G28 for all axes: each by an increment of 0.
bool names_all_axes(const ir::Program& program, std::span<const ir::Word> words, const ir::Control& control) {
  return words.size() == control.axes.size() && std::ranges::all_of(words, [&](const ir::Word& word) {
           return ir::is_axis(word.address) && word.mode == ir::WordMode::incremental &&
                  is_constant(program, word.value) && program.at(word.value).value == 0.0;
         });
}

}  // namespace

void write_other_forms(ir::Program& program, const ir::Control& control, const Grammar& grammar,
                       std::vector<text::Diagnostic>& diagnostics) {
  if (grammar.repeat_letter != 'L' && !grammar.dwell_point_is_seconds) return;
  // Of K alone the cycle in effect decides; most programs have none.
  std::optional<facts::Resolved> known;
  if (std::ranges::find(program.words, Address::k, &ir::Word::address) != program.words.end())
    known.emplace(program, control);
  const auto refuse = [&](const ir::Statement& s, passes::Refusal what) {
    diagnostics.push_back(passes::diagnose(std::move(what), s.span, control.title));
  };
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement s = program.statements[i];
    if (s.kind != ir::StatementKind::block) continue;
    ir::Block& block = program.blocks[s.payload];
    const auto codes = program.codes_of(block);
    const auto words = std::span(program.words).subspan(block.first_word, block.word_count);
    const bool returns = std::ranges::find(codes, Function::reference_return, &ir::Code::function) != codes.end();
    if (returns && grammar.reference_alone_is_all_axes && names_all_axes(program, words, control)) {
      block.word_count = 0;
      continue;
    }
    const bool times = std::ranges::any_of(codes, takes_time);
    for (ir::Word& word : words) {
      if (!times || word.address != Address::p || word.value == ExpressionId::none) continue;
      if (!is_constant(program, word.value)) {
        refuse(s, passes::computed("a dwell time that is computed"));
      } else if (const ir::Expression time = program.at(word.value); time.has_point) {
        word.value = program.add_constant(std::round(time.value), time.span, false);
      }
    }
    const auto pattern = std::ranges::find_if(codes, is_hole_pattern);
    if (pattern != codes.end()) {
      if (pattern->argument == ir::kHolesOnGrid) refuse(s, "a grid of holes");
      rename_words(words, Address::k, Address::l);
      rename_words(words, Address::p, Address::k);
      continue;
    }
    if (std::ranges::find(words, Address::k, &ir::Word::address) == words.end()) continue;
    const std::optional<facts::Facts> here = known->at(i);
    constexpr facts::Setting kNoCycle{.function = Function::cycle_off};
    if (here && (*here)[facts::Mode::cycle].is(kNoCycle)) continue;  // K of an arc or a thread
    const facts::Setting* cycle = here ? (*here)[facts::Mode::cycle].certain() : nullptr;
    if (cycle == nullptr)
      refuse(s, passes::not_known("K where it is not known whether a drilling cycle is in effect"));
    else if (cycle->function == Function::drill)
      rename_words(words, Address::k, Address::l);
  }
}

}  // namespace dripfeed::macro_b
