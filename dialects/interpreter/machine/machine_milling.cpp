// Milling cycles that are called by name: the dialect's table makes a value of the call, the tool's radius comes from
// the machine's tools, and the cycle is milled. A program of that name is run instead, where one exists.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/cycles/mill_path.h"
#include "dialects/interpreter/cycles/milling.h"
#include "dialects/interpreter/machine/active_tool.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/interpreter/motion/transformed.h"

namespace dripfeed::interpreter {

using text::DiagnosticId;

namespace {

constexpr std::uint32_t kAlarmNoTool = 61'000;  // no tool offset active

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

bool Machine::mill_cycle(const Instruction& i, std::uint32_t& next) {
  const CompiledProgram& program = stack_.program();
  const CallSite& site = program.calls[i.a];
  if (site.argument_count > site.milling->values.size())
    return leave_milling(site.name + " with more values than are known");
  std::vector<double> values(site.milling->values.size(), std::numeric_limits<double>::quiet_NaN());
  std::string contour;
  for (std::uint32_t n = 0; n < site.argument_count; ++n) {
    const CallArgument& argument = program.arguments[site.first_argument + n];
    if (argument.value == Operand::none) continue;
    const bool is_name = site.milling->values[n] == ir::CycleValue::contour;
    if (argument.is_string && is_name) {
      contour = storage_.text(raw_of(argument.value));
      continue;
    }
    if (argument.is_string || is_name)
      return report_.fail(
          i, DiagnosticId::wrong_type,
          {"argument " + std::to_string(n + 1), is_name ? "REAL" : "STRING", is_name ? "STRING" : "REAL"});
    values[n] = storage_.reg(raw_of(argument.value));
    if (is_vacant(values[n])) return leave_milling(site.name + " with an argument that is not known");
  }
  const ir::MillUnits units = {.mm = state_.modes.inch ? 25.4 : 1.0,
                               .feed_mm = state_.modes.inch_feed ? 25.4 : 1.0,
                               .plane = number_of(state_.modes.plane)};
  const ir::MillReading reading = site.milling->read_milling(values, units);
  if (reading.alarm != 0) return report_.fail_user(i, reading.alarm, site.name);
  if (!reading.not_interpreted.empty()) return leave_milling(site.name + " " + std::string(reading.not_interpreted));
  if (reading.cycle.shape == ir::MillShape::path) {
    if (contour_.active || shape_.active()) return leave_milling(site.name + " within a contour");
    if (contour.empty() || is_unknown(contour)) return leave_milling(site.name + " along a contour that is not known");
    contour_.path = reading.cycle;
    return run_contour(i, contour, next);
  }
  const std::optional<double> radius = active_radius(control_, shared_, state_);
  if (!radius) return leave_milling(site.name + " by a tool whose radius is not known");
  if (*radius == 0.0) return report_.fail_user(i, kAlarmNoTool, site.name);
  return mill_by(i, reading.cycle, *radius);
}

// The contour was run; its tool's radius is not asked for.
bool Machine::end_path(const Instruction& call) {
  const std::string& name = stack_.program().calls[call.a].name;
  BlockResult result;
  const std::uint64_t before = out_.count();
  const MillOutcome outcome = mill_path(*contour_.path, contour_.motions, rules_, state_, out_, result);
  if (!count_steps(call, out_.count() - before)) return false;
  if (!outcome.not_interpreted.empty()) return leave_milling(name + " " + std::string(outcome.not_interpreted));
  report_.count({.name = "the path from depth to depth of " + name, .effects_known = true, .is_model = true});
  return true;
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
