// What is wrong only because of a block before. What is in effect is known on all paths; what waits for the block
// after it (a corner, M29, the start of compensation) is looked at in the order of the text, and given up after a
// jump, a label or a call.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "dialects/facts/in_effect.h"
#include "dialects/facts/transformation.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/validator/tap_order.h"
#include "dialects/macro_b/validator/validate.h"

namespace dripfeed::macro_b {

namespace {

using facts::State;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

class OrderCheck {
 public:
  OrderCheck(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
             const Section& section, Findings& findings)
      : program_(program),
        control_(control),
        findings_(findings),
        entries_(program, section),
        in_effect_(program, facts),
        taps_(program, control, findings),
        has_lathe_corners_(control.kind == ir::MachineKind::lathe),
        has_shapes_(std::ranges::any_of(program.codes, ir::follows_shape)) {
    if (section.is_subprogram) forget();  // what is in effect is its caller's
  }

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind == StatementKind::program_end) taps_.end(s.span);
    if (entries_.at(at)) forget();
    if (!corner_span_.empty() && s.kind != StatementKind::empty && s.kind != StatementKind::assign) corner(s);
    if (s.kind == StatementKind::block) {
      if (at == 0 || s.is_label || !keeps_modes(at - 1)) load(at);
      block(program_.blocks[s.payload]);
    } else if (s.kind == StatementKind::modal_call) {
      modal_ = State::on;
      ++modal_depth_;
    } else if (s.kind == StatementKind::modal_call_end) {
      if (modal_ == State::off) add(modal_call_not_open, s.span, "G67");
      modal_depth_ -= modal_depth_ > 0 ? 1U : 0U;  // each G67 ends the last G66
      if (modal_depth_ == 0) modal_ = State::off;
    } else if (s.kind == StatementKind::go_to || s.kind == StatementKind::call || s.kind == StatementKind::native ||
               s.kind == StatementKind::while_begin || s.kind == StatementKind::loop_begin) {
      forget();
    }
  }

 private:
  void forget() {
    modal_ = data_ = State::uncertain;
    taps_.forget();
    starting_ = false;
    number_known_ = true;
    corner_span_ = letter_corner_ = {};
  }

  // The statement leads here alone, and what was loaded for it still holds: most blocks of most programs.
  [[nodiscard]] bool keeps_modes(std::uint32_t at) const {
    const ir::Statement& s = program_.statements[at];
    return s.kind == StatementKind::block && loaded_ && !has_shapes_ && modal_ == State::off &&
           program_.blocks[s.payload].code_count == 0;
  }

  // What the block finds in effect; its codes change it one after another.
  void load(std::uint32_t at) {
    using facts::Mode;
    in_effect_.at(at);
    loaded_ = true;
    comp_ = in_effect_.state_against(Mode::compensation, Function::comp_off);
    const std::optional<facts::Setting> cycle = in_effect_.certain(Mode::cycle);
    cycle_ = !cycle ? State::uncertain : cycle->function == Function::drill ? State::on : State::off;
    const std::optional<facts::Setting> frame = in_effect_.certain(Mode::frame);
    rotation_ = !frame ? State::uncertain : frame->function == Function::rotate ? State::on : State::off;
    const std::optional<facts::Setting> plane = in_effect_.stated(Mode::plane);
    plane_ = plane ? plane->function : Function::none;
    const std::optional<facts::Setting> moves = in_effect_.stated(Mode::motion);
    take_motion(moves ? moves->function : Function::none);
    moves_known_ = moves.has_value();
    const std::optional<facts::Setting> offset = in_effect_.certain(Mode::work_offset);
    extended_ = offset && (offset->function == Function::extended_offset ||
                           (offset->function == Function::work_offset && offset->argument > kExtendedOffset));
    const std::optional<facts::Setting> feed = in_effect_.certain(Mode::feed);
    inverse_time_ = feed && feed->function == Function::feed_inverse_time;
    inverse_time_by_ = in_effect_.written(Mode::feed);
    load_transformation();
  }
  void load_transformation() {
    transformed_ = ir::kTransformationEnds;
    const std::optional<facts::Setting> begun = in_effect_.stated(facts::Mode::transformation);
    if (!begun || begun->function == Function::none) return;
    const ir::Statement& s = program_.statements[static_cast<std::uint32_t>(begun->argument)];
    for (const ir::Code& code : program_.codes_of(program_.blocks[s.payload]))
      if (code.function == Function::transformation) transformed_ = code.argument;
    transformed_by_ = in_effect_.written(facts::Mode::transformation);
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
    number_known_ |= has_word(block, ir::Address::d);
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.number != ir::ExpressionId::none) return forget();
      motion(code);
      plane(code);
      own_words |= code.group == ir::ModalGroup::non_modal;
      const Function f = code.function;
      transformation(code, block);
      data_setting(code);
      inverse_time(code);
      if (f == Function::reference_return && cycle_ == State::on) add(reference_in_cycle, code.span, written(code));
      if (f == Function::skip_move && comp_ == State::on) add(skip_in_comp, code.span, written(code));
      if (f == Function::drill && comp_ == State::on && cycle_ != State::on)
        add(cycle_in_comp, code.span, written(code));
      if (f == Function::drill) cycle_ = State::on;
      if (code.group == ir::ModalGroup::work_offset)
        extended_ = f == Function::extended_offset || (f == Function::work_offset && code.argument > kExtendedOffset);
      shift(code, block);
      if (f == Function::comp_left || f == Function::comp_right || f == Function::comp_off) comp = &code;
    }
    const bool moves = !own_words && moves_axes(block);
    taps_.block(block, moves);
    if (comp != nullptr) take_comp(*comp);
    begin_corner(block, moves);
    if (has_lathe_corners_) lathe_corner(block, moves);
    if (!moves || !starting_) return;
    if (arc_) add(comp_started_by_arc, comp_span_, comp_ == State::on ? "starts" : "ends");
    starting_ = false;
  }

  void take_motion(Function f) {
    arc_ = f == Function::arc_cw || f == Function::arc_ccw;
    cuts_ = arc_ || f == Function::linear;
    threads_ = f == Function::thread || f == Function::thread_changing;
  }
  void motion(const ir::Code& code) {
    const Function f = code.function;
    if (code.group == ir::ModalGroup::motion) {
      take_motion(f);
      moves_known_ = true;
    }
    if (code.group == ir::ModalGroup::motion || f == Function::cycle_off) cycle_ = State::off;
    if (f == Function::rotate) rotation_ = code.argument == ir::kFrameAboutPoint ? State::on : State::off;
  }

  // Polar and cylindrical interpolation take moves along a contour, dwells and compensation.
  void transformation(const ir::Code& code, const ir::Block& block) {
    const Function f = code.function;
    if (f == Function::transformation) {
      transformed_ = facts::ends_transformation(program_, block, code) ? ir::kTransformationEnds : code.argument;
      transformed_by_ = written(code);
      return;
    }
    if (transformed_ == ir::kTransformationEnds) return;
    const auto detail = transformed_ == ir::kFaceByRotary ? ir::AlarmDetail::in_face : ir::AlarmDetail::none;
    constexpr Function kRefused[] = {
        Function::reference_return, Function::leave_reference, Function::work_offset, Function::machine_coordinates,
        Function::local_shift,      Function::set_coordinates, Function::drill};
    // By rapid moves only where the control has an alarm of its own for each of the two.
    const bool rapid = f == Function::rapid && ir::alarm_of(control_, code_not_in_mode, ir::AlarmDetail::in_face) !=
                                                   ir::alarm_of(control_, code_not_in_mode);
    if (!rapid && std::ranges::find(kRefused, f) == std::end(kRefused)) return;
    text::Diagnostic* finding =
        findings_.add(code_not_in_mode, code.span, {std::string(written(code)), std::string(transformed_by_)}, detail);
    if (finding != nullptr && finding->alarm.empty()) finding->severity = text::Severity::warning;
  }

  void plane(const ir::Code& code) {
    if (code.group != ir::ModalGroup::plane) return;
    const bool changes = plane_ != code.function && plane_ != Function::none;
    if (changes && comp_ == State::on) add(plane_changed_in_comp, code.span, written(code));
    if (changes && rotation_ == State::on) add(plane_changed_in_rotation, code.span, written(code));
    plane_ = code.function;
  }

  // G11 without G10, where the control has an alarm for it.
  void data_setting(const ir::Code& code) {
    if (code.function == Function::data_input) data_ = State::on;
    if (code.function != Function::no_effect || program_.strings.at(code.name) != "G11") return;
    if (data_ == State::off && !ir::alarm_of(control_, data_setting_not_open).empty())
      add(data_setting_not_open, code.span, written(code));
    data_ = State::off;
  }

  // Cycles and threads in G93, where the control has an alarm for it.
  void inverse_time(const ir::Code& code) {
    if (code.group == ir::ModalGroup::feed) {
      inverse_time_ = code.function == Function::feed_inverse_time;
      inverse_time_by_ = written(code);
    }
    if (!inverse_time_ || !has_own_alarm(code_not_in_mode, ir::AlarmDetail::inverse_time)) return;
    const bool refused = code.function == Function::drill || code.function == Function::thread ||
                         code.function == Function::thread_changing || code.function == Function::turning_cycle ||
                         code.function == Function::repetitive_cycle;
    if (refused)
      findings_.add(code_not_in_mode, code.span, {std::string(written(code)), std::string(inverse_time_by_)},
                    ir::AlarmDetail::inverse_time);
  }
  [[nodiscard]] bool has_own_alarm(text::DiagnosticId id, ir::AlarmDetail detail) const {
    return ir::alarm_of(control_, id, detail) != ir::alarm_of(control_, id);
  }

  // Where the control has an alarm for it: others take G52 in the block of G54.1.
  void shift(const ir::Code& code, const ir::Block& block) {
    if (code.function != Function::local_shift || !extended_ || !moves_axes(block)) return;
    if (!ir::alarm_of(control_, shift_in_extended_offset).empty())
      add(shift_in_extended_offset, code.span, written(code));
  }

  void take_comp(const ir::Code& code) {
    const State wanted = code.function == Function::comp_off ? State::off : State::on;
    // On lathes the tool's own offset says it.
    if (wanted == State::on && !number_known_ && control_.kind == ir::MachineKind::mill) {
      findings_.add(comp_without_number, code.span, {std::string(written(code))});
      number_known_ = true;
    }
    // Changing sides is no start.
    starting_ = comp_ != State::uncertain && comp_ != wanted;
    comp_ = wanted;
    comp_span_ = code.span;
  }

  // ,C and ,R of a block that moves. In a tap the word says that it is a synchronous one.
  void begin_corner(const ir::Block& block, bool moves) {
    for (const ir::Word& word : program_.words_of(block)) {
      const bool corner = word.address == ir::Address::chamfer || word.address == ir::Address::rounding;
      if (!corner || cycle_ != State::off || !moves_known_) continue;
      const bool led = moves || has_word(block, ir::Address::direct_angle);  // an angle may stand for a coordinate
      if (!led || !cuts_)
        add_corner(word.span, "before it");
      else
        corner_span_ = word.span;
    }
  }
  // G01 Z-20. K2. and G01 X40. R3. of lathes: the next block is a straight line along the other axis (0i-F
  // B-64604EN-1, "Chamfering and corner R"). R may also be the corner of a directly drawn line, which may taper.
  void lathe_corner(const ir::Block& block, bool moves) {
    const text::Span span = std::exchange(letter_corner_, {});
    if (!span.empty() && moves) {
      if (arc_) add_lathe_corner(span, "in a line after it", ir::AlarmDetail::not_a_line);
      if (!arc_ && cuts_ && !tapers_ && turned_axes(block) == 2)
        add_lathe_corner(span, "along one axis after it", ir::AlarmDetail::tapered);
    }
    const bool own_codes = std::ranges::any_of(program_.codes_of(block), [](const ir::Code& c) {
      return c.group == ir::ModalGroup::non_modal || c.group == ir::ModalGroup::frame;
    });
    if (!moves || !cuts_ || arc_ || own_codes || turned_axes(block) != 1) return;
    for (const ir::Word& word : program_.words_of(block)) {
      const bool leg = word.address == ir::Address::i || word.address == ir::Address::k;
      if (!leg && word.address != ir::Address::r) continue;
      letter_corner_ = word.span;
      tapers_ = !leg;
    }
  }
  [[nodiscard]] int turned_axes(const ir::Block& block) const {
    const bool x = has_word(block, ir::Address::x) || has_word(block, ir::Address::u);
    const bool z = has_word(block, ir::Address::z) || has_word(block, ir::Address::w);
    return (x ? 1 : 0) + (z ? 1 : 0);
  }
  void add_lathe_corner(text::Span span, std::string_view where, ir::AlarmDetail detail) {
    findings_.add_own(corner_without_move, span, {std::string(text_of(program_, span)), std::string(where)}, detail);
  }

  // The statement after one.
  void corner(const ir::Statement& s) {
    const text::Span span = std::exchange(corner_span_, {});
    const bool is_end = s.kind == StatementKind::program_end || s.kind == StatementKind::subprogram_return;
    if (s.kind != StatementKind::block && !is_end) return;
    bool stays = true;
    if (s.kind == StatementKind::block) {
      const ir::Block& block = program_.blocks[s.payload];
      for (const ir::Code& code : program_.codes_of(block)) {
        if (code.number != ir::ExpressionId::none) return;
        const Function f = code.function;
        const bool cut = f == Function::linear || f == Function::arc_cw || f == Function::arc_ccw;
        if (code.group == ir::ModalGroup::motion) stays &= cut;
        stays &= code.group != ir::ModalGroup::non_modal || f == Function::exact_stop_once;
      }
      stays &= moves_axes(block) || has_word(block, ir::Address::i) || has_word(block, ir::Address::j) ||
               has_word(block, ir::Address::k);
      // An angle may stand for a coordinate.
      stays |= has_word(block, ir::Address::direct_angle) || has_word(block, ir::Address::other) ||
               has_word(block, ir::Address::a);
    }
    if (is_end || !stays) add_corner(span, "after it");
  }
  void add_corner(text::Span span, std::string_view where) {
    text::Diagnostic* finding =
        findings_.add(corner_without_move, span, {std::string(text_of(program_, span)), std::string(where)},
                      threads_ ? ir::AlarmDetail::thread : ir::AlarmDetail::none);
    if (finding != nullptr && finding->alarm.empty()) finding->severity = text::Severity::warning;
  }

  [[nodiscard]] bool moves_axes(const ir::Block& block) const {
    return std::ranges::any_of(program_.words_of(block),
                               [&](const ir::Word& w) { return is_axis(control_, w.address); });
  }
  [[nodiscard]] bool has_word(const ir::Block& block, ir::Address address) const {
    return std::ranges::find(program_.words_of(block), address, &ir::Word::address) != program_.words_of(block).end();
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  Entries entries_;
  facts::InEffect in_effect_;
  TapOrder taps_;
  bool has_lathe_corners_;
  bool has_shapes_;  // blocks that run for a cycle: what follows them is in effect by the cycle
  bool loaded_ = false;
  // At the start nothing is in effect.
  std::uint32_t modal_depth_ = 0;  // G66 within G66
  State modal_ = State::off;
  State comp_ = State::off;
  State cycle_ = State::off;
  State rotation_ = State::off;
  State data_ = State::off;    // G10
  bool inverse_time_ = false;  // G93
  std::string_view inverse_time_by_;
  bool threads_ = false;      // the motion code is that of a thread
  bool cuts_ = false;         // the motion code is G01, G02 or G03
  bool moves_known_ = false;  // one was read
  std::int16_t transformed_ = ir::kTransformationEnds;
  std::string_view transformed_by_;
  bool extended_ = false;      // G54.1 is in effect
  bool number_known_ = false;  // D was given
  text::Span letter_corner_;   // R, I or K of a lathe's straight block
  bool tapers_ = false;        // … which a line along both axes may follow
  text::Span corner_span_;     // a corner that waits for the move after it
  Function plane_ = Function::none;
  bool arc_ = false;
  bool starting_ = false;  // compensation changes with the next move
  text::Span comp_span_;
};

// M99 with words of its own in its block while G66 is in effect.
void check_returns(const ir::Program& program, const Section& section, Findings& findings) {
  bool modal = false;
  for (std::uint32_t i = section.first; i < section.last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::modal_call) modal = true;
    if (s.kind == StatementKind::modal_call_end) modal = false;
    const bool returns = s.kind == StatementKind::subprogram_return || s.kind == StatementKind::return_to;
    if (!modal || !returns || s.tokens.first != s.tokens.last || i == section.first) continue;
    findings.add_own(statement_not_alone, program.statements[i - 1].span, {"M99"}, ir::AlarmDetail::with_return);
  }
}

}  // namespace

StatementCheck order_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                           const Section& section, Findings& findings) {
  check_returns(program, section, findings);
  return
      [check = OrderCheck(program, control, facts, section, findings)](std::uint32_t i) mutable { check.statement(i); };
}

}  // namespace dripfeed::macro_b
