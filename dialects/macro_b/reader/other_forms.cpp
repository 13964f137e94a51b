// A block at a time, as soon as its codes and words are read.
#include "dialects/macro_b/reader/other_forms.h"

#include <algorithm>
#include <span>

#include "dialects/ir/hole_pattern.h"
#include "dialects/macro_b/reader/lower.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;

// L of these is not the count of a hole.
bool has_own_count(const ir::Code& code) {
  return code.function == Function::data_input || code.function == Function::not_modelled ||
         code.number != ExpressionId::none;
}

}  // namespace

bool is_hole_pattern(const ir::Code& code) { return code.function == Function::hole_pattern; }
bool takes_time(const ir::Code& code) { return code.function == Function::dwell || code.function == Function::drill; }

void rename_words(std::span<ir::Word> words, Address from, Address to) {
  for (ir::Word& word : words)
    if (word.address == from) word.address = to;
}

bool is_constant(const ir::Program& program, ExpressionId id) {
  return id != ExpressionId::none && program.at(id).op == ir::Operator::constant;
}

bool has_other_form(const Grammar& grammar, Function function) {
  return (function == Function::dwell && grammar.dwell_point_is_seconds) ||
         (function == Function::reference_return && grammar.reference_alone_is_all_axes);
}

void BlockLowering::take_other_forms(std::uint32_t first_code, std::uint32_t first_word) {
  const auto codes = std::span(program_.codes).subspan(first_code);
  const auto words = std::span(program_.words).subspan(first_word);
  if (grammar_.repeat_letter == 'L' && std::ranges::none_of(codes, has_own_count)) {
    const auto pattern = std::ranges::find_if(codes, is_hole_pattern);
    // G71 has its angle from hole to hole in K, where G36 has P.
    if (pattern != codes.end() && pattern->argument == ir::kHolesOnArc) rename_words(words, Address::k, Address::p);
    rename_words(words, Address::l, Address::k);
  }
  if (grammar_.dwell_point_is_seconds && std::ranges::any_of(codes, takes_time)) {
    for (ir::Word& word : words) {
      if (word.address != Address::p || !is_constant(program_, word.value)) continue;
      const ir::Expression time = program_.at(word.value);
      if (time.has_point) word.value = program_.add_constant(time.value * kMillisecondsPerSecond, time.span, false);
    }
  }
  const bool returns = std::ranges::find(codes, Function::reference_return, &ir::Code::function) != codes.end();
  if (!returns || !grammar_.reference_alone_is_all_axes || !words.empty()) return;
  for (const char letter : control_.axes) {
    ir::Word word = ir::word(static_cast<Address>(letter - 'A'), program_.add_constant(0.0));
    word.mode = ir::WordMode::incremental;
    program_.words.push_back(word);
  }
}

}  // namespace dripfeed::macro_b
