// A table says which function takes which words along.
#include "dialects/compile/plain/carried_words.h"

#include <algorithm>
#include <array>

#include "dialects/ir/offset_words.h"

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
    out.lost.push_back(passes::computed(std::string(word.span.in(program.source.text()))));
  }
}

// Words that a builder's M function may take: M150 P3, M19 R90.
constexpr std::array kOwnWords = {Address::e, Address::i, Address::j, Address::k,
                                  Address::l, Address::p, Address::q, Address::r};

bool may_take_words(const ir::Code& c) {
  return c.function == Function::machine_function || c.function == Function::spindle_orient;
}

bool stands_for_itself(const ir::Code& c) {
  return c.group == ir::ModalGroup::spindle || c.group == ir::ModalGroup::coolant || may_take_words(c);
}

// Whose words are they? Those of a block that moves, or has another code, may be that code's; P and Q of a move are
// not.
enum class Owner : std::uint8_t { none, function, not_known };
Owner owner_of(const ir::Program& program, const ir::Block& block, Address address) {
  const auto codes = program.codes_of(block);
  const auto words = program.words_of(block);
  if (std::ranges::find(kOwnWords, address) == kOwnWords.end() || std::ranges::none_of(codes, may_take_words))
    return Owner::none;
  if (std::ranges::all_of(codes, stands_for_itself) && std::ranges::none_of(words, ir::is_axis, &ir::Word::address))
    return Owner::function;
  const bool one_takes_words = std::ranges::any_of(codes, [](const ir::Code& c) {
    return !may_take_words(c) && (ir::takes_p(c.function) || c.function == Function::extended_offset ||
                                  c.function == Function::work_offset || c.function == Function::measure_tool ||
                                  c.function == Function::turning_cycle || c.function == Function::rotate);
  });
  return one_takes_words || (address != Address::p && address != Address::q) ? Owner::none : Owner::not_known;
}

// Plain blocks write lengths with a point; what the builder's function makes of one without it is not known.
bool counts_increments(const ir::Program& program, const ir::Word& word) {
  constexpr std::array kLengths = {Address::i, Address::j, Address::k, Address::q, Address::r};
  return std::ranges::find(kLengths, word.address) != kLengths.end() && word.value != ir::ExpressionId::none &&
         !program.at(word.value).has_point;
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

ByLine<CarriedBlock>& CarriedBlocks::look_at(std::uint32_t program, const std::vector<std::string>& names) {
  const ir::Program* source = source_of(program, names);
  return programs_.add(program, source == nullptr ? ByLine<CarriedBlock>() : collect(*source));
}

// A called program that stands in the text of the main one.
bool CarriedBlocks::is_section(std::uint32_t program, const std::vector<std::string>& names) const {
  return program < names.size() &&
         std::ranges::any_of(
             main_.sections,
             [&](const ir::Section& section) { return main_.strings.at(section.name) == names[program]; });
}

ByLine<CarriedBlock> CarriedBlocks::collect(const ir::Program& program) const {
  ByLine<CarriedBlock> out;
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::block) continue;
    CarriedBlock carried = carried_by(program, program.blocks[statement.payload]);
    if (carried.empty()) continue;
    CarriedBlock& row = out.row(statement.line);
    // Places are lines: with G43 H1;G41 D2; it is not known which block is executed.
    if (!row.empty())
      row.lost.push_back(passes::computed("numbers of several blocks in one line"));
    else
      row = std::move(carried);
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
  for (const ir::Word& word : program.words_of(block)) {
    const Owner owner = owner_of(program, block, word.address);
    if (owner == Owner::function && counts_increments(program, word))
      carried.lost.push_back(passes::of_value(std::string(word.span.in(program.source.text())) +
                                              ", a value without a point that an M function takes,"));
    else if (owner == Owner::function)
      add_number(program, word, carried);
    if (owner == Owner::not_known)
      carried.lost.push_back(
          passes::not_known("whether the M function takes " + std::string(word.span.in(program.source.text()))));
  }
  if (semantics_.d_selects_edge || other_words) return carried;
  for (const ir::Word& word : program.words_of(block)) {
    if ((word.address == Address::h && h_is_length_) || word.address == Address::d) add_number(program, word, carried);
  }
  return carried;
}

}  // namespace dripfeed::compile
