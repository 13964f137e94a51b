// What is still in effect where it should have ended, and cuts without a turning spindle: taken in the order of the
// text, and given up at whatever may have changed it unseen - labels, jumps, structures, calls, what is not read.
#include <algorithm>
#include <string>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

enum class Spindle : std::uint8_t { unknown, stands, turns };

class Leftovers {
 public:
  explicit Leftovers(const Check& check)
      : check_(check),
        is_main_(!may_have_caller(check.program)),
        spindle_(is_main_ ? Spindle::stands : Spindle::unknown),
        has_speed_(!is_main_),
        has_limit_(!is_main_) {}

  void run() {
    const auto& statements = check_.program.statements;
    for (std::size_t i = 0; i < statements.size(); ++i) {
      const ir::Statement& s = statements[i];
      if (s.is_label || s.kind == StatementKind::go_to || ir::is_structure(s.kind)) forget_branches();
      has_jumped_ = has_jumped_ || s.kind == StatementKind::go_to;
      take(s, i + 1 < statements.size() ? &statements[i + 1] : nullptr);
    }
  }

 private:
  void take(const ir::Statement& s, const ir::Statement* next) {
    if (s.kind == StatementKind::block) return block(check_.block_of(s));
    if (s.kind == StatementKind::program_end) return end(s.span, is_main_);
    if (s.kind == StatementKind::call) return forget_all();
    if (s.kind == StatementKind::native) return native(s);
    if (s.kind == StatementKind::modal_call) {
      modal_ = check_.program.calls[s.payload].name == ir::StringId::none
                   ? std::string("a modal call")
                   : "MCALL " + std::string(check_.program.strings.at(check_.program.calls[s.payload].name));
      return forget_spindle();
    }
    if (s.kind != StatementKind::modal_call_end) return;
    // A cycle that is not read stands behind its MCALL in the same line.
    const bool with_cycle = next != nullptr && next->kind == StatementKind::native && next->line == s.line;
    modal_ = with_cycle ? "MCALL " + std::string(check_.native_name(*next)) : std::string();
  }

  void native(const ir::Statement& s) {
    if (check_.program.natives[s.payload].effects_known) return;
    const std::string modal = modal_.ends_with(check_.native_name(s)) ? modal_ : std::string();
    forget_all();
    modal_ = modal;
  }

  void forget_spindle() {
    spindle_ = Spindle::unknown;
    has_speed_ = has_limit_ = true;
  }
  // Another path may lead here. Before the first jump none can have led past blocks that stand behind.
  void forget_branches() {
    if (spindle_ == Spindle::stands && (has_turned_ || has_jumped_)) spindle_ = Spindle::unknown;
    compensation_ = modal_ = {};
  }
  void forget_all() {
    forget_spindle();
    compensation_ = modal_ = {};
  }

  void block(const ir::Block& block) {
    bool cuts = false;
    bool changes_tool = false;
    text::Span surface;
    for (const ir::Code& code : check_.program.codes_of(block)) {
      take(code);
      changes_tool = changes_tool || code.function == Function::tool_change;
      if (code.function == Function::surface_speed_on) surface = code.span;
      if (code.function == Function::tool_change) end(code.span, true);
    }
    for (const ir::Word& word : check_.program.words_of(block)) {
      has_speed_ = has_speed_ || word.address == ir::Address::s;
      has_limit_ = has_limit_ || word.address == ir::Address::spindle_limit || is_other_limit(word);
      cuts = cuts || ir::is_linear_axis(word.address);
      const bool calls_tool = word.address == ir::Address::t && check_.control.kind == ir::MachineKind::lathe;
      if (calls_tool && !changes_tool) end(word.span, true);
    }
    if (!surface.empty() && !has_limit_) {
      has_limit_ = true;
      text::Diagnostic& d =
          check_.report(DiagnosticId::surface_speed_unlimited, surface, {"ever more", "0", "not known"});
      d.notes.push_back({surface, "a limit of the machine (G26, setting data) may hold"});
    }
    if (cuts && !own_words(block)) cut(block);
  }

  // LIMS[2]=…
  [[nodiscard]] bool is_other_limit(const ir::Word& word) const {
    return word.address == ir::Address::other && check_.program.strings.at(word.name).starts_with("LIMS");
  }

  // Words of a frame, of G4, of an axis by itself: no motion of the path.
  [[nodiscard]] bool own_words(const ir::Block& block) const {
    return std::ranges::any_of(check_.program.codes_of(block), [](const ir::Code& code) {
      return code.group == ir::ModalGroup::non_modal || code.group == ir::ModalGroup::frame;
    });
  }

  void take(const ir::Code& code) {
    const Function f = code.function;
    if (code.group == ir::ModalGroup::motion) motion_ = f;
    if (code.group == ir::ModalGroup::spindle || f == Function::spindle_orient) spindle(f);
    if (f == Function::comp_left || f == Function::comp_right) compensation_ = std::string(check_.text_of(code.span));
    if (f == Function::comp_off) compensation_ = {};
    // M functions of the machine may start a spindle; so may what is not read.
    if (f == Function::machine_function || f == Function::not_modelled) forget_spindle();
    if (code.number != ir::ExpressionId::none) forget_all();
  }

  void spindle(Function f) {
    const bool turns = f == Function::spindle_cw || f == Function::spindle_ccw;
    spindle_ = turns ? Spindle::turns : f == Function::spindle_stop ? Spindle::stands : Spindle::unknown;
    has_turned_ = has_turned_ || spindle_ != Spindle::unknown;
  }

  void cut(const ir::Block& block) {
    const bool taps = motion_ == Function::tap;
    constexpr Function kCuts[] = {Function::linear, Function::arc_cw,     Function::arc_ccw,
                                  Function::thread, Function::arc_via,    Function::arc_tangent,
                                  Function::spline, Function::polynomial, Function::thread_changing};
    const text::Span span = span_of(block);
    if (taps && !has_speed_) {
      has_speed_ = true;
      check_.report(DiagnosticId::tap_without_speed, span, {"G331"}).severity = text::Severity::warning;
    }
    if (spindle_ != Spindle::stands || std::ranges::find(kCuts, motion_) == std::end(kCuts)) return;
    spindle_ = Spindle::unknown;  // said once
    check_.report(DiagnosticId::spindle_not_turning, span);
  }

  [[nodiscard]] text::Span span_of(const ir::Block& block) const {
    const auto codes = check_.program.codes_of(block);
    const auto words = check_.program.words_of(block);
    return codes.empty() ? words.front().span : codes.front().span;
  }

  // A tool is changed, or the program ends.
  void end(text::Span span, bool wanted) {
    for (std::string* left : {&modal_, &compensation_}) {
      if (wanted && !left->empty())
        check_.report(DiagnosticId::code_not_in_mode, span, {std::string(check_.text_of(span)), *left}).severity =
            text::Severity::warning;
      left->clear();
    }
  }

  const Check& check_;
  bool is_main_;
  Spindle spindle_;
  bool has_turned_ = false;  // a block of the text started or stopped it
  bool has_jumped_ = false;
  bool has_speed_;
  bool has_limit_;
  Function motion_ = Function::rapid;
  std::string modal_;         // the modal call in effect, as it is written; empty: none
  std::string compensation_;  // G41 or G42 in effect
};

}  // namespace

void check_leftovers(const Check& check) { Leftovers(check).run(); }

}  // namespace dripfeed::sinumerik
