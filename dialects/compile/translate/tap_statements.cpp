// One walk through the text. What a call says by numbers that the run does not show (an axis, pecks, a unit of its own,
// an angle of the spindle) must be written, and be nothing.
#include "dialects/compile/translate/tap_statements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

bool taps_along_z(const ir::Control& control) {
  return has_row(control, Function::drill, ir::drill_argument(ir::DrillCycle::tap_right, ir::kDrillAlongZ));
}
bool is_lathe_tap(const ir::Code& c) { return passes::is_tap(c) && c.argument >= ir::kDrillAlongZ; }

// Of G84 and G88: Q would be pecks, D a spindle.
bool is_of_tap(Address a) {
  return ir::is_axis(a) || a == Address::h || a == Address::r || a == Address::p || a == Address::f ||
         a == Address::k || a == Address::l || a == Address::s || a == Address::rounding;
}

class TapWalk {
 public:
  TapWalk(const ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to), out_(program.statements.size()) {}

  std::vector<TapStatement> run() {
    for (index_ = 0; index_ < program_.statements.size(); ++index_) {
      if (out_[index_].role != TapRole::none) continue;  // the retract of a tap
      if (from_.kind == ir::MachineKind::mill)
        mill();
      else
        ir::has_numbered_variables(from_) ? numbered() : named();
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] const ir::Statement& statement(std::uint32_t i) const { return program_.statements[i]; }
  [[nodiscard]] const ir::Block* block_at(std::uint32_t i) const {
    const bool any = i < program_.statements.size() && statement(i).kind == StatementKind::block;
    return any ? &program_.blocks[statement(i).payload] : nullptr;
  }
  template <class Test>
  [[nodiscard]] bool any_code(std::uint32_t i, Test&& test) const {
    const ir::Block* block = block_at(i);
    return block != nullptr && std::ranges::any_of(program_.codes_of(*block), test);
  }
  [[nodiscard]] bool moves(std::uint32_t i) const {
    const ir::Block* block = block_at(i);
    return block != nullptr && std::ranges::any_of(program_.words_of(*block), ir::is_axis, &ir::Word::address);
  }
  [[nodiscard]] std::optional<double> number(ir::ExpressionId id) const {
    if (id == ir::ExpressionId::none) return 0.0;
    const ir::Expression& e = program_.at(id);
    if (e.op == ir::Operator::constant) return e.value;
    if (e.op == ir::Operator::negate && program_.at(e.a).op == ir::Operator::constant) return -program_.at(e.a).value;
    return std::nullopt;
  }
  // The next statement that is something; none where a label is on the path.
  [[nodiscard]] std::uint32_t next_of(std::uint32_t i) const {
    for (++i; i < program_.statements.size(); ++i) {
      if (statement(i).is_label || statement(i).skip_level != 0) break;
      if (statement(i).kind != StatementKind::empty) return i;
    }
    return ir::kNoIndex;
  }

  // CYCLE84, CYCLE840 and G84 of mills are written elsewhere; G63 would become a plain feed.
  void mill() {
    if (any_code(index_, passes::is_floating_tap)) out_[index_] = {.role = TapRole::tap, .fault = "on a mill"};
  }

  // --- G84 and G88

  void numbered() {
    const ir::Block* block = block_at(index_);
    if (block == nullptr) return;
    if (any_code(index_, [&](const ir::Code& c) { return passes::announces_rigid_tap(c, from_); }))
      return announce(*block);
    bool names = false;
    for (const ir::Code& c : program_.codes_of(*block)) {
      if (c.group != ModalGroup::motion && c.group != ModalGroup::cycle && c.function != Function::cycle_off) continue;
      const bool after_another = taps_ && by_m29_;
      names = taps_ = is_foreign_tap(c);
      if (!taps_) continue;
      by_m29_ = announced_;
      shares_m29_ = after_another && !announced_;
      rigid_ = announced_ || passes::is_written_rigid(c.span.in(program_.source.text()));
      announced_ = false;
    }
    if (!taps_ || (!names && !moves(index_))) return;
    out_[index_] = {.role = TapRole::tap, .rigid = rigid_, .fault = fault_of(*block)};
    if (shares_m29_) out_[index_].fault = "that is a second one after one M29";
    if (astray_) out_[index_].fault = "in a program with M29 that does not stand right before its tap";
  }
  // M29.
  void announce(const ir::Block& block) {
    const std::uint32_t next = next_of(index_);
    const bool plain = statement(index_).skip_level == 0 && block.rest_level == 0;
    announced_ = plain && next != ir::kNoIndex && any_code(next, [&](const ir::Code& c) { return is_foreign_tap(c); });
    astray_ |= !announced_;
    if (announced_) out_[index_].role = TapRole::part;
  }
  [[nodiscard]] bool is_foreign_tap(const ir::Code& c) const {
    return is_lathe_tap(c) && !has_row(to_, c.function, c.argument);
  }

  [[nodiscard]] std::string fault_of(const ir::Block& block) const {
    for (const ir::Word& w : program_.words_of(block))
      if (!is_of_tap(w.address)) return "with the word " + std::string(w.span.in(program_.source.text()));
    return fault_of_codes(block);
  }
  // Which of the two comes first, the spindle or the tap, is not the same everywhere.
  [[nodiscard]] std::string fault_of_codes(const ir::Block& block) const {
    for (const ir::Code& c : program_.codes_of(block))
      if (c.group == ModalGroup::spindle || c.group == ModalGroup::surface_speed || c.group == ModalGroup::feed)
        return "with " + std::string(c.span.in(program_.source.text())) + " in the same block";
    return {};
  }

  // --- SINUMERIK

  void named() {
    const ir::Statement& s = statement(index_);
    switch (s.kind) {
      case StatementKind::call: return put_call(program_.calls[s.payload]);
      case StatementKind::modal_call:
        modal_ = tap_of(program_.calls[s.payload]);
        if (modal_ && s.skip_level != 0) modal_->fault = "that a switch may skip";
        if (modal_) out_[index_].role = TapRole::part;
        return;
      case StatementKind::modal_call_end:
        if (modal_) out_[index_].role = TapRole::part;
        if (modal_ && s.skip_level != 0)
          modal_->fault = "whose end a switch may skip";
        else
          modal_.reset();
        return;
      case StatementKind::block: return named_block();
      default: return;
    }
  }

  void put_call(const ir::Call& call) {
    if (std::optional<TapStatement> tap = tap_of(call)) out_[index_] = *std::move(tap);
  }

  [[nodiscard]] std::optional<TapStatement> tap_of(const ir::Call& call) const {
    if (call.computed != ir::ExpressionId::none) return std::nullopt;
    const bool taps = ir::is_called(call, ir::CalledSort::hole) && call.cycle->hole == ir::DrillCycle::tap_right;
    if (!taps) return std::nullopt;
    const bool rigid = !call.cycle->floats;
    return TapStatement{.role = TapRole::tap, .rigid = rigid, .own_speed = rigid, .fault = fault_of_call(call)};
  }

  [[nodiscard]] std::string fault_of_call(const ir::Call& call) const {
    if (!taps_along_z(to_)) return "on a lathe";
    using ir::CycleValue;
    const auto value = [&](CycleValue which) {
      const ir::ExpressionId id = ir::value_of(program_, call, which);
      return id == ir::ExpressionId::none ? std::optional(0.0) : number(id);
    };
    const std::optional<double> after = value(CycleValue::spindle_after);
    if (after != 3.0 && after != 4.0 && after != 5.0) return "without what its spindle does after it (SDAC)";
    if (value(CycleValue::spindle_angle) != 0.0) return "with an angle of its spindle";
    const std::optional<double> encoder = value(CycleValue::encoder);
    if (encoder != 0.0 && encoder != 1.0 && encoder != 20.0) return "with that use of its encoder (ENC)";
    if (!value(CycleValue::axis)) return "with a computed axis (AXN)";
    for (const ir::Argument& further : ir::arguments_after(program_, call, CycleValue::axis))
      if (further.value != ir::ExpressionId::none && number(further.value) != 0.0)
        return "with pecks or a unit of its own";
    return {};
  }

  void named_block() {
    if (modal_) {
      if (!moves(index_)) return;
      out_[index_] = *modal_;
      if (out_[index_].fault.empty()) out_[index_].fault = fault_of_codes(program_.blocks[statement(index_).payload]);
      return;
    }
    const auto goes_in = [](const ir::Code& c) { return c.function == Function::tap; };
    const auto goes_out = [](const ir::Code& c) { return c.function == Function::tap_retract; };
    if (any_code(index_, goes_in)) return pair({.role = TapRole::tap, .rigid = true, .needs_stop = true}, goes_out);
    if (any_code(index_, goes_out))
      out_[index_] = {.role = TapRole::tap, .rigid = true, .fault = "without G331 right before it"};
    if (any_code(index_, passes::is_floating_tap)) return pair({.role = TapRole::tap}, passes::is_floating_tap);
    if (orients()) mark_orientation();
  }

  // In and, right after it but for a dwell, out again.
  template <class Test>
  void pair(TapStatement in, Test&& goes_out) {
    std::uint32_t out = next_of(index_);
    std::uint32_t dwell = ir::kNoIndex;
    if (out != ir::kNoIndex && any_code(out, [](const ir::Code& c) { return c.function == Function::dwell; })) {
      dwell = out;
      out = next_of(out);
    }
    if (!taps_along_z(to_)) in.fault = "on this machine";
    const bool found = out != ir::kNoIndex && any_code(out, goes_out);
    if (in.fault.empty() && !found) in.fault = "without its retract in the next block";
    for (const std::uint32_t i : {index_, out})
      if (in.fault.empty()) in.fault = fault_of_pair(i);
    out_[index_] = std::move(in);
    if (!found) return;
    for (const std::uint32_t i : {dwell, out})
      if (i != ir::kNoIndex) out_[i] = {.role = TapRole::part, .owner = index_};
  }

  [[nodiscard]] std::string fault_of_pair(std::uint32_t i) const {
    const ir::Block& block = program_.blocks[statement(i).payload];
    if (block.rest_level != 0 || statement(i).skip_level != 0) return "that a switch may skip";
    for (const ir::Code& c : program_.codes_of(block)) {
      const bool own = c.function == Function::tap || c.function == Function::tap_retract ||
                       passes::is_floating_tap(c) || c.function == Function::spindle_cw ||
                       c.function == Function::spindle_ccw;
      if (!own) return "with " + std::string(c.span.in(program_.source.text())) + " in the same block";
    }
    for (const ir::Word& w : program_.words_of(block)) {
      const bool own = w.address == Address::x || w.address == Address::z || w.address == Address::f ||
                       w.address == Address::s || (w.address >= Address::i && w.address <= Address::k);
      if (!own) return "with the word " + std::string(w.span.in(program_.source.text()));
    }
    return {};
  }

  // SPOS=0, which brings the spindle to a stop under control of its position, or M19, alone in its block; the code
  // that stands for SPOS may be a block of its own.
  [[nodiscard]] bool orients() const { return is_orientation(index_) && !statement(index_).is_label; }
  [[nodiscard]] bool is_orientation(std::uint32_t i) const {
    const ir::Block* block = block_at(i);
    if (block == nullptr || block->rest_level != 0 || statement(i).skip_level != 0) return false;
    if (block->code_count + block->word_count == 0) return false;
    const auto turns_to_0 = [&](const ir::Word& w) {
      return w.address == Address::other && w.span.in(program_.source.text()).starts_with("SPOS=") &&
             number(w.value) == 0.0;
    };
    return std::ranges::all_of(program_.codes_of(*block),
                               [](const ir::Code& c) { return c.function == Function::spindle_orient; }) &&
           std::ranges::all_of(program_.words_of(*block), turns_to_0);
  }

  // Only rapids may lie between it and G331.
  void mark_orientation() {
    const auto is_rapid = [&](std::uint32_t i) {
      const ir::Block* block = block_at(i);
      return block != nullptr && moves(i) && std::ranges::all_of(program_.codes_of(*block), [](const ir::Code& c) {
               return c.function == Function::rapid;
             });
    };
    std::uint32_t i = index_;
    while (i != ir::kNoIndex && (is_orientation(i) || is_rapid(i))) i = next_of(i);
    if (i == ir::kNoIndex || !any_code(i, [](const ir::Code& c) { return c.function == Function::tap; })) return;
    if (taps_along_z(to_)) out_[index_].role = TapRole::orients;
  }

  const ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  std::vector<TapStatement> out_;
  std::uint32_t index_ = 0;
  bool announced_ = false;             // M29
  bool astray_ = false;                // … somewhere else
  bool taps_ = false;                  // G84 is in effect
  bool rigid_ = false;                 // … and was announced
  bool by_m29_ = false;                // … in that direction
  bool shares_m29_ = false;            // … which was stated before the tap before it
  std::optional<TapStatement> modal_;  // by MCALL
};

}  // namespace

std::vector<TapStatement> tap_statements(const ir::Program& program, const ir::Control& from, const ir::Control& to) {
  const bool both_named = !ir::has_numbered_variables(from) && !ir::has_numbered_variables(to);
  if (from.dialect == to.dialect || both_named) return std::vector<TapStatement>(program.statements.size());
  return TapWalk(program, from, to).run();
}

}  // namespace dripfeed::compile
