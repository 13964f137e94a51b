// What a main program leaves to the state in which the machine happens to be: motion code, unit, feed mode, distance
// mode, plane, feed. The blocks are taken in the order of the text; after a call or a native statement of unknown
// effect anything may have been stated, and nothing more is said. Diameter programming is followed in subprograms as
// well.
#include <algorithm>
#include <span>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

class ModalState {
 public:
  explicit ModalState(const Check& check)
      : check_(check), inherits_(may_have_caller(check.program)), known_(check.control.semantics.power_on_known) {}

  void run() {
    for (const ir::Statement& s : check_.program.statements) {
      if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) inherits_ = true;
      if (s.kind == StatementKind::native && !check_.program.natives[s.payload].effects_known) inherits_ = true;
      if (s.kind == StatementKind::block) block(check_.block_of(s), s);
    }
  }

 private:
  void block(const ir::Block& block, const ir::Statement& s) {
    machine_coordinates_ = false;
    words_are_no_move_ = false;
    for (const ir::Code& code : check_.program.codes_of(block)) {
      if (code.function == Function::rapid && code.group == ir::ModalGroup::non_modal) return;  // POS
      take(code);
    }
    has_feed_ = false;
    for (const ir::Word& word : check_.program.words_of(block)) {
      if ((word.address != ir::Address::f && word.address != ir::Address::block_feed) || words_are_no_move_) continue;
      has_feed_ = true;
      feed_span_ = feed_span_.empty() ? word.span : feed_span_;
    }
    if (!words_are_no_move_) moves(block, s);
  }

  // What a code states; codes without a row state nothing that is followed here.
  using Statement = void (*)(ModalState&, const ir::Code&);
  struct Row {
    Function function;
    Statement state;
  };
  static std::span<const Row> rows();

  void take(const ir::Code& code) {
    const auto row = std::ranges::find(rows(), code.function, &Row::function);
    if (row != rows().end()) row->state(*this, code);
  }

  void move(bool cuts) {
    motion_ = true;
    cuts_ = cuts;
  }

  void feed_in(bool inverse_time) {
    feed_mode_ = true;
    inverse_time_ = inverse_time;
  }

  // CIP, splines: a motion, of which only that it is one is known.
  void unread(const ir::Code& code) {
    if (code.group == ir::ModalGroup::motion) move(false);
    if (code.group == ir::ModalGroup::feed) feed_in(false);
    if (code.group == ir::ModalGroup::non_modal) words_are_no_move_ = true;  // an axis that is somewhere
  }

  void moves(const ir::Block& block, const ir::Statement& s) {
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (!ir::is_axis(word.address)) continue;
      diameter(word);
      if (inherits_) continue;
      once(motion_, DiagnosticId::motion_without_code, word.span, axis_name(word));
      if (ir::is_linear_axis(word.address)) once(unit_, DiagnosticId::unit_not_stated, s.span);
      if (word.mode == ir::WordMode::as_modal && !machine_coordinates_)
        once(distance_, DiagnosticId::distance_mode_not_stated, s.span);
      if (cuts_) feed(s);
    }
  }

  void feed(const ir::Statement& s) {
    // G93: the time of each block is its own. (PG, "Feedrate".)
    if (inverse_time_ && !has_feed_ && !feed_span_.empty()) {
      check_.report(DiagnosticId::no_feed, s.span);
      has_feed_ = true;  // once a block
    }
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
  bool inverse_time_ = false;
  bool has_feed_ = false;  // F or FB of the block at hand
  bool incremental_ = false;
  bool doubles_ = false;  // DIAMON was stated
  bool machine_coordinates_ = false;
  bool words_are_no_move_ = false;
  text::Span feed_span_;  // the first F
};

std::span<const ModalState::Row> ModalState::rows() {
  static constexpr Row kRows[] = {
      {Function::rapid, [](ModalState& m, const ir::Code&) { m.move(false); }},
      {Function::linear, [](ModalState& m, const ir::Code&) { m.move(true); }},
      {Function::thread, [](ModalState& m, const ir::Code&) { m.move(false); }},
      {Function::thread_changing, [](ModalState& m, const ir::Code&) { m.move(false); }},
      {Function::tap, [](ModalState& m, const ir::Code&) { m.move(false); }},
      {Function::tap_retract, [](ModalState& m, const ir::Code&) { m.move(false); }},
      {Function::spline, [](ModalState& m, const ir::Code&) { m.move(true); }},
      {Function::polynomial, [](ModalState& m, const ir::Code&) { m.move(true); }},
      {Function::arc_via, [](ModalState& m, const ir::Code& c) { m.move(true), m.plane_needed(c.span); }},
      {Function::arc_tangent, [](ModalState& m, const ir::Code& c) { m.move(true), m.plane_needed(c.span); }},
      {Function::arc_cw, [](ModalState& m, const ir::Code& c) { m.move(true), m.plane_needed(c.span); }},
      {Function::arc_ccw, [](ModalState& m, const ir::Code& c) { m.move(true), m.plane_needed(c.span); }},
      {Function::comp_left, [](ModalState& m, const ir::Code& c) { m.plane_needed(c.span); }},
      {Function::comp_right, [](ModalState& m, const ir::Code& c) { m.plane_needed(c.span); }},
      {Function::plane_xy, [](ModalState& m, const ir::Code&) { m.plane_ = true; }},
      {Function::plane_zx, [](ModalState& m, const ir::Code&) { m.plane_ = true; }},
      {Function::plane_yz, [](ModalState& m, const ir::Code&) { m.plane_ = true; }},
      {Function::unit_inch, [](ModalState& m, const ir::Code&) { m.unit_ = true; }},
      {Function::unit_mm, [](ModalState& m, const ir::Code&) { m.unit_ = true; }},
      {Function::absolute, [](ModalState& m, const ir::Code&) { m.distance_ = true, m.incremental_ = false; }},
      {Function::incremental, [](ModalState& m, const ir::Code&) { m.distance_ = m.incremental_ = true; }},
      {Function::feed_per_min, [](ModalState& m, const ir::Code&) { m.feed_in(false); }},
      {Function::feed_per_rev, [](ModalState& m, const ir::Code&) { m.feed_in(false); }},
      {Function::feed_inverse_time, [](ModalState& m, const ir::Code&) { m.feed_in(true); }},
      {Function::diameter_on, [](ModalState& m, const ir::Code&) { m.doubles_ = true; }},
      {Function::diameter_off, [](ModalState& m, const ir::Code&) { m.doubles_ = false; }},
      {Function::diameter_absolute_only, [](ModalState& m, const ir::Code&) { m.doubles_ = false; }},
      {Function::dwell, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::local_shift, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::axial_shift, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::local_shift_add, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::rotate, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::scale, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::mirror, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::pole_from_last, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::pole_from_zero, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::pole_from_pole, [](ModalState& m, const ir::Code&) { m.words_are_no_move_ = true; }},
      {Function::machine_coordinates, [](ModalState& m, const ir::Code&) { m.machine_coordinates_ = true; }},
      {Function::not_modelled, [](ModalState& m, const ir::Code& c) { m.unread(c); }},
  };
  return kRows;
}

}  // namespace

void check_modal_state(const Check& check) { ModalState(check).run(); }

}  // namespace dripfeed::sinumerik
