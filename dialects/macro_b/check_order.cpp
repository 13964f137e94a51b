// What is wrong only because of a block before. The blocks are looked at in the order of the text; behind a jump, a
// label or a call nothing is taken for certain.
#include <algorithm>
#include <string>

#include "dialects/macro_b/check.h"

namespace dripfeed::macro_b {

namespace {

using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

// Whether something is in effect.
enum class State : std::uint8_t { off, on, uncertain };

class OrderCheck {
 public:
  OrderCheck(const ir::Program& program, const ir::Control& control, Findings& findings)
      : program_(program), control_(control), findings_(findings) {}

  void statement(const ir::Statement& s) {
    if (s.is_label) forget();
    if (s.kind == StatementKind::block) {
      block(program_.blocks[s.payload]);
    } else if (s.kind == StatementKind::modal_call) {
      modal_ = State::on;
    } else if (s.kind == StatementKind::modal_call_end) {
      if (modal_ == State::off) add(modal_call_not_open, s.span, "G67");
      modal_ = State::off;
    } else if (s.kind == StatementKind::go_to || s.kind == StatementKind::call || s.kind == StatementKind::native ||
               s.kind == StatementKind::while_begin || s.kind == StatementKind::loop_begin) {
      forget();
    }
  }

 private:
  void forget() {
    modal_ = comp_ = cycle_ = State::uncertain;
    arc_ = starting_ = false;
  }

  // An error where the control has an alarm for it.
  void add(text::DiagnosticId id, text::Span span, std::string_view what) {
    text::Diagnostic* finding = findings_.add(id, span, {std::string(what)});
    if (finding != nullptr)
      finding->severity = finding->alarm.empty() ? text::Severity::warning : text::Severity::error;
  }
  [[nodiscard]] std::string_view written(const ir::Code& code) const { return text_of(program_, code.span); }

  void block(const ir::Block& block) {
    const ir::Code* comp = nullptr;
    bool own_words = false;
    for (const ir::Code& code : program_.codes_of(block)) {
      const Function f = code.function;
      if (code.number != ir::ExpressionId::none) return forget();
      if (code.group == ir::ModalGroup::motion) arc_ = f == Function::arc_cw || f == Function::arc_ccw;
      if (code.group == ir::ModalGroup::motion || f == Function::cycle_off) cycle_ = State::off;
      if (f == Function::drill) cycle_ = State::on;
      own_words |= code.group == ir::ModalGroup::non_modal;
      if (f == Function::reference_return && cycle_ == State::on) add(reference_in_cycle, code.span, written(code));
      const bool plane = code.group == ir::ModalGroup::plane;
      if (plane && comp_ == State::on && plane_ != f && plane_ != Function::none)
        add(plane_changed_in_comp, code.span, written(code));
      if (plane) plane_ = f;
      if (f == Function::comp_left || f == Function::comp_right || f == Function::comp_off) comp = &code;
    }
    const bool moves = !own_words && std::ranges::any_of(program_.words_of(block), [&](const ir::Word& w) {
      return is_axis(control_, w.address);
    });
    if (comp != nullptr) {
      const State wanted = comp->function == Function::comp_off ? State::off : State::on;
      // Changing sides is no start.
      starting_ = comp_ != State::uncertain && comp_ != wanted;
      comp_ = wanted;
      comp_span_ = comp->span;
    }
    if (!moves || !starting_) return;
    if (arc_) add(comp_started_by_arc, comp_span_, comp_ == State::on ? "starts" : "ends");
    starting_ = false;
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  // At the start nothing is in effect.
  State modal_ = State::off;
  State comp_ = State::off;
  State cycle_ = State::off;
  Function plane_ = Function::none;
  bool arc_ = false;
  bool starting_ = false;  // compensation changes with the next move
  text::Span comp_span_;
};

}  // namespace

void check_order(const ir::Program& program, const ir::Control& control, const Section& section, Findings& findings) {
  if (section.is_subprogram) return;  // what is in effect is its caller's
  OrderCheck check(program, control, findings);
  for (std::uint32_t i = section.first; i < section.last; ++i) check.statement(program.statements[i]);
}

}  // namespace dripfeed::macro_b
