// What the machine's power-on state would decide. The blocks are looked at in the order of the text: what is stated
// further up counts as stated, and after a call or a block that is not understood everything does.
#include <algorithm>
#include <optional>
#include <string>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/cycle.h"
#include "dialects/macro_b/validator/in_effect.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;
using enum text::DiagnosticId;

bool is_cut(Function f) {
  return f == Function::linear || f == Function::arc_cw || f == Function::arc_ccw || f == Function::thread ||
         f == Function::thread_changing || f == Function::nurbs || f == Function::drill;
}

// Controls that have alarms of their own for the feed of a tap and the lead of a thread.
ir::AlarmDetail detail_of(const ir::Code& code) {
  if (code.function == Function::thread || code.function == Function::thread_changing) return ir::AlarmDetail::thread;
  if (code.function != Function::drill) return ir::AlarmDetail::none;
  const auto cycle = static_cast<ir::DrillCycle>(code.argument % ir::kDrillAlongZ);
  const bool taps = cycle == ir::DrillCycle::tap_right || cycle == ir::DrillCycle::tap_left;
  return taps ? ir::AlarmDetail::tap : ir::AlarmDetail::none;
}

class ModeCheck {
 public:
  ModeCheck(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts, Findings& findings)
      : program_(program),
        control_(control),
        findings_(findings),
        in_effect_(program, facts),
        has_distance_codes_(std::ranges::any_of(
            control.g_codes, [](const ir::CodeRow& r) { return r.function == Function::incremental; })),
        confirmed_(control.from_profile && control.semantics.power_on_known) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind == StatementKind::block) {
      load(at);
      block(program_.blocks[s.payload], s.span);
    }
    const bool unknown = s.kind == StatementKind::native && !program_.natives[s.payload].effects_known;
    if (unknown || s.kind == StatementKind::call) assume_all();
  }

 private:
  [[nodiscard]] bool has_word(const ir::Block& block, Address address) const {
    return std::ranges::find(program_.words_of(block), address, &ir::Word::address) != program_.words_of(block).end();
  }
  void assume_all() { unit_ = distance_ = plane_ = feed_mode_ = motion_ = feed_ = limit_ = true; }

  void load(std::uint32_t at) {
    in_effect_.at(at);
    const std::optional<facts::Setting> feed = in_effect_.certain(facts::Mode::feed);
    inverse_time_ = feed && feed->function == Function::feed_inverse_time;
  }

  void block(const ir::Block& block, text::Span span) {
    bool own_words = false;  // dwell, shifts, data: the axis words are no move
    bool by_reference = false;
    bool computed = false;
    bool needs_plane = false;
    for (const ir::Code& code : program_.codes_of(block)) {
      take(code);
      speed_limit(code, block);
      const bool once = code.group == ModalGroup::non_modal && code.function != Function::machine_coordinates &&
                        code.function != Function::exact_stop_once && code.function != Function::no_effect;
      by_reference |= code.function == Function::reference_return;
      own_words |= once && code.function != Function::reference_return;
      own_words |= code.group == ModalGroup::frame;  // G68 X0 Y0 R30 names a centre
      // It may call a macro by parameter, and the words are arguments then.
      own_words |=
          code.function == Function::machine_function && !ir::is_known_machine_function(control_, code.argument);
      computed |= code.number != ir::ExpressionId::none;
      needs_plane |= code.function == Function::arc_cw || code.function == Function::arc_ccw ||
                     code.function == Function::comp_left || code.function == Function::comp_right;
    }
    if (computed) return assume_all();  // G#1 may be any of them
    if (needs_plane) open(plane_, plane_not_stated, span, {});
    feed_word(block);
    if (own_words) return;
    const std::string axes = axes_of(block);
    if (axes.empty()) return;
    open(unit_, unit_not_stated, span, {});
    if (has_distance_codes_) open(distance_, distance_mode_not_stated, span, {});
    if (by_reference) return;
    open(motion_, motion_without_code, span, {axes});
    if (cutting_ && inverse_time_ && !has_word(block, Address::f))
      findings_.add(no_feed, span, {}, ir::AlarmDetail::inverse_time);
    if (cutting_ && !feed_ && in_effect_.lacks_feed()) {
      findings_.add(no_feed, span, {}, cut_);
      feed_ = true;
    }
  }

  // With a named machine its highest speed is known, and the run looks at it.
  void speed_limit(const ir::Code& code, const ir::Block& block) {
    limit_ |= code.function == Function::set_coordinates && has_word(block, Address::s);
    if (code.function != Function::surface_speed_on || control_.kind != ir::MachineKind::lathe) return;
    if (!limit_ && !control_.from_profile)
      findings_.add(surface_speed_without_limit, code.span,
                    {control_.g_system == ir::GSystem::a ? "no G50 S" : "no G92 S"});
    limit_ = true;
  }

  void take(const ir::Code& code) {
    if (code.group == ModalGroup::motion || code.group == ModalGroup::cycle) {
      motion_ |= code.function != Function::cycle_off;
      cutting_ = is_cut(code.function);
      cut_ = detail_of(code);
    }
    unit_ |= code.group == ModalGroup::unit;
    distance_ |= code.group == ModalGroup::distance;
    feed_mode_ |= code.group == ModalGroup::feed;
    if (code.group == ModalGroup::feed) inverse_time_ = code.function == Function::feed_inverse_time;
    plane_ |= code.group == ModalGroup::plane;
  }

  void feed_word(const ir::Block& block) {
    const auto words = program_.words_of(block);
    const auto feed = std::ranges::find(words, Address::f, &ir::Word::address);
    if (feed == words.end()) return;
    feed_ = true;
    open(feed_mode_, feed_mode_not_stated, feed->span, {std::string(text_of(program_, feed->span))});
  }

  // Told once: from then on it counts as stated.
  void open(bool& stated, text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
    if (stated) return;
    stated = true;
    findings_.add_open(id, span, std::move(arguments), confirmed_);
  }

  std::string axes_of(const ir::Block& block) const {
    std::string axes;
    for (const ir::Word& word : program_.words_of(block)) {
      if (!is_axis(control_, word.address)) continue;
      if (!axes.empty()) axes += " and ";
      axes.push_back(letter_of(word.address));
    }
    return axes;
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  InEffect in_effect_;
  bool has_distance_codes_;
  bool confirmed_;
  bool unit_ = false;
  bool distance_ = false;
  bool plane_ = control_.kind != ir::MachineKind::mill;  // a lathe's is always ZX
  bool feed_mode_ = false;
  bool motion_ = false;
  bool feed_ = false;
  bool limit_ = false;  // of the spindle, for constant surface speed
  bool cutting_ = false;
  ir::AlarmDetail cut_ = ir::AlarmDetail::none;  // what it is that cuts
  bool inverse_time_ = false;                    // F counts in its own block only
};

}  // namespace

StatementCheck modes_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                           const Section& section, Findings& findings) {
  if (section.is_subprogram) return [](std::uint32_t) {};
  return [check = ModeCheck(program, control, facts, findings)](std::uint32_t i) mutable { check.statement(i); };
}

}  // namespace dripfeed::macro_b
