// One function a group of words, in the order of the preamble.
#include "dialects/compile/restart/restart_preamble.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/restart/restart_retract.h"
#include "dialects/compile/restart/restart_tool.h"
#include "dialects/compile/restart/restart_variables.h"

namespace dripfeed::compile {

namespace {

using interpreter::ModalState;
using ir::Function;
using ir::ModalGroup;
using text::DiagnosticId;

// What the program itself says before the line: only that is repeated. The rest is the control's own, as at the first
// run.
class Stated {
 public:
  explicit Stated(const RestartDraft& draft) {
    const ir::Program& program = draft.program;
    for (std::uint32_t i = draft.places.main().first; i < draft.places.main().last; ++i) {
      const ir::Statement& s = program.statements[i];
      if (s.line >= draft.line) break;
      if (draft.run.seen(s.line).visits > 0) take(program, s);
    }
    for (std::uint32_t i = draft.places.main().last; i < program.statements.size(); ++i)
      take(program, program.statements[i]);
    if (draft.library == nullptr) return;
    for (const auto& loaded : draft.library->loaded())
      if (!loaded->read.program.is_standard)
        for (const ir::Code& code : loaded->read.program.codes) groups_.insert(code.group);
  }
  [[nodiscard]] bool has(ModalGroup group) const { return groups_.contains(group); }
  // Of the last code of the unit: lengths and feeds, or lengths only (G70, G71 of SINUMERIK).
  [[nodiscard]] std::int16_t unit_argument() const { return unit_argument_; }

 private:
  void take(const ir::Program& program, const ir::Statement& s) {
    if (s.kind != ir::StatementKind::block) return;
    for (const ir::Code& code : program.codes_of(program.blocks[s.payload])) {
      groups_.insert(code.group);
      if (code.group == ModalGroup::unit) unit_argument_ = code.argument;
    }
  }

  std::int16_t unit_argument_ = 0;
  std::set<ModalGroup> groups_;
};

Function diameter_function(ir::DiameterMode mode) {
  switch (mode) {
    case ir::DiameterMode::radius: return Function::diameter_off;
    case ir::DiameterMode::diameter: return Function::diameter_on;
    case ir::DiameterMode::diameter_absolute_only: return Function::diameter_absolute_only;
  }
  return Function::none;
}

std::string feed_code(const RestartDraft& draft) {
  return draft.words.code(draft.point.state.modes.feed_mode == ir::FeedMode::per_rev ? Function::feed_per_rev
                                                                                     : Function::feed_per_min);
}

std::string unit_code(const RestartDraft& draft, const Stated& stated) {
  return draft.words.code(draft.point.state.modes.inch ? Function::unit_inch : Function::unit_mm,
                          stated.unit_argument());
}

void write_modes(RestartDraft& draft, const Stated& stated) {
  const interpreter::Modes& modes = draft.point.state.modes;
  const RestartWords& words = draft.words;
  const bool mill = !draft.turns();
  if (stated.has(ModalGroup::unit)) draft.add({unit_code(draft, stated)});
  std::vector<std::string> block;
  if (stated.has(ModalGroup::plane)) block.push_back(words.code(mill ? Function::plane_xy : function_of(modes.plane)));
  block.push_back(words.code(Function::absolute));
  if (stated.has(ModalGroup::feed)) block.push_back(feed_code(draft));
  block.push_back(words.code(Function::comp_off));
  if (mill && words.by_number()) {
    block.push_back(words.code(Function::length_offset_off));
    block.push_back(words.code(Function::cycle_off));
  }
  draft.add(block);
  if (stated.has(ModalGroup::diameter)) draft.add({words.code(diameter_function(modes.diameter))});
  std::vector<std::string> left;
  const auto leave = [&](ModalGroup group, std::string_view name) {
    if (!stated.has(group)) left.emplace_back(name);
  };
  leave(ModalGroup::unit, "the unit");
  leave(ModalGroup::plane, "the plane");
  leave(ModalGroup::feed, "the kind of feed");
  leave(ModalGroup::work_offset, "the work offset");
  if (!left.empty())
    draft.assumptions.push_back(fmt::format(
        "The program does not state {} before this line: what is set at the control counts, as at the first run.",
        fmt::join(left, ", ")));
}

std::optional<RestartRefusal> write_offset(RestartDraft& draft) {
  const std::int32_t number = draft.point.state.modes.work_offset;
  if (number == interpreter::kOffsetUnknown) return std::nullopt;
  if (std::string own = draft.words.code(Function::work_offset, static_cast<std::int16_t>(number)); !own.empty()) {
    draft.add({own});
    return std::nullopt;
  }
  const std::string extended = draft.words.code(Function::extended_offset);
  if (extended.empty() || number <= interpreter::kExtendedOffset)
    return RestartRefusal{DiagnosticId::restart_unknown, "the code of the work offset is"};
  draft.add({extended, draft.words.count('P', number - interpreter::kExtendedOffset)});
  return std::nullopt;
}

void write_spindle_limit(RestartDraft& draft) {
  const double limit_rpm = draft.point.state.spindle_limit_rpm;
  if (limit_rpm <= 0.0) return;
  const RestartWords& words = draft.words;
  if (words.by_number())
    draft.add({words.code(Function::set_coordinates), words.count('S', limit_rpm)});
  else
    draft.add({"LIMS=" + words.count('S', limit_rpm).substr(1)});
}

std::optional<RestartRefusal> write_spindle(RestartDraft& draft) {
  const ModalState& state = draft.point.state;
  const RestartWords& words = draft.words;
  const bool runs = state.spindle != ir::SpindleState::stopped;
  if (runs && state.speed_unknown) return RestartRefusal{DiagnosticId::restart_unknown, "the spindle's speed is"};
  const std::string direction =
      !runs ? std::string()
            : words.code(state.spindle == ir::SpindleState::clockwise ? Function::spindle_cw : Function::spindle_ccw);
  write_spindle_limit(draft);
  if (state.modes.surface_speed) {
    constexpr double kFoot_m = 0.3048;
    const double speed = state.modes.inch_feed ? state.surface_speed_m_min / kFoot_m : state.surface_speed_m_min;
    if (state.spindle_limit_rpm <= 0.0)
      draft.assumptions.emplace_back(
          "The program limits the spindle's speed nowhere: the machine's limit counts with G96.");
    draft.add({words.code(Function::surface_speed_on), speed > 0.0 ? words.count('S', speed) : "", direction});
    return std::nullopt;
  }
  const bool ended_by_feed = draft.control.semantics.feed_code_ends_surface_speed;
  const std::string constant = draft.turns() && !ended_by_feed ? words.code(Function::surface_speed_off) : "";
  const std::string speed = state.rpm > 0.0 && !state.speed_unknown ? words.count('S', state.rpm) : "";
  if (!speed.empty() || !direction.empty()) draft.add({constant, speed, direction});
  return std::nullopt;
}

void write_coolant(RestartDraft& draft) {
  const ir::CoolantState coolant = draft.point.state.coolant;
  if (coolant == ir::CoolantState::off) return;
  draft.add({draft.words.code(coolant == ir::CoolantState::mist ? Function::coolant_mist : Function::coolant_flood)});
}

}  // namespace

bool begins_with_tool_change(const RestartDraft& draft) {
  const auto& motions = draft.run.motions;
  for (std::size_t i = draft.run.first_motion(draft.point.ordinal); i < motions.size(); ++i) {
    const interpreter::Tool& tool = draft.point.state.tool;
    if (motions[i].kind == ir::MotionKind::tool)
      return motions[i].number != tool.number || motions[i].text != tool.name;
    if (ir::is_move(motions[i].kind)) return false;
  }
  return false;
}

std::optional<RestartRefusal> write_preamble(RestartDraft& draft) {
  const Stated stated(draft);
  write_modes(draft, stated);
  write_retract(draft);
  if (auto refused = write_offset(draft)) return refused;
  if (begins_with_tool_change(draft)) {
    if (auto refused = write_prepared_tool(draft)) return refused;
  } else {
    if (auto refused = write_tool(draft)) return refused;
    if (auto refused = write_spindle(draft)) return refused;
    write_coolant(draft);
  }
  if (auto refused = write_variables(draft)) return refused;
  const ModalState& state = draft.point.state;
  if (!state.feed_unknown && state.feed > 0.0) draft.add({draft.words.feed(state.feed)});
  return std::nullopt;
}

}  // namespace dripfeed::compile
