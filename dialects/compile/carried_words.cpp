// A table says which function takes which words along.
#include "dialects/compile/carried_words.h"

#include <algorithm>
#include <array>

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;

enum class Carry : std::uint8_t {
  code,         // the code alone
  code_and_h,   // with the number of the length
  d_only,       // the number only: motions carry the code
  code_in_own,  // a block of its own, with the axes that were named, as increments of nothing
};
struct CarriedRow {
  Function function;
  Carry carry;
};
constexpr auto kRows = std::to_array<CarriedRow>({
    {Function::length_offset_plus, Carry::code_and_h},
    {Function::length_offset_minus, Carry::code_and_h},
    {Function::length_offset_off, Carry::code},
    {Function::comp_left, Carry::d_only},
    {Function::comp_right, Carry::d_only},
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

void add_number(const ir::Program& program, const ir::Block& block, Address address, CarriedWords& out) {
  for (const ir::Word& word : program.words_of(block)) {
    if (word.address != address || word.value == ir::ExpressionId::none) continue;
    const ir::Expression& value = program.at(word.value);
    if (value.op == ir::Operator::constant) out.words.push_back({address, value.value, ir::WordMode::as_modal});
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

const CarriedBlock* CarriedBlocks::at(std::uint32_t program, const std::vector<std::string>& names,
                                      std::uint32_t line) {
  auto known = programs_.find(program);
  if (known == programs_.end()) {
    const ir::Program* source = program == 0 ? &main_ : program < names.size() ? finder_.find(names[program]) : nullptr;
    known = programs_.emplace(program, source == nullptr ? ByLine{} : collect(*source)).first;
  }
  const auto found = known->second.find(line);
  return found == known->second.end() ? nullptr : &found->second;
}

CarriedBlocks::ByLine CarriedBlocks::collect(const ir::Program& program) const {
  ByLine out;
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::block) continue;
    const ir::Block& block = program.blocks[statement.payload];
    CarriedBlock carried;
    for (const ir::Code& code : program.codes_of(block)) {
      const auto row = std::ranges::find(kRows, code.function, &CarriedRow::function);
      if (row == kRows.end()) continue;
      switch (row->carry) {
        case Carry::code_and_h: add_number(program, block, Address::h, carried.attached); [[fallthrough]];
        case Carry::code: carried.attached.codes.push_back({code.function, code.argument}); break;
        case Carry::d_only:
          if (!d_selects_edge_) add_number(program, block, Address::d, carried.attached);
          break;
        case Carry::code_in_own:
          carried.alone.codes.push_back({code.function, code.argument});
          add_axes(program, block, carried.alone);
          break;
      }
    }
    if (!carried.attached.empty() || !carried.alone.empty()) out[statement.line] = std::move(carried);
  }
  return out;
}

}  // namespace dripfeed::compile
