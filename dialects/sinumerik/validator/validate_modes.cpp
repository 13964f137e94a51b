// Compensation: it starts and ends on a straight move and keeps its plane. What is in effect is known on all paths;
// what waits for the next move is looked at in the order of the text, and given up after a label, a jump, a call or a
// native statement of unknown effect. And M functions that the machine's list does not have.
#include <algorithm>

#include "dialects/facts/calls.h"
#include "dialects/facts/in_effect.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using facts::Mode;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

class Compensation {
 public:
  Compensation(const Check& check, const facts::Resolved& facts)
      : check_(check),
        in_effect_(check.program, facts, !may_have_caller(check.program)),
        moved_(may_have_caller(check.program)) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = check_.program.statements[at];
    const bool others = facts::is_call(s.kind) || s.kind == StatementKind::go_to || ir::is_structure(s.kind) ||
                        (s.kind == StatementKind::native && !check_.program.natives[s.payload].effects_known);
    if (others || s.is_label) forget();
    const bool still = s.kind == StatementKind::assign || s.kind == StatementKind::message;
    if (!still && s.kind != StatementKind::block) return;
    in_effect_.at(at);
    if (still || !block(check_.block_of(s))) without_move(s);
  }

 private:
  using State = facts::State;

  // What waits for the next move is not looked for on another path.
  void forget() {
    changes_ = {};
    without_moves_ = 0;
    moved_ = true;
  }

  // Whether it moves an axis.
  bool block(const ir::Block& block) {
    bool own_words = false;
    for (const ir::Code& code : check_.program.codes_of(block)) {
      if (code.number != ir::ExpressionId::none) {
        forget();
        return true;
      }
      own_words |= code.group == ir::ModalGroup::non_modal || code.group == ir::ModalGroup::frame;
      take(code);
    }
    const bool moves = !own_words && std::ranges::any_of(check_.program.words_of(block), [](const ir::Word& w) {
      return w.address >= ir::Address::x && w.address <= ir::Address::z;
    });
    tangent(block, moves);
    if (moves) without_moves_ = 0;
    if (!moves || changes_.empty()) return moves;
    if (is_arc()) {
      const bool ends = compensation() == State::off;
      const auto detail = ends ? ir::AlarmDetail::ends : ir::AlarmDetail::none;
      check_.report(DiagnosticId::comp_started_by_arc, changes_, {ends ? "ends" : "starts"}).alarm =
          ir::alarm_of(check_.control, DiagnosticId::comp_started_by_arc, detail);
    }
    changes_ = {};
    return true;
  }

  [[nodiscard]] State compensation() const { return in_effect_.state_against(Mode::compensation, Function::comp_off); }
  [[nodiscard]] bool is_arc() const {
    constexpr Function kArcs[] = {Function::arc_cw, Function::arc_ccw, Function::arc_via, Function::arc_tangent};
    const std::optional<facts::Setting> motion = in_effect_.stated(Mode::motion);
    return motion && std::ranges::find(kArcs, motion->function) != std::end(kArcs);
  }

  // CT before anything has moved has no direction to go on in (14045).
  void tangent(const ir::Block& block, bool moves) {
    const auto codes = check_.program.codes_of(block);
    const auto arc = std::ranges::find(codes, Function::arc_tangent, &ir::Code::function);
    if (arc != codes.end() && moves && !moved_)
      check_
          .report(DiagnosticId::curve_invalid, arc->span,
                  {std::string(check_.text_of(arc->span)) + " has no move before it whose direction it continues"})
          .alarm = "14045";
    moved_ |= moves;
  }

  // How many blocks without a move it looks over is a machine datum (MD20250), 3 as delivered; so a warning.
  void without_move(const ir::Statement& s) {
    constexpr std::uint32_t kMostWithoutMove = 3;
    if (compensation() != State::on || s.line == without_line_) return;
    without_line_ = s.line;
    if (++without_moves_ != kMostWithoutMove + 1) return;
    text::Diagnostic& d = check_.report(
        DiagnosticId::code_not_in_mode, s.span,
        {"block " + std::to_string(without_moves_) + " in a row without a move in the plane", "compensation"});
    d.severity = text::Severity::warning;
    d.alarm = "10762";
  }

  void take(const ir::Code& code) {
    const std::optional<facts::Setting> plane = in_effect_.stated(Mode::plane);
    const State before = compensation();
    in_effect_.take(code);
    const bool changes_plane = code.group == ir::ModalGroup::plane && plane && plane->function != code.function;
    if (changes_plane && before == State::on)
      check_.report(DiagnosticId::plane_changed_in_comp, code.span, {std::string(check_.text_of(code.span))});
    if (facts::mode_of(code) != Mode::compensation) return;
    changes_ = before != State::uncertain && before != compensation() ? code.span : text::Span{};
  }

  const Check& check_;
  facts::InEffect in_effect_;
  text::Span changes_;  // G40, G41 or G42 that waits for its move
  bool moved_;
  std::uint32_t without_moves_ = 0;  // blocks since the last one that moves
  std::uint32_t without_line_ = 0;
};

}  // namespace

void check_machine_functions(const Check& check) {
  const auto& list = check.control.machine_functions;
  if (list.empty()) return;
  for (const ir::Code& code : check.program.codes) {
    if (code.function != Function::machine_function || code.number != ir::ExpressionId::none) continue;
    if (std::ranges::find(list, code.argument) == list.end())
      check.report(DiagnosticId::unknown_machine_function, code.span, {"M" + std::to_string(code.argument)});
  }
}

StatementCheck compensation_check(const Check& check, const facts::Resolved& facts) {
  return [compensation = Compensation(check, facts)](std::uint32_t i) mutable { compensation.statement(i); };
}

}  // namespace dripfeed::sinumerik
