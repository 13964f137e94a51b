// What a main program leaves to the state in which the machine happens to be: motion code, unit, feed mode, distance
// mode, plane, feed. The blocks are taken in the order of the text; after a call or a native statement of unknown
// effect anything may have been stated, and nothing more is said. Diameter programming is followed in subprograms as
// well.
#include <algorithm>

#include "dialects/sinumerik/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

bool is_linear_axis(ir::Address a) { return a >= ir::Address::u && a <= ir::Address::z; }
bool is_axis(ir::Address a) { return a <= ir::Address::c || is_linear_axis(a); }

class ModalState {
 public:
  explicit ModalState(const Check& check)
      : check_(check), inherits_(is_subprogram(check.program)), known_(check.control.semantics.power_on_known) {}

  void run() {
    for (const ir::Statement& s : check_.program.statements) {
      if (s.kind == StatementKind::call) inherits_ = true;
      if (s.kind == StatementKind::native && !check_.program.natives[s.payload].effects_known) inherits_ = true;
      if (s.kind == StatementKind::block) block(check_.block_of(s), s);
    }
  }

 private:
  void block(const ir::Block& block, const ir::Statement& s) {
    machine_coordinates_ = false;
    words_are_no_move_ = false;
    for (const ir::Code& code : check_.program.codes_of(block)) take(code);
    for (const ir::Word& word : check_.program.words_of(block))
      if (word.address == ir::Address::f && !words_are_no_move_)
        feed_span_ = feed_span_.empty() ? word.span : feed_span_;
    if (!words_are_no_move_) moves(block, s);
  }

  void take(const ir::Code& code) {
    switch (code.function) {
      case Function::rapid:
        cuts_ = false;
        motion_ = true;
        return;
      case Function::linear:
        cuts_ = true;
        motion_ = true;
        return;
      case Function::arc_cw:
      case Function::arc_ccw:
        cuts_ = true;
        motion_ = true;
        plane_needed(code.span);
        return;
      case Function::thread:
        cuts_ = false;
        motion_ = true;
        return;
      case Function::comp_left:
      case Function::comp_right: plane_needed(code.span); return;
      case Function::plane_xy:
      case Function::plane_zx:
      case Function::plane_yz: plane_ = true; return;
      case Function::unit_inch:
      case Function::unit_mm: unit_ = true; return;
      case Function::absolute:
        distance_ = true;
        incremental_ = false;
        return;
      case Function::incremental:
        distance_ = true;
        incremental_ = true;
        return;
      case Function::feed_per_min:
      case Function::feed_per_rev:
      case Function::feed_inverse_time: feed_mode_ = true; return;
      case Function::diameter_on: doubles_ = true; return;
      case Function::diameter_off:
      case Function::diameter_absolute_only: doubles_ = false; return;
      case Function::dwell:
      case Function::local_shift:
      case Function::local_shift_add:
      case Function::set_coordinates: words_are_no_move_ = true; return;
      case Function::machine_coordinates: machine_coordinates_ = true; return;
      case Function::not_modelled:
        // CIP, splines: a motion, of which only that it is one is known.
        if (code.group == ir::ModalGroup::motion) {
          motion_ = true;
          cuts_ = false;
        }
        if (code.group == ir::ModalGroup::feed) feed_mode_ = true;
        return;
      case Function::none:
      case Function::exact_stop_once:
      case Function::exact_stop_mode:
      case Function::continuous_path:
      case Function::work_offset:
      case Function::reference_return:
      case Function::comp_off:
      case Function::length_offset_plus:
      case Function::length_offset_minus:
      case Function::length_offset_off:
      case Function::tool_change:
      case Function::surface_speed_on:
      case Function::surface_speed_off:
      case Function::spindle_cw:
      case Function::spindle_ccw:
      case Function::spindle_stop:
      case Function::spindle_orient:
      case Function::coolant_mist:
      case Function::coolant_flood:
      case Function::coolant_off:
      case Function::program_stop:
      case Function::optional_stop:
      case Function::program_end:
      case Function::program_end_rewind:
      case Function::subprogram_end:
      case Function::cycle_off:
      case Function::return_to_initial:
      case Function::return_to_r:
      case Function::no_effect:
      case Function::machine_function:
      case Function::count_: return;
    }
  }

  void moves(const ir::Block& block, const ir::Statement& s) {
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (!is_axis(word.address)) continue;
      diameter(word);
      if (inherits_) continue;
      once(motion_, DiagnosticId::motion_without_code, word.span, axis_name(word));
      if (is_linear_axis(word.address)) once(unit_, DiagnosticId::unit_not_stated, s.span);
      if (word.mode == ir::WordMode::as_modal && !machine_coordinates_)
        once(distance_, DiagnosticId::distance_mode_not_stated, s.span);
      if (cuts_) feed(s);
    }
  }

  void feed(const ir::Statement& s) {
    if (feed_span_.empty()) {
      check_.report(DiagnosticId::no_feed, s.span);
      feed_span_ = s.span;  // said once
      feed_mode_ = true;
    }
    if (!feed_mode_)
      once(feed_mode_, DiagnosticId::feed_mode_not_stated, feed_span_, std::string(check_.text_of(feed_span_)));
  }

  void plane_needed(text::Span span) {
    if (!inherits_) once(plane_, DiagnosticId::plane_not_stated, span);
  }

  void once(bool& stated, DiagnosticId id, text::Span span, std::string argument = {}) {
    if (stated) return;
    stated = true;
    if (known_) return;  // the profile says in which state the machine starts
    std::vector<std::string> arguments;
    if (!argument.empty()) arguments.push_back(std::move(argument));
    check_.report_if_machine(id, span, std::move(arguments));
  }

  // DIAMON takes increments of X as diameters: X=RETR with a radius in it goes half as far. DIAM90 does not.
  void diameter(const ir::Word& word) {
    if (!doubles_ || word.address != ir::Address::x) return;
    const bool incremental =
        word.mode == ir::WordMode::incremental || (word.mode == ir::WordMode::as_modal && incremental_);
    const ir::Expression& value = check_.program.at(word.value);
    if (incremental && !(value.op == ir::Operator::constant && value.value == 0.0))
      check_.report(DiagnosticId::diameter_doubles_increment, word.span, {"X"});
  }

  static std::string axis_name(const ir::Word& word) {
    return std::string(1, static_cast<char>('A' + static_cast<int>(word.address)));
  }

  const Check& check_;
  bool inherits_;
  bool known_;
  bool motion_ = false;
  bool cuts_ = false;
  bool unit_ = false;
  bool distance_ = false;
  bool feed_mode_ = false;
  bool plane_ = false;
  bool incremental_ = false;
  bool doubles_ = false;  // DIAMON was stated
  bool machine_coordinates_ = false;
  bool words_are_no_move_ = false;
  text::Span feed_span_;  // the first F
};

}  // namespace

void check_modal_state(const Check& check) { ModalState(check).run(); }

}  // namespace dripfeed::sinumerik
