// Milling cycles that are called by name: the dialect's table makes a value of the call, the tool's radius comes from
// the machine's tools, and the cycle is milled. A program of that name is run instead, where one exists.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/cycles/milling.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/interpreter/motion/transformed.h"

namespace dripfeed::interpreter {

using text::DiagnosticId;

namespace {

constexpr std::uint32_t kAlarmNoTool = 61'000;  // no tool offset active

// Of a tool and its edge, as the machine's profile has it; below 0: not known.
double radius_in_profile(const Tool& tool, const ir::Control& control) {
  const auto fits = [&](std::int32_t offset) {
    const auto found = std::ranges::find_if(
        control.tool_radii, [&](const ir::ToolRadius& one) { return one.tool == tool.number && one.offset == offset; });
    return found == control.tool_radii.end() ? -1.0 : found->radius_mm;
  };
  const double of_edge = fits(std::max(1, tool.offset));
  return of_edge > 0.0 ? of_edge : fits(0);
}

int number_of(ir::Plane plane) { return plane == ir::Plane::xy ? 1 : plane == ir::Plane::zx ? 2 : 3; }

}  // namespace

bool Machine::is_milling_cycle(const Instruction& i) {
  return stack_.program().calls[i.a].milling != nullptr && stack_.missing_target(i).has_value();
}

// Nothing of it was milled: the axes may be anywhere after it.
bool Machine::leave_milling(std::string name) {
  report_.count({.name = std::move(name)});
  state_.unknown = kAllAxes;
  return true;
}

// Of the tool in the spindle and its edge; below 0: not known, 0: its offsets are off. What the program wrote outranks
// the profile. Which number the control has for a tool that is called by name, the program does not show.
double Machine::cutter_radius() {
  const bool is_numbered = state_.tool.number != 0;
  const bool is_named = state_.tool.name != kNoText;
  const bool is_off = state_.length_offset == ir::LengthOffset::off && control_.semantics.d_selects_edge;
  if ((is_numbered || is_named) && is_off) return 0.0;  // D0
  if (!is_numbered) return -1.0;
  if ((state_.gaps & ir::kRadiiChanged) == 0) return radius_in_profile(state_.tool, control_);
  const std::string_view name = ir::name_of_system(control_, ir::SystemValue::tool_radius);
  if (is_named || name.empty()) return -1.0;
  const auto edge = static_cast<std::uint32_t>(std::max(1, state_.tool.offset));
  const SharedValue* written =
      shared_.find(shared_.id_of(name), {static_cast<std::uint32_t>(state_.tool.number), edge});
  return written != nullptr && written->number > 0.0 ? written->number : -1.0;
}

bool Machine::mill_cycle(const Instruction& i) {
  const CompiledProgram& program = stack_.program();
  const CallSite& site = program.calls[i.a];
  if (site.argument_count > site.milling->values.size())
    return leave_milling(site.name + " with more values than are known");
  std::vector<double> values(site.milling->values.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t n = 0; n < site.argument_count; ++n) {
    const CallArgument& argument = program.arguments[site.first_argument + n];
    if (argument.value == Operand::none) continue;
    if (argument.is_string)
      return report_.fail(i, DiagnosticId::wrong_type, {"argument " + std::to_string(n + 1), "STRING", "REAL"});
    values[n] = storage_.reg(raw_of(argument.value));
    if (is_vacant(values[n])) return leave_milling(site.name + " with an argument that is not known");
  }
  const ir::MillUnits units = {.mm = state_.modes.inch ? 25.4 : 1.0,
                               .feed_mm = state_.modes.inch_feed ? 25.4 : 1.0,
                               .plane = number_of(state_.modes.plane)};
  const ir::MillReading reading = site.milling->read_milling(values, units);
  if (reading.alarm != 0) return report_.fail_user(i, reading.alarm, site.name);
  if (!reading.not_interpreted.empty()) return leave_milling(site.name + " " + std::string(reading.not_interpreted));
  const double radius = cutter_radius();
  if (radius == 0.0) return report_.fail_user(i, kAlarmNoTool, site.name);
  if (radius < 0.0) return leave_milling(site.name + " by a tool whose radius is not known");
  return mill_by(i, reading.cycle, radius);
}

bool Machine::mill_by(const Instruction& i, const ir::MillCycle& cycle, double radius) {
  // What waits for the next move must not be taken for one of the cycle's.
  if (state_.spline.active) end_spline(rules_, state_, out_);
  if (std::exchange(state_.corner, {}).kind != 0) out_.hold(false);
  if (BlockResult none; state_.plane_corner.kind != 0) drop_plane_corner(state_, out_, none);
  const std::string& name = stack_.program().calls[i.a].name;
  BlockResult result;
  const std::uint64_t before = out_.count();
  const MillOutcome outcome = mill(cycle, radius, rules_, state_, out_, result);
  if (!count_steps(i, out_.count() - before)) return false;
  if (outcome.alarm != 0) return report_.fail_user(i, outcome.alarm, name);
  if (!outcome.not_interpreted.empty()) return leave_milling(name + " " + std::string(outcome.not_interpreted));
  report_.count(
      {.name = "the order in which " + name + " removes the material", .effects_known = true, .is_model = true});
  return true;
}

}  // namespace dripfeed::interpreter
