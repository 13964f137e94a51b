// What the machine's power-on state would decide: on some path to the block nothing has stated it. After a call of
// another program, or a block that is not understood, anything may be stated.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "dialects/facts/in_effect.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/cycle.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using facts::Kept;
using facts::Mode;
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
ir::AlarmDetail detail_of(const facts::Setting& cut) {
  if (cut.function == Function::thread || cut.function == Function::thread_changing) return ir::AlarmDetail::thread;
  if (cut.function != Function::drill) return ir::AlarmDetail::none;
  const auto cycle = static_cast<ir::DrillCycle>(cut.argument % ir::kDrillAlongZ);
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
        has_planes_(control.kind == ir::MachineKind::mill),
        confirmed_(control.from_profile && control.semantics.power_on_known) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind != StatementKind::block) return;
    in_effect_.at(at);
    block(program_.blocks[s.payload], s.span);
  }

 private:
  [[nodiscard]] bool has_word(const ir::Block& block, Address address) const {
    return std::ranges::find(program_.words_of(block), address, &ir::Word::address) != program_.words_of(block).end();
  }

  void block(const ir::Block& block, text::Span span) {
    bool own_words = false;  // dwell, shifts, data: the axis words are no move
    bool by_reference = false;
    bool computed = false;
    bool needs_plane = false;
    for (const ir::Code& code : program_.codes_of(block)) {
      in_effect_.take(code);
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
    if (computed) return;  // G#1 may be any of them
    if (needs_plane && has_planes_) open(Mode::plane, plane_not_stated, span, {});
    if (const ir::Word* feed = find_word(block, Address::f); feed != nullptr)
      open(Mode::feed, feed_mode_not_stated, feed->span, {std::string(text_of(program_, feed->span))});
    if (own_words) return;
    const std::string axes = axes_of(block);
    if (axes.empty()) return;
    open(Mode::unit, unit_not_stated, span, {});
    if (has_distance_codes_) open(Mode::distance, distance_mode_not_stated, span, {});
    if (by_reference) return;
    if (in_effect_.may_be_unstated(Mode::cycle)) open(Mode::motion, motion_without_code, span, {axes});
    feed(block, span);
  }

  // What moves the block, where all paths agree and the text states it.
  [[nodiscard]] std::optional<facts::Setting> cut() const {
    const std::optional<facts::Setting> cycle = in_effect_.stated(Mode::cycle);
    if (cycle && cycle->function == Function::drill) return cycle;
    const std::optional<facts::Setting> motion = in_effect_.stated(Mode::motion);
    const bool is_plain = in_effect_.state_against(Mode::cycle, Function::cycle_off) == facts::State::off;
    return is_plain && motion && is_cut(motion->function) ? motion : std::nullopt;
  }

  void feed(const ir::Block& block, text::Span span) {
    if (has_word(block, Address::f)) return;
    const std::optional<facts::Setting> mode = in_effect_.certain(Mode::feed);
    const bool by_time = mode && mode->function == Function::feed_inverse_time;  // F counts in its own block only
    const bool lacks = !feed_reported_ && in_effect_.lacks(Kept::feed);
    if (!by_time && !lacks) return;
    const std::optional<facts::Setting> cuts = cut();
    if (!cuts) return;
    if (by_time) findings_.add(no_feed, span, {}, ir::AlarmDetail::inverse_time);
    if (lacks) findings_.add(no_feed, span, {}, detail_of(*cuts));
    feed_reported_ |= lacks;
  }

  // With a named machine its highest speed is known, and the run looks at it.
  void speed_limit(const ir::Code& code, const ir::Block& block) {
    if (code.function != Function::surface_speed_on || control_.kind != ir::MachineKind::lathe || limit_reported_)
      return;
    const bool limits_here =
        has_word(block, Address::s) && std::ranges::any_of(program_.codes_of(block), [](const ir::Code& c) {
          return c.function == Function::set_coordinates;
        });
    if (limits_here || !in_effect_.lacks(Kept::spindle_limit) || control_.from_profile) return;
    findings_.add(surface_speed_without_limit, code.span,
                  {control_.g_system == ir::GSystem::a ? "no G50 S" : "no G92 S"});
    limit_reported_ = true;
  }

  [[nodiscard]] const ir::Word* find_word(const ir::Block& block, Address address) const {
    const auto words = program_.words_of(block);
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    return word == words.end() ? nullptr : &*word;
  }

  // Reported once.
  void open(Mode mode, text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
    bool& reported = reported_[facts::index_of(mode)];
    if (reported || !in_effect_.may_be_unstated(mode)) return;
    reported = true;
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
  facts::InEffect in_effect_;
  bool has_distance_codes_;
  bool has_planes_;  // a lathe's is always ZX
  bool confirmed_;
  std::array<bool, facts::kModes> reported_{};
  bool feed_reported_ = false;
  bool limit_reported_ = false;
};

}  // namespace

StatementCheck modes_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                           const Section& section, Findings& findings) {
  if (section.is_subprogram) return [](std::uint32_t) {};
  return [check = ModeCheck(program, control, facts, findings)](std::uint32_t i) mutable { check.statement(i); };
}

}  // namespace dripfeed::macro_b
