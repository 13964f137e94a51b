// Which axes a block names: more at once than the control moves, two of one direction in the choice of a plane, an arc
// whose axis lies outside its plane, and axes given by their number.
#include <algorithm>
#include <array>
#include <bitset>
#include <optional>
#include <string>

#include "dialects/facts/in_effect.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using facts::State;
using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;
using enum text::DiagnosticId;

struct AxisRow {
  Address axis;
  Address increment;  // the letter that means its increment on some lathes, a parallel axis elsewhere
  Address center;
};
constexpr std::array kAxes = {AxisRow{Address::x, Address::u, Address::i}, AxisRow{Address::y, Address::v, Address::j},
                              AxisRow{Address::z, Address::w, Address::k}};

// The axis of kAxes that a plane does not have.
std::size_t outside(Function plane) { return plane == Function::plane_xy ? 2 : plane == Function::plane_zx ? 1 : 0; }

class AxesCheck {
 public:
  AxesCheck(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts, Findings& findings)
      : program_(program), control_(control), findings_(findings), in_effect_(program, facts) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind != StatementKind::block) return;
    in_effect_.at(at);
    block(program_.blocks[s.payload], s.span);
  }

 private:
  void block(const ir::Block& block, text::Span span) {
    bool own_words = false;
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.number != ir::ExpressionId::none) return;
      own_words |= code.group == ModalGroup::frame || (code.group == ModalGroup::non_modal && !moves(code.function));
      in_effect_.take(code);
      if (code.group == ModalGroup::plane) one_of_each_direction(block);
      if (code.function == Function::surface_speed_on) surface_axis(block);
    }
    if (own_words) return;
    at_once(block, span);
    if (has_centre(block) && is_arc()) in_plane(block);
  }

  // The block's codes have taken effect. A motion code ends a cycle.
  [[nodiscard]] bool is_arc() const {
    const std::optional<facts::Setting> motion = in_effect_.certain(facts::Mode::motion);
    const bool is_arc = motion && (motion->function == Function::arc_cw || motion->function == Function::arc_ccw);
    return is_arc && (in_effect_.is_stated_here(facts::Mode::motion) ||
                      in_effect_.state_against(facts::Mode::cycle, Function::cycle_off) == State::off);
  }
  [[nodiscard]] bool has_centre(const ir::Block& block) const {
    return std::ranges::any_of(kAxes, [&](const AxisRow& row) { return find(block, row.center) != nullptr; });
  }

  static bool moves(Function f) {
    return f == Function::machine_coordinates || f == Function::exact_stop_once || f == Function::reference_return ||
           f == Function::leave_reference || f == Function::approach || f == Function::skip_move;
  }

  void at_once(const ir::Block& block, text::Span span) {
    const std::uint32_t most = control_.limits.axes_at_once;
    if (most == 0) return;
    std::bitset<26> named;
    for (const ir::Word& word : program_.words_of(block)) {
      if (!is_axis(control_, word.address)) continue;
      Address address = word.address;
      if (control_.semantics.incremental_letters_uvw)
        for (const AxisRow& row : kAxes)
          if (row.increment == address) address = row.axis;
      named.set(static_cast<std::size_t>(letter_of(address) - 'A'));
    }
    if (named.count() > most) findings_.add(too_many_axes, span, {std::to_string(named.count()), std::to_string(most)});
  }

  // G17 G02 X10. Z-5. I5. K0.: a centre and an end on the axis that the plane does not have, and none on one that it
  // has. A helix names both axes of the plane, or neither's partner by K.
  void in_plane(const ir::Block& block) {
    const std::optional<facts::Setting> plane = in_effect_.stated(facts::Mode::plane);
    if (!plane) return;
    const std::size_t out = outside(plane->function);
    const auto names_axis = [&](const AxisRow& row) { return find(block, row.axis) || named_by_increment(block, row); };
    const ir::Word* wrong = find(block, kAxes[out].axis);
    if (wrong == nullptr || find(block, kAxes[out].center) == nullptr) return;
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      if (i == out || names_axis(kAxes[i]) || find(block, kAxes[i].center) != nullptr) continue;
      findings_.add(axis_not_in_plane, wrong->span,
                    {std::string(1, letter_of(wrong->address)), std::string(in_effect_.written(facts::Mode::plane))});
      return;
    }
  }
  [[nodiscard]] bool named_by_increment(const ir::Block& block, const AxisRow& row) const {
    return control_.semantics.incremental_letters_uvw && find(block, row.increment) != nullptr;
  }

  // G17 X U: the plane would have two axes of one direction.
  void one_of_each_direction(const ir::Block& block) {
    if (control_.semantics.incremental_letters_uvw) return;
    for (const AxisRow& row : kAxes) {
      const ir::Word* basic = find(block, row.axis);
      const ir::Word* parallel = find(block, row.increment);
      if (basic == nullptr || parallel == nullptr || !is_axis(control_, row.increment)) continue;
      findings_.add_own(addresses_exclude, parallel->span,
                        {std::string(text_of(program_, basic->span)), std::string(text_of(program_, parallel->span))},
                        ir::AlarmDetail::parallel_axes);
    }
  }

  // G96 P2: by the second axis. Only a named machine says how many it has.
  void surface_axis(const ir::Block& block) {
    const ir::Word* p = find(block, Address::p);
    if (p == nullptr || p->value == ir::ExpressionId::none || !control_.from_profile) return;
    const ir::Expression& value = program_.at(p->value);
    const auto last = static_cast<double>(control_.axes.size());
    if (value.op != ir::Operator::constant || (value.value >= 0.0 && value.value <= last)) return;
    findings_.add(value_out_of_range, p->span,
                  {"P", std::string(text_of(program_, value.span)), "0", text::format_shortest(last)},
                  ir::AlarmDetail::surface_axis);
  }

  [[nodiscard]] const ir::Word* find(const ir::Block& block, Address address) const {
    const auto words = program_.words_of(block);
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    return word == words.end() ? nullptr : &*word;
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  facts::InEffect in_effect_;
};

}  // namespace

StatementCheck axes_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                          Findings& findings) {
  return [check = AxesCheck(program, control, facts, findings)](std::uint32_t i) mutable { check.statement(i); };
}

}  // namespace dripfeed::macro_b
