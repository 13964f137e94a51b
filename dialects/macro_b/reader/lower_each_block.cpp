// G66.1: the macro is called in place of every block up to G67 and of G66.1's own, and the block's words are its
// arguments. (Mitsubishi M800 programming manual, "User macro modal call B"; for the other controls taken alike.) What
// G, L, N and P of the blocks become differs: those stay as they are, and nothing after them is certain until the
// axes are named again. Which blocks are meant is taken from the order of the text.
#include <algorithm>
#include <vector>

#include "dialects/macro_b/reader/lower.h"

namespace dripfeed::macro_b {

using ir::Function;

namespace {

constexpr std::int32_t kModalEnd10 = 670;  // G67

bool ends_program(const ir::CodeRow* row) {
  return row != nullptr && (row->function == Function::program_end || row->function == Function::program_end_rewind ||
                            row->function == Function::subprogram_end);
}

}  // namespace

void BlockLowering::begin_each_block(const RawWord& code, std::span<const RawWord> words, const BlockPlace& place) {
  const std::string_view written = code.span.in(program_.source.text());
  const auto program = std::ranges::find_if(words, [](const RawWord& w) { return w.letter == 'P' || w.letter == '<'; });
  if (program == words.end()) {
    faults_.report(text::DiagnosticId::address_without_value, code.span, {"P of " + std::string(written)},
                   ir::AlarmDetail::macro_program);
    return emit_native(written, false, place, true);
  }
  each_block_ = EachBlock{.program = *program};
  const auto repeats = std::ranges::find(words, 'L', &RawWord::letter);
  if (repeats != words.end()) each_block_->repeats = repeats->value;
  std::vector<RawWord> arguments;
  for (const RawWord& word : words)
    if (word.letter != 'L' && word.letter != 'P' && word.letter != '<') arguments.push_back(word);
  emit_each_block(arguments, place);
}

bool BlockLowering::is_under_each_block(std::span<const RawWord> words) const {
  if (words.empty()) return false;
  return std::ranges::none_of(words, [&](const RawWord& word) {
    if (word.comma || (word.letter != 'G' && word.letter != 'M')) return false;
    const std::int32_t number10 = number10_of(word.value);
    if (word.letter == 'G') return number10 == kModalEnd10;
    return ends_program(row_of('M', number10));
  });
}

void BlockLowering::emit_each_block(std::span<const RawWord> words, const BlockPlace& place) {
  const bool plain =
      place.rest_level == 0 && std::ranges::none_of(words, [](const RawWord& word) {
        return word.comma || word.letter == 'G' || word.letter == 'L' || word.letter == 'P' || word.letter == '<';
      });
  if (!plain) return emit_native("a block under G66.1", false, place, true);
  ir::Call call;
  call.kind = ir::CallKind::macro;
  call.repeats = each_block_->repeats;
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  for (const RawWord& word : words) program_.arguments.push_back({word.letter, word.value});
  call.argument_count = static_cast<std::uint32_t>(words.size());
  set_called_program(call, each_block_->program);
  program_.calls.push_back(call);
  emit(ir::StatementKind::call, static_cast<std::uint32_t>(program_.calls.size() - 1), place);
}

}  // namespace dripfeed::macro_b
