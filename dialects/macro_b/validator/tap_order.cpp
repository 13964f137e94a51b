// Given up after a jump, a label or a call.
#include "dialects/macro_b/validator/tap_order.h"

#include <algorithm>
#include <string>

#include "dialects/ir/cycle.h"

namespace dripfeed::macro_b {

namespace {

using ir::Function;
using enum text::DiagnosticId;

constexpr std::int16_t kRigidTap = 29;  // M29

bool is_tap(const ir::Code& code) {
  const auto cycle = static_cast<ir::DrillCycle>(code.argument % ir::kDrillAlongZ);
  return cycle == ir::DrillCycle::tap_right || cycle == ir::DrillCycle::tap_left;
}

}  // namespace

TapOrder::TapOrder(const ir::Program& program, const ir::Control& control, Findings& findings)
    : program_(program),
      control_(control),
      findings_(findings),
      has_rigid_taps_(!ir::alarm_of(control, rigid_tap_invalid).empty()),
      has_taps_(std::ranges::any_of(program.codes,
                                    [](const ir::Code& c) { return c.function == Function::drill && is_tap(c); })) {}

void TapOrder::block(const ir::Block& block, bool moves) {
  if (has_rigid_taps_) rigid_tap(block, moves);
  speed_in_tap(block);
}

void TapOrder::end(text::Span span) {
  if (rigid_ == Rigid::waits) add(span, "ends the program between M29 and its tapping cycle", ir::AlarmDetail::none);
}

void TapOrder::forget() {
  sync_tap_ = false;
  rigid_ = Rigid::off;
}

// M29 S500, then the tapping cycle: nothing that moves or turns the plane comes between.
void TapOrder::rigid_tap(const ir::Block& block, bool moves) {
  const auto codes = program_.codes_of(block);
  const bool has_speed =
      std::ranges::any_of(program_.words_of(block), [](const ir::Word& w) { return w.address == ir::Address::s; });
  // Which M function that is, a parameter states (5210): where nothing taps and no speed stands with it, it is another.
  const auto m29 = std::ranges::find_if(codes, [&](const ir::Code& c) {
    return c.function == Function::machine_function && c.argument == kRigidTap && (has_taps_ || has_speed);
  });
  const auto cycle = std::ranges::find(codes, Function::drill, &ir::Code::function);
  const auto plane = std::ranges::find(codes, ir::ModalGroup::plane, &ir::Code::group);
  const bool taps = cycle != codes.end() && is_tap(*cycle);
  if (plane != codes.end() && (rigid_ != Rigid::off))
    add(plane->span, "changes the plane of a rigid tap", ir::AlarmDetail::plane_changes);
  if (rigid_ == Rigid::waits && !taps) {
    if (cycle != codes.end()) {
      add(cycle->span, "stands between M29 and its tapping cycle", ir::AlarmDetail::none);
    } else if (m29 != codes.end()) {
      add(m29->span, "stands after another M29 without a tapping cycle", ir::AlarmDetail::none);
    } else if (moves) {
      add(program_.words_of(block).front().span, "moves between M29 and its tapping cycle",
          ir::AlarmDetail::axis_moves);
      rigid_ = Rigid::off;
    }
  }
  if (m29 != codes.end()) rigid_ = Rigid::waits;
  if (taps && rigid_ == Rigid::waits) rigid_ = Rigid::taps;
  const bool ends = std::ranges::any_of(
      codes, [](const ir::Code& c) { return c.function == Function::cycle_off || c.group == ir::ModalGroup::motion; });
  if (rigid_ == Rigid::taps && ends && !taps) rigid_ = Rigid::off;
}
// G84 ,R1 and G84.2 couple the spindle to the axis until the cycle ends.
void TapOrder::speed_in_tap(const ir::Block& block) {
  const auto codes = program_.codes_of(block);
  const bool begins = std::ranges::any_of(codes, [&](const ir::Code& c) {
    if (c.function != Function::drill || !is_tap(c)) return false;
    const std::string_view name = text_of(program_, c.span);
    return name.ends_with(".2") || name.ends_with(".3") || names_synchronous(block);
  });
  const bool ends = std::ranges::any_of(codes, [](const ir::Code& c) {
    return c.function == Function::cycle_off || c.function == Function::drill || c.group == ir::ModalGroup::motion;
  });
  if (ends) sync_tap_ = begins;
  if (!sync_tap_ || begins ||
      ir::alarm_of(control_, rigid_tap_invalid, ir::AlarmDetail::speed_in_tap) ==
          ir::alarm_of(control_, rigid_tap_invalid))
    return;
  for (const ir::Word& word : program_.words_of(block))
    if (word.address == ir::Address::s && word.extension == 0)
      add(word.span, "stands while a synchronous tap is in effect", ir::AlarmDetail::speed_in_tap);
}
bool TapOrder::names_synchronous(const ir::Block& block) const {
  return std::ranges::any_of(program_.words_of(block), [&](const ir::Word& w) {
    return w.address == ir::Address::rounding && w.value != ir::ExpressionId::none &&
           program_.at(w.value).op == ir::Operator::constant && program_.at(w.value).value == 1.0;
  });
}
void TapOrder::add(text::Span span, std::string_view what, ir::AlarmDetail detail) {
  findings_.add(rigid_tap_invalid, span, {std::string(text_of(program_, span)) + " " + std::string(what)}, detail);
}

}  // namespace dripfeed::macro_b
