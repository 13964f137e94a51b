// Places are followed in the order of the text from a change of the shift on, and forgotten where paths meet and where
// something else than a plain move stands.
#include "dialects/passes/shifted_increments.h"

#include <algorithm>
#include <array>
#include <optional>

#include "dialects/facts/block_values.h"
#include "dialects/facts/position_effects.h"
#include "dialects/facts/resolved.h"

namespace dripfeed::passes {

namespace {

using facts::Mode;
using facts::Number;
using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr std::size_t kAxes = 3;
constexpr std::array<Number, kAxes> kPlaces = {Number::x, Number::y, Number::z};
constexpr std::array<Number, kAxes> kShifts = {Number::shift_x, Number::shift_y, Number::shift_z};

std::optional<std::size_t> axis_of(Address a) {
  if (a < Address::x || a > Address::z) return std::nullopt;
  return static_cast<std::size_t>(a) - static_cast<std::size_t>(Address::x);
}
bool is_shift(const ir::Code& c) { return c.function == Function::local_shift && c.argument == 0; }
// It moves nothing, and changes nothing of what places count.
bool keeps_places(const ir::Code& c) {
  switch (c.group) {
    case ir::ModalGroup::distance:
    case ir::ModalGroup::feed:
    case ir::ModalGroup::spindle:
    case ir::ModalGroup::coolant: return true;
    case ir::ModalGroup::motion:
      return c.function == Function::rapid || c.function == Function::linear || c.function == Function::arc_cw ||
             c.function == Function::arc_ccw;
    default: return false;
  }
}

class ShiftedIncrements {
 public:
  ShiftedIncrements(ir::Program& program, const ir::Control& from)
      : program_(program), from_(from), flow_(program, from) {}

  void run() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      const bool is_read = s.kind == StatementKind::block || s.kind == StatementKind::empty;
      if (s.is_label || s.skip_level != 0 || !is_read) forget();
      if (s.kind == StatementKind::block) block(i, program_.blocks[s.payload]);
    }
  }

 private:
  void forget() {
    known_.fill(std::nullopt);
    open_.fill(false);
  }

  void block(std::uint32_t i, const ir::Block& block) {
    const std::span<const ir::Code> codes = program_.codes_of(block);
    if (std::ranges::any_of(codes, is_shift)) return shift(i, block);
    const bool moves =
        std::ranges::any_of(program_.words_of(block), [](const ir::Word& w) { return ir::is_axis(w.address); });
    const std::optional<facts::Facts> here = flow_.at(i);
    const bool is_plain = here && block.rest_level == 0 && std::ranges::all_of(codes, keeps_places) &&
                          (!moves || (*here)[Mode::cycle].is({.function = Function::cycle_off}));
    if (!is_plain) return forget();
    facts::Facts facts = *here;
    const facts::BlockValues values(program_, block, false);
    const facts::PositionEffects effects{from_, i, values, facts};
    for (std::uint32_t k = block.first_word; k < block.first_word + block.word_count; ++k)
      if (const auto axis = axis_of(program_.words[k].address)) move(effects, program_.words[k], *axis);
  }

  // By as much as the shift grows, the programmed place of an axis that stands gets less.
  void shift(std::uint32_t i, const ir::Block& block) {
    const facts::Facts* before = flow_.before(i);
    const bool may_be_skipped = block.rest_level != 0 || program_.statements[i].skip_level != 0;
    if (before == nullptr || may_be_skipped) return forget();
    const facts::Facts from = *before;
    const std::optional<facts::Facts> to = flow_.at(i);
    const bool is_alone = program_.codes_of(block).size() == 1;
    if (!to || !is_alone || !from[Mode::frame].is({.function = Function::none})) return forget();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (const double* place = from[kPlaces[axis]].certain(); place != nullptr) known_[axis] = *place;
      const double* old = from[kShifts[axis]].certain();
      const double* made = (*to)[kShifts[axis]].certain();
      if (old != nullptr && made != nullptr && *old == *made) continue;
      open_[axis] = true;
      if (old == nullptr || made == nullptr)
        known_[axis].reset();
      else if (known_[axis])
        *known_[axis] += *old - *made;
    }
  }

  void move(const facts::PositionEffects& effects, ir::Word& word, std::size_t axis) {
    const std::optional<double> value = effects.coordinate(word, kPlaces[axis]);
    const std::optional<bool> is_increment = effects.is_increment(word, {kPlaces[axis], false});
    std::optional<double>& known = known_[axis];
    if (!value || !is_increment)
      known.reset();
    else if (!*is_increment)
      known = value;
    else if (known)
      *known += *value;
    if (known && open_[axis] && *is_increment) {
      word.mode = ir::WordMode::absolute;
      word.value = program_.add_constant(*known, program_.at(word.value).span);
    }
    open_[axis] = open_[axis] && is_increment == true && !known;
  }

  ir::Program& program_;
  const ir::Control& from_;
  facts::Resolved flow_;
  std::array<std::optional<double>, kAxes> known_;  // where the axes stand, in the program's unit
  std::array<bool, kAxes> open_{};                  // the shift has changed since the axis was programmed
};

}  // namespace

void place_shifted_increments(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  const bool decides = to.semantics.machine_move == ir::MachineMove::without_frames &&
                       from.semantics.machine_move != ir::MachineMove::without_frames;
  const bool mills = from.kind == ir::MachineKind::mill && to.kind == ir::MachineKind::mill;
  if (!decides || !mills || std::ranges::none_of(program.codes, is_shift)) return;
  ShiftedIncrements(program, from).run();
}

}  // namespace dripfeed::passes
