// Compensation in the order of the text: it starts and ends on a straight move and keeps its plane. At the start of a
// subprogram, behind a label, a jump, a call or a native statement of unknown effect nothing is taken for certain. And
// M functions that the machine's list does not have.
#include <algorithm>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

class Compensation {
 public:
  explicit Compensation(const Check& check) : check_(check) {}

  void run() {
    if (may_have_caller(check_.program)) forget();
    for (const ir::Statement& s : check_.program.statements) {
      const bool others = s.kind == StatementKind::call || s.kind == StatementKind::modal_call ||
                          s.kind == StatementKind::go_to || ir::is_structure(s.kind) ||
                          (s.kind == StatementKind::native && !check_.program.natives[s.payload].effects_known);
      if (others || s.is_label) forget();
      const bool still = s.kind == StatementKind::assign || s.kind == StatementKind::message ||
                         (s.kind == StatementKind::block && !block(check_.block_of(s)));
      if (still) without_move(s);
    }
  }

 private:
  enum class State : std::uint8_t { off, on, uncertain };

  void forget() {
    state_ = State::uncertain;
    changes_ = {};
    arc_known_ = false;
    without_moves_ = 0;
    moved_ = true;
    plane_ = Function::none;
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
    if (arc_ && arc_known_) {
      const bool ends = state_ == State::off;
      const auto detail = ends ? ir::AlarmDetail::ends : ir::AlarmDetail::none;
      check_.report(DiagnosticId::comp_started_by_arc, changes_, {ends ? "ends" : "starts"}).alarm =
          ir::alarm_of(check_.control, DiagnosticId::comp_started_by_arc, detail);
    }
    changes_ = {};
    return true;
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
    if (state_ != State::on || s.line == without_line_) return;
    without_line_ = s.line;
    if (++without_moves_ != kMostWithoutMove + 1) return;
    text::Diagnostic& d = check_.report(
        DiagnosticId::code_not_in_mode, s.span,
        {"block " + std::to_string(without_moves_) + " in a row without a move in the plane", "compensation"});
    d.severity = text::Severity::warning;
    d.alarm = "10762";
  }

  void take(const ir::Code& code) {
    const Function f = code.function;
    if (code.group == ir::ModalGroup::motion) {
      arc_ = f == Function::arc_cw || f == Function::arc_ccw || f == Function::arc_via || f == Function::arc_tangent;
      arc_known_ = true;
    }
    if (code.group == ir::ModalGroup::plane) plane(code);
    if (f != Function::comp_left && f != Function::comp_right && f != Function::comp_off) return;
    const State wanted = f == Function::comp_off ? State::off : State::on;
    changes_ = state_ != State::uncertain && state_ != wanted ? code.span : text::Span{};
    state_ = wanted;
  }

  void plane(const ir::Code& code) {
    const bool changes = plane_ != Function::none && plane_ != code.function;
    if (changes && state_ == State::on)
      check_.report(DiagnosticId::plane_changed_in_comp, code.span, {std::string(check_.text_of(code.span))});
    plane_ = code.function;
  }

  const Check& check_;
  State state_ = State::off;
  text::Span changes_;  // G40, G41 or G42 that waits for its move
  bool arc_ = false;    // the motion code
  bool arc_known_ = false;
  Function plane_ = Function::none;
  bool moved_ = false;
  std::uint32_t without_moves_ = 0;  // blocks since the last one that moves
  std::uint32_t without_line_ = 0;
};

void check_machine_functions(const Check& check) {
  const auto& list = check.control.machine_functions;
  if (list.empty()) return;
  for (const ir::Code& code : check.program.codes) {
    if (code.function != Function::machine_function || code.number != ir::ExpressionId::none) continue;
    if (std::ranges::find(list, code.argument) == list.end())
      check.report(DiagnosticId::unknown_machine_function, code.span, {"M" + std::to_string(code.argument)});
  }
}

}  // namespace

void check_order(const Check& check) {
  Compensation(check).run();
  check_machine_functions(check);
}

}  // namespace dripfeed::sinumerik
