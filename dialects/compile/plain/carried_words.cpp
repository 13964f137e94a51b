// A table says which function takes which words along.
#include "dialects/compile/plain/carried_words.h"

#include <algorithm>
#include <array>

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;

enum class Carry : std::uint8_t {
  code,         // the code alone
  number,       // nothing but the number: motions carry the code
  code_in_own,  // a block of its own, with the axes that were named, as increments of nothing
};
struct CarriedRow {
  Function function;
  Carry carry;
};
constexpr auto kRows = std::to_array<CarriedRow>({
    {Function::length_offset_plus, Carry::code},
    {Function::length_offset_minus, Carry::code},
    {Function::length_offset_off, Carry::code},
    {Function::comp_left, Carry::number},
    {Function::comp_right, Carry::number},
    {Function::machine_function, Carry::code},
    {Function::reference_return, Carry::code_in_own},
});

// Axis letters; U V W H of a lathe are the increments of its axes.
struct AxisRow {
  Address address;
  Address axis;
};
constexpr auto kAxes = std::to_array<AxisRow>({
    {Address::x, Address::x},
    {Address::y, Address::y},
    {Address::z, Address::z},
    {Address::a, Address::a},
    {Address::b, Address::b},
    {Address::c, Address::c},
    {Address::u, Address::x},
    {Address::v, Address::y},
    {Address::w, Address::z},
});

// T of a mill is made ready; H and D stay in effect, so that each is carried wherever it stands.
void add_number(const ir::Program& program, const ir::Word& word, CarriedBlock& out) {
  if (word.value == ir::ExpressionId::none) return;
  const ir::Expression& value = program.at(word.value);
  if (value.op == ir::Operator::constant) {
    out.attached.words.push_back({word.address, value.value, ir::WordMode::as_modal});
  } else {
    out.computed.emplace_back(word.span.in(program.source.text()));
  }
}

void add_axes(const ir::Program& program, const ir::Block& block, CarriedWords& out) {
  for (const ir::Word& word : program.words_of(block)) {
    const auto row = std::ranges::find(kAxes, word.address, &AxisRow::address);
    if (row != kAxes.end()) out.words.push_back({row->axis, 0.0, ir::WordMode::incremental});
  }
}

}  // namespace

bool is_carried(Function function) { return std::ranges::find(kRows, function, &CarriedRow::function) != kRows.end(); }

const ir::Program* CarriedBlocks::source_of(std::uint32_t program, const std::vector<std::string>& names) const {
  if (program == 0 || is_section(program, names)) return &main_;
  return program < names.size() ? finder_.find(names[program]) : nullptr;
}

const CarriedBlock* CarriedBlocks::at(std::uint32_t program, const std::vector<std::string>& names,
                                      std::uint32_t line) {
  auto known = programs_.find(program);
  if (known == programs_.end()) {
    const ir::Program* source = source_of(program, names);
    known = programs_.emplace(program, source == nullptr ? ByLine{} : collect(*source)).first;
  }
  const auto found = known->second.find(line);
  return found == known->second.end() ? nullptr : &found->second;
}

// A called program that stands in the text of the main one.
bool CarriedBlocks::is_section(std::uint32_t program, const std::vector<std::string>& names) const {
  return program < names.size() &&
         std::ranges::any_of(
             main_.sections,
             [&](const ir::Section& section) { return main_.strings.at(section.name) == names[program]; });
}

CarriedBlocks::ByLine CarriedBlocks::collect(const ir::Program& program) const {
  ByLine out;
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::block) continue;
    CarriedBlock carried = carried_by(program, program.blocks[statement.payload]);
    if (carried.empty()) continue;
    const auto [entry, is_new] = out.try_emplace(statement.line, std::move(carried));
    // Places are lines: with G43 H1;G41 D2; it is not known which block is executed.
    if (!is_new) entry->second.computed.emplace_back("numbers of several blocks in one line");
  }
  return out;
}

CarriedBlock CarriedBlocks::carried_by(const ir::Program& program, const ir::Block& block) const {
  CarriedBlock carried;
  bool other_words = false;  // a code gives its words a meaning of its own: D of G76 is a depth
  for (const ir::Code& code : program.codes_of(block)) {
    other_words |= code.function == Function::not_modelled || code.function == Function::repetitive_cycle ||
                   code.function == Function::measure_tool;
    const auto row = std::ranges::find(kRows, code.function, &CarriedRow::function);
    if (row == kRows.end() || row->carry == Carry::number) continue;
    CarriedWords& words = row->carry == Carry::code ? carried.attached : carried.alone;
    words.codes.push_back({code.function, code.argument});
    if (row->carry == Carry::code_in_own) add_axes(program, block, carried.alone);
  }
  const bool changes = std::ranges::any_of(program.codes_of(block),
                                           [](const ir::Code& c) { return c.function == Function::tool_change; });
  const bool prepares =
      prepares_tools_ && !changes &&
      std::ranges::find(program.words_of(block), Address::t, &ir::Word::address) != program.words_of(block).end();
  for (const ir::Word& word : program.words_of(block))
    if (prepares && (word.address == Address::t || (semantics_.d_selects_edge && word.address == Address::d)))
      add_number(program, word, carried);
  if (semantics_.d_selects_edge || other_words) return carried;
  for (const ir::Word& word : program.words_of(block)) {
    const bool length = word.address == Address::h && !semantics_.incremental_letters_uvw;
    if (length || word.address == Address::d) add_number(program, word, carried);
  }
  return carried;
}

}  // namespace dripfeed::compile
