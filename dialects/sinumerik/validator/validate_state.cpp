// What a main program leaves to the state in which the machine happens to be: motion code, unit, feed mode, distance
// mode, plane, feed. A mode is left to it where a path leads to the block on which nothing has stated the mode. After a
// call of another program, or a native statement of unknown effect, anything may have been stated. Diameter programming
// is followed in subprograms as well.
#include <algorithm>
#include <optional>

#include "dialects/facts/in_effect.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using facts::Kept;
using facts::Mode;
using ir::Address;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

// Words in the block of these name something else than a position that its motion goes to.
constexpr Function kOwnWords[] = {
    Function::dwell, Function::local_shift,    Function::axial_shift,    Function::local_shift_add, Function::rotate,
    Function::scale, Function::pole_from_last, Function::pole_from_zero, Function::pole_from_pole,  Function::mirror};
// Motions that take the feed.
constexpr Function kFedMotions[] = {Function::linear,      Function::spline, Function::polynomial, Function::arc_via,
                                    Function::arc_tangent, Function::arc_cw, Function::arc_ccw};
constexpr Function kNeedPlane[] = {Function::arc_via, Function::arc_tangent, Function::arc_cw,
                                   Function::arc_ccw, Function::comp_left,   Function::comp_right};

bool is_one_of(Function f, const auto& list) { return std::ranges::find(list, f) != std::end(list); }

class ModalState {
 public:
  ModalState(const Check& check, const facts::Resolved& facts)
      : check_(check),
        in_effect_(check.program, facts, !may_have_caller(check.program)),
        known_(check.control.semantics.power_on_known),
        has_diameter_(has_code(check.program, Function::diameter_on)) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = check_.program.statements[at];
    if (s.kind != StatementKind::block) return;
    in_effect_.at(at);
    block(check_.block_of(s), s.span);
  }

 private:
  void block(const ir::Block& block, text::Span span) {
    bool machine_coordinates = false;
    bool own_words = false;
    for (const ir::Code& code : check_.program.codes_of(block)) {
      if (code.function == Function::rapid && code.group == ir::ModalGroup::non_modal) return;  // POS
      take(code);
      machine_coordinates |= code.function == Function::machine_coordinates;
      // … and an axis that is somewhere.
      own_words |= is_one_of(code.function, kOwnWords) ||
                   (code.function == Function::not_modelled && code.group == ir::ModalGroup::non_modal);
    }
    if (own_words) return;
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (!ir::is_axis(word.address)) continue;
      diameter(word);
      if (in_effect_.may_be_unstated(Mode::motion))
        once(motion_reported_, DiagnosticId::motion_without_code, word.span, axis_name(word));
      if (ir::is_linear_axis(word.address) && in_effect_.may_be_unstated(Mode::unit))
        once(unit_reported_, DiagnosticId::unit_not_stated, span);
      if (word.mode == ir::WordMode::as_modal && !machine_coordinates && in_effect_.may_be_unstated(Mode::distance))
        once(distance_reported_, DiagnosticId::distance_mode_not_stated, span);
    }
    feed(block, span);
  }

  void take(const ir::Code& code) {
    in_effect_.take(code);
    if (is_one_of(code.function, kNeedPlane) && in_effect_.may_be_unstated(Mode::plane))
      once(plane_reported_, DiagnosticId::plane_not_stated, code.span);
  }

  [[nodiscard]] bool has(Mode mode, const auto& wanted) const {
    const std::optional<facts::Setting> setting = in_effect_.stated(mode);
    return setting && wanted(setting->function);
  }

  void feed(const ir::Block& block, text::Span span) {
    const auto words = check_.program.words_of(block);
    if (std::ranges::none_of(words, ir::is_axis, &ir::Word::address)) return;
    const auto own = std::ranges::find_if(
        words, [](const ir::Word& w) { return w.address == Address::f || w.address == Address::block_feed; });
    const bool lacks = in_effect_.lacks(Kept::feed);
    const bool by_time = has(Mode::feed, [](Function f) { return f == Function::feed_inverse_time; });
    const bool misses = own == words.end() && (lacks || by_time);
    const bool opens = !feed_reported_ && !feed_mode_reported_ && in_effect_.may_be_unstated(Mode::feed);
    if ((!misses && !opens) || !has(Mode::motion, [](Function f) { return is_one_of(f, kFedMotions); })) return;
    if (misses) {
      // G93: the time of each block is its own (PG, "Feedrate"); another feed is missed once.
      if (!(lacks && feed_reported_)) check_.report(DiagnosticId::no_feed, span);
      feed_reported_ |= lacks;
      return;
    }
    const text::Span f = own != words.end() ? own->span : word_of(in_effect_.origin(Kept::feed), Address::f);
    if (!f.empty()) once(feed_mode_reported_, DiagnosticId::feed_mode_not_stated, f, std::string(check_.text_of(f)));
  }

  [[nodiscard]] text::Span word_of(std::uint32_t statement, Address address) const {
    const auto& statements = check_.program.statements;
    if (statement >= statements.size() || statements[statement].kind != StatementKind::block) return {};
    const auto words = check_.program.words_of(check_.block_of(statements[statement]));
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    return word == words.end() ? text::Span{} : word->span;
  }

  void once(bool& reported, DiagnosticId id, text::Span span, std::string argument = {}) {
    if (reported) return;
    reported = true;
    if (known_) return;  // the profile says in which state the machine starts
    std::vector<std::string> arguments;
    if (!argument.empty()) arguments.push_back(std::move(argument));
    check_.report_if_machine(id, span, std::move(arguments));
  }

  // DIAMON takes increments of X as diameters: X=RETR with a radius in it goes half as far. DIAM90 does not.
  void diameter(const ir::Word& word) {
    if (!has_diameter_ || word.address != Address::x || !agrees_on(Mode::diameter, Function::diameter_on)) return;
    const bool incremental = word.mode == ir::WordMode::incremental ||
                             (word.mode == ir::WordMode::as_modal && agrees_on(Mode::distance, Function::incremental));
    const ir::Expression& value = check_.program.at(word.value);
    if (incremental && !(value.op == ir::Operator::constant && value.value == 0.0))
      check_.report(DiagnosticId::diameter_doubles_increment, word.span, {"X"});
  }
  // Stated, here or before, and not at power-on alone.
  [[nodiscard]] bool agrees_on(Mode mode, Function wanted) const {
    const std::optional<facts::Setting> setting = in_effect_.agreed(mode);
    return setting && setting->function == wanted && !in_effect_.may_be_unstated(mode);
  }

  static std::string axis_name(const ir::Word& word) {
    return std::string(1, static_cast<char>('A' + static_cast<int>(word.address)));
  }

  const Check& check_;
  facts::InEffect in_effect_;
  bool known_;
  bool has_diameter_;  // DIAMON, somewhere in the text
  // Each is reported once.
  bool motion_reported_ = false;
  bool unit_reported_ = false;
  bool distance_reported_ = false;
  bool plane_reported_ = false;
  bool feed_mode_reported_ = false;
  bool feed_reported_ = false;
};

}  // namespace

StatementCheck modal_state_check(const Check& check, const facts::Resolved& facts) {
  return [modal = ModalState(check, facts)](std::uint32_t i) mutable { modal.statement(i); };
}

}  // namespace dripfeed::sinumerik
