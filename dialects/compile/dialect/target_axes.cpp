// A word of an axis that is not there would be read as something else: H as a number, C as a chamfer.
#include "dialects/compile/dialect/target_axes.h"

#include <algorithm>
#include <optional>

#include "dialects/ir/axis_letters.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

using ir::Function;

constexpr std::string_view kIncrementLetters = "UVWH";  // where increments have letters

// The axis of `control` that the address moves.
std::optional<char> axis_of(ir::Address address, const ir::Control& control) {
  if (address > ir::Address::z) return std::nullopt;
  const char letter = ir::letter_of(address);
  if (control.axes.contains(letter)) return letter;
  return ir::incremented_axis(control, letter);
}

// U10 of an axis U, or H5 of a function, would move X or C where such letters are increments.
bool becomes_increment(ir::Address address, const ir::Control& from, const ir::Control& to) {
  return address <= ir::Address::z && ir::incremented_axis(to, ir::letter_of(address)).has_value() &&
         !ir::incremented_axis(from, ir::letter_of(address)).has_value();
}

// Codes whose words are no positions.
bool takes_letters(const ir::Code& code) {
  return code.function == Function::dwell || code.function == Function::data_input ||
         code.function == Function::not_modelled || code.function == Function::repetitive_cycle;
}

}  // namespace

std::string joint_axes(const ir::Control& to, const ir::Control& from) {
  std::string out;
  for (const char letter : ir::kAxisLetters) {
    const bool taken = to.semantics.incremental_letters_uvw && kIncrementLetters.contains(letter);
    if (to.axes.contains(letter) || (from.axes.contains(letter) && !taken)) out.push_back(letter);
  }
  return out;
}

std::vector<text::Diagnostic> foreign_axis_words(const ir::Program& program, const ir::Control& from,
                                                 const ir::Control& to) {
  std::vector<text::Diagnostic> out;
  std::string listed;
  for (const ir::Statement& s : program.statements) {
    if (s.kind != ir::StatementKind::block) continue;
    const ir::Block& block = program.blocks[s.payload];
    if (std::ranges::any_of(program.codes_of(block), takes_letters)) continue;
    for (const ir::Word& word : program.words_of(block)) {
      std::optional<char> axis = axis_of(word.address, from);
      if (!axis && becomes_increment(word.address, from, to)) axis = ir::letter_of(word.address);
      if (!axis || to.axes.contains(*axis) || listed.contains(*axis)) continue;
      listed.push_back(*axis);
      const text::Span span = word.span.empty() ? s.span : word.span;
      out.push_back(passes::diagnose(passes::of_axis(std::string("the axis ") + *axis), span, to.title));
    }
  }
  return out;
}

}  // namespace dripfeed::compile
