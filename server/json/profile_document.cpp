// One function a section of the document, in the order of the profile.
#include "server/json/profile_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/json/bodies.h"
#include "server/json/object_reader.h"
#include "server/json/profile_link.h"
#include "server/json/profile_words.h"

namespace dripfeed::json {

namespace {

constexpr double kLongest_mm = 1e6;
constexpr double kHuge = 1e9;
constexpr std::size_t kLongestToolName = 32;  // as a SINUMERIK has them ($TC_TP2, LIS1); not looked up there
// Of feeds, speeds and accelerations: below, a machine stands.
constexpr double kLeast = 0.001;
static_assert(kAxisWords.size() == ir::kAxisCount);
constexpr std::array<std::string_view, 2> kArcsWithoutCenter = {"alarm", "line"};
constexpr std::array<std::string_view, 2> kDecimalModes = {"calculator", "least-increment"};

void read_axis(ObjectReader& object, machine::Profile& profile) {
  checks::MachineAxis axis;
  const auto letter = object.choice("name", kAxisWords, true);
  object.number("min_mm", axis.min, -kLongest_mm, kLongest_mm);
  object.number("max_mm", axis.max, -kLongest_mm, kLongest_mm);
  object.flag("diameter", axis.is_diameter);
  object.number("rapid_mm_min", axis.rapid_mm_min, kLeast, kHuge, true);
  object.number("feed_limit_mm_min", axis.feed_limit_mm_min, kLeast, kHuge);
  object.number("acceleration_mm_s2", axis.acceleration_mm_s2, kLeast, kHuge, true);
  object.number("jerk_mm_s3", axis.jerk_mm_s3, 0.0, 1e12);
  object.number("reference_mm", axis.reference, -kLongest_mm, kLongest_mm);
  object.number("second_reference_mm", axis.second_reference, -kLongest_mm, kLongest_mm);
  if (!letter) return;
  axis.axis = static_cast<ir::Axis>(*letter);
  if (checks::find_axis(profile.machine, axis.axis) != nullptr) object.fault("name", "is given twice");
  if (axis.min && axis.max && *axis.min >= *axis.max)
    object.fault("max_mm", fmt::format("must be above min_mm {}, and is {}", text::format_shortest(*axis.min),
                                       text::format_shortest(*axis.max)));
  profile.machine.axes.push_back(axis);
}

// [{"from_mm": 40, "diameter_mm": 50}, ...], from below; the lowest begins above the tip.
void read_holder(ObjectReader& object, std::vector<checks::HolderStep>& holder) {
  checks::HolderStep step;
  object.number("from_mm", step.from_mm, 0.001, 10'000.0, true);
  object.number("diameter_mm", step.diameter_mm, 0.001, 10'000.0, true);
  if (!holder.empty() && !(step.from_mm > holder.back().from_mm) && step.from_mm > 0.0)
    object.fault("from_mm", "must be above that of the step before");
  holder.push_back(step);
}

checks::Insert read_insert(ObjectReader& object) {
  checks::Insert insert;
  object.number("angle_deg", insert.angle_deg, 10.0, 170.0, true);
  object.number("entering_angle_deg", insert.entering_angle_deg, 0.0, 180.0, true);
  object.number("edge_mm", insert.edge_mm, 0.1, 100.0, true);
  return insert;
}

// One name is one tool: each of its edges has it, or leaves it out.
void read_tool_name(ObjectReader& object, const machine::Profile& profile, checks::Tool& tool) {
  constexpr std::string_view kMember = "name";
  object.text(kMember, tool.name);
  if (tool.name.empty()) return;
  if (tool.name.size() > kLongestToolName || tool.name.contains('"'))
    object.fault(kMember, fmt::format("must be up to {} characters without a quotation mark", kLongestToolName));
  for (const checks::Tool& one : profile.machine.tools) {
    if (one.number != tool.number && one.name == tool.name)
      return object.fault(kMember, fmt::format("is the name of tool {}, too", one.number));
    if (one.number == tool.number && !one.name.empty() && one.name != tool.name)
      return object.fault(kMember, fmt::format("must be that of its other edge, \"{}\"", one.name));
  }
}

void read_tool(ObjectReader& object, machine::Profile& profile) {
  checks::Tool tool;
  object.integer("number", tool.number, 1, 99'999'999, true);
  read_tool_name(object, profile, tool);
  object.integer("offset", tool.offset, 0, 9999);
  object.number("nose_radius_mm", tool.nose_radius_mm, 0.0, 1000.0);
  object.integer("tip", tool.tip, 0, 9);
  object.number("diameter_mm", tool.diameter_mm, 0.0, 10'000.0);
  object.number("length_mm", tool.length_mm, 0.0, 10'000.0);
  object.number("length_x_mm", tool.length_x_mm, -10'000.0, 10'000.0);
  object.number("length_z_mm", tool.length_z_mm, -10'000.0, 10'000.0);
  object.number("corner_radius_mm", tool.corner_radius_mm, 0.0, 5000.0);
  if (tool.diameter_mm > 0.0 && tool.corner_radius_mm > 0.5 * tool.diameter_mm)
    object.fault("corner_radius_mm", fmt::format("must not be above half the diameter, and is {}",
                                                 text::format_shortest(tool.corner_radius_mm)));
  object.object("insert", [&](ObjectReader& o) { tool.insert = read_insert(o); });
  object.objects("holder", [&](ObjectReader& o) { read_holder(o, tool.holder); });
  if (!tool.holder.empty() && tool.length_mm && tool.holder.back().from_mm >= *tool.length_mm)
    object.fault("holder", "must begin below the gauge line, which `length_mm` gives");
  // One tool may have several offsets: the edges of a turning tool.
  const bool twice = std::ranges::any_of(profile.machine.tools, [&](const checks::Tool& one) {
    return one.number == tool.number && one.offset == tool.offset;
  });
  if (twice && tool.number != 0) object.fault("number", fmt::format("{} is given twice with one offset", tool.number));
  profile.machine.tools.push_back(tool);
}

// {"X_mm": 200, "Z_mm": -300}: where a work zero lies in machine coordinates; an axis that is not named is not known.
void read_zero(ObjectReader& object, std::array<std::optional<double>, ir::kAxisCount>& zero) {
  for (std::size_t i = 0; i < kAxisWords.size(); ++i) {
    object.number(fmt::format("{}_mm", kAxisWords[i]), zero[i], -kLongest_mm, kLongest_mm);
  }
}

void read_work_offset(ObjectReader& object, machine::Profile& profile) {
  checks::WorkOffset offset;
  object.integer("number", offset.number, 1, 300, true);
  read_zero(object, offset.zero);
  const auto known = std::ranges::find(profile.machine.work_offsets, offset.number, &checks::WorkOffset::number);
  if (known != profile.machine.work_offsets.end()) object.fault("number", "is given twice");
  profile.machine.work_offsets.push_back(offset);
}

void read_variables(ObjectReader& object, machine::ControlSettings& control) {
  static constexpr std::array<std::string_view, 2> kBanks = {"#", "R"};
  static constexpr std::array<std::string_view, 4> kUses = {"local", "common", "permanent", "system"};
  ir::VariableRange range;
  if (const auto bank = object.choice("bank", kBanks)) range.bank = *bank == 0 ? ir::Bank::hash : ir::Bank::r;
  object.integer("first", range.first, 0, 99'999'999);
  object.integer("last", range.last, 0, 99'999'999);
  if (const auto use = object.choice("use", kUses)) range.use = static_cast<ir::VariableUse>(*use);
  object.flag("writable", range.writable);
  if (range.last < range.first) object.fault("last", "must not be below first");
  control.variables.push_back(range);
}

// A word that stands for a function, as people write modes.
void read_mode(ObjectReader& object, std::string_view name, std::span<const std::string_view> words,
               std::span<const ir::Function> functions, std::optional<ir::Function>& into) {
  if (const auto index = object.choice(name, words)) into = functions[*index];
}

void read_power_on(ObjectReader& object, machine::ControlSettings& control) {
  using ir::Function;
  static constexpr std::array<std::string_view, 2> kUnits = {"mm", "inch"};
  static constexpr std::array kUnitFunctions = {Function::unit_mm, Function::unit_inch};
  static constexpr std::array<std::string_view, 2> kDistances = {"absolute", "incremental"};
  static constexpr std::array kDistanceFunctions = {Function::absolute, Function::incremental};
  static constexpr std::array<std::string_view, 2> kFeeds = {"per-minute", "per-revolution"};
  static constexpr std::array kFeedFunctions = {Function::feed_per_min, Function::feed_per_rev};
  static constexpr std::array<std::string_view, 3> kPlanes = {"xy", "zx", "yz"};
  static constexpr std::array kPlaneFunctions = {Function::plane_xy, Function::plane_zx, Function::plane_yz};
  read_mode(object, "unit", kUnits, kUnitFunctions, control.power_on_unit);
  read_mode(object, "distance", kDistances, kDistanceFunctions, control.power_on_distance);
  read_mode(object, "feed", kFeeds, kFeedFunctions, control.power_on_feed);
  read_mode(object, "plane", kPlanes, kPlaneFunctions, control.power_on_plane);
  object.flag("confirmed", control.power_on_confirmed);
}

// {"code": "G100", "program": 9010, "macro": true}
void read_code_call(ObjectReader& object, machine::ControlSettings& control) {
  ir::CodeCall call;
  std::string code;
  object.text("code", code, true);
  object.integer("program", call.program, 1, 99'999'999, true);
  object.flag("macro", call.macro);
  const auto number = code.size() > 1 ? text::parse_number(std::string_view(code).substr(1)) : std::optional<double>();
  if (!number || (code.front() != 'G' && code.front() != 'M') || *number < 0.0 || *number > 9999.0)
    return object.fault("code", "must be a G or M code");
  if (call.program == 0) return;
  call.letter = code.front();
  call.number10 = static_cast<std::int32_t>(std::lround(*number * 10.0));
  control.code_calls.push_back(call);
}

// "10-19, 25, 130": M functions of the machine.
void read_machine_functions(ObjectReader& object, machine::ControlSettings& control) {
  constexpr std::int64_t kLast = 9999;
  constexpr std::string_view kMember = "machine_functions";
  std::string written;
  object.text(kMember, written);
  std::erase(written, ' ');
  for (std::string_view rest = written; !rest.empty();) {
    const std::string_view item = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
    const std::size_t dash = item.find('-');
    const auto first = text::parse_integer(item.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : text::parse_integer(item.substr(dash + 1));
    if (!first || !last || *first < 0 || *last > kLast || *first > *last)
      return object.fault(kMember, "must be numbers and ranges up to 9999, as \"10-19, 25\"");
    for (std::int64_t number = *first; number <= *last; ++number)
      control.machine_functions.push_back(static_cast<std::uint16_t>(number));
  }
}

void read_control(ObjectReader& object, machine::ControlSettings& control) {
  object.text("title", control.title);
  if (const auto system = object.choice("g_system", kGSystemWords))
    control.g_system = static_cast<ir::GSystem>(*system);
  if (const auto mode = object.choice("decimal_mode", kDecimalModes))
    control.decimal_mode = static_cast<ir::DecimalMode>(*mode);
  object.flag("decimal_mode_confirmed", control.decimal_mode_confirmed);
  object.object("iso_mode", [&](ObjectReader& o) {
    if (const auto mode = o.choice("decimal_mode", kDecimalModes))
      control.iso_decimal_mode = static_cast<ir::DecimalMode>(*mode);
    o.flag("decimal_mode_confirmed", control.iso_decimal_mode_confirmed);
    o.flag("from_start", control.starts_in_iso_mode);
  });
  object.number("increment_mm", control.increment_mm, 0.0, 1.0);
  object.integer("block_length_bytes", control.block_length_bytes, 1, 65'536);
  object.integer("axes_at_once", control.axes_at_once, 1, 32);
  if (const auto arc = object.choice("arc_without_center", kArcsWithoutCenter))
    control.arc_without_center_is_line = *arc == 1;
  read_machine_functions(object, control);
  object.objects("code_calls", [&](ObjectReader& o) { read_code_call(o, control); });
  object.object("nesting", [&](ObjectReader& o) {
    o.integer("calls", control.call_nesting, 1, 100);
    o.integer("macros", control.macro_nesting, 1, 100);
    o.integer("loops", control.loop_nesting, 1, 127);
  });
  object.object("arcs", [&](ObjectReader& o) {
    o.number("tolerance_mm", control.arc_tolerance_mm, 0.0, 10.0);
    o.number("tolerance_factor", control.arc_tolerance_factor, 0.0, 1.0);
  });
  object.integer("reference_fixed_point", control.reference_fixed_point, 1, 4);
  object.flag("splines_confirmed", control.splines_confirmed);
  object.object("cycles", [&](ObjectReader& o) {
    o.number("chip_break_mm", control.chip_break_mm, 0.0, 1000.0);
    o.number("peck_clearance_mm", control.peck_clearance_mm, 0.0, 1000.0);
    o.number("turning_depth_mm", control.turning_depth_mm, 0.001, 1000.0);
    o.number("turning_retract_mm", control.turning_retract_mm, 0.0, 1000.0);
  });
  object.object("power_on", [&](ObjectReader& o) { read_power_on(o, control); });
  object.objects("variables", [&](ObjectReader& o) { read_variables(o, control); });
}

void read_timing(ObjectReader& object, machine::Profile& profile) {
  checks::TimingData& timing = profile.machine.timing;
  object.number("sample_time_ms", timing.sample_time_ms, 0.0, 1000.0);
  object.integer("look_ahead_blocks", timing.look_ahead_blocks, 0, 1'000'000);
  object.number("tool_change_s", timing.tool_change_s, 0.0, 3600.0);
  object.number("contour_tolerance_mm", timing.contour_tolerance_mm, 0.0, 10.0);
  object.object("cost", [&](ObjectReader& o) {
    ir::CostModel cost;
    for (const ir::CostTerm& term : ir::kCostTerms) {
      o.number(term.name, cost.*term.ms, 0.0, 1000.0, term.ms == &ir::CostModel::block_ms);
      // A profile that does not know of rounds counted the end of a loop as the block that it is in the text.
      if (term.ms == &ir::CostModel::round_ms && !o.has(term.name)) cost.round_ms = cost.block_ms;
    }
    o.number("spread", cost.spread, 1.0, 100.0);
    if (const auto source = o.choice("source", ir::kCostSourceNames))
      cost.source = static_cast<ir::CostSource>(*source);
    o.text("origin", timing.cost_origin);
    timing.cost = cost;
  });
}

void read_machine(ObjectReader& object, machine::Profile& profile) {
  checks::Machine& machine = profile.machine;
  object.objects("axes", [&](ObjectReader& o) { read_axis(o, profile); }, true);
  if (object.has("axes") && machine.axes.empty()) object.fault("axes", "must name at least one axis");
  object.number("feed_limit_mm_min", machine.feed_limit_mm_min, kLeast, kHuge);
  object.object("spindle", [&](ObjectReader& o) {
    o.number("min_rpm", machine.spindle_min_rpm, 0.0, 1e6);
    o.number("max_rpm", machine.spindle_max_rpm, kLeast, 1e6, true);
    if (machine.spindle_max_rpm < machine.spindle_min_rpm)
      o.fault("max_rpm",
              fmt::format("must not be below min_rpm, and is {}", text::format_shortest(machine.spindle_max_rpm)));
  });
  object.objects("tools", [&](ObjectReader& o) { read_tool(o, profile); });
  object.object("origin", [&](ObjectReader& o) { read_zero(o, machine.origin); });
  object.objects("work_offsets", [&](ObjectReader& o) { read_work_offset(o, profile); });
  object.object("buffer", [&](ObjectReader& o) {
    o.integer("bytes", machine.buffer.bytes, 0, 1'000'000'000);
    o.integer("blocks", machine.buffer.blocks, 0, 1'000'000);
    if (machine.buffer.bytes == 0 && machine.buffer.blocks == 0)
      o.fault("bytes", "must be above 0 where blocks are 0; a buffer that is not known is left out");
  });
  object.object("timing", [&](ObjectReader& o) { read_timing(o, profile); });
}

void read_notes(ObjectReader& object, const Document& notes, machine::Profile& profile) {
  if (!notes.is_array()) return object.fault("notes", "must be a list of texts");
  for (const Document& note : notes) {
    if (!note.is_string()) return object.fault("notes", "must be a list of texts");
    profile.notes.push_back(note.get<std::string>());
  }
}

void read_whole(ObjectReader& object, machine::Profile& profile) {
  object.proper_name("name", profile.name);
  object.text("title", profile.title);
  read_end_check(object, profile.end_check);
  object.text("dialect", profile.control.dialect, true);
  if (const Document* notes = object.member("notes", list_of(json::text(""), ""))) read_notes(object, *notes, profile);
  if (const auto kind = object.choice("kind", ir::kMachineKindNames, true))
    profile.control.kind = static_cast<ir::MachineKind>(*kind);
  profile.machine.kind = profile.control.kind;
  read_machine(object, profile);
  object.object("control", [&](ObjectReader& o) { read_control(o, profile.control); });
  object.object("link", [&](ObjectReader& o) { read_link(o, profile.line); }, true);
  object.object("receive", [&](ObjectReader& o) { read_receive(o, profile.line.receive); });
}

}  // namespace

app::Result<machine::Profile> read_profile(std::string_view document) {
  machine::Profile profile;
  const auto read =
      read_object(document, "machine profile", [&](ObjectReader& object) { read_whole(object, profile); });
  if (!read) return std::unexpected(read.error());
  if (const auto possible = line_is_possible(profile.line); !possible)
    return app::fail(app::ErrorCode::invalid, "machine profile: /link " + possible.error(),
                     {{.pointer = "/link", .line = 0, .column = 0, .text = possible.error()}});
  return profile;
}

Schema profile_schema() {
  return describe("a machine: its control, axes, tools and line", [](ObjectReader& object) {
    machine::Profile unused;
    read_whole(object, unused);
  });
}

app::Result<std::string> calibrated_profile(std::string_view document, const ir::CostModel& cost,
                                            std::string_view origin, double acceleration_factor) {
  auto parsed = parse(document);
  if (!parsed) return std::unexpected(parsed.error());
  if (!parsed->is_object()) return app::fail(app::ErrorCode::invalid, "a profile is a JSON object");
  Document figures = {{"source", ir::name_of(cost.source)}, {"origin", origin}, {"spread", cost.spread}};
  for (const ir::CostTerm& term : ir::kCostTerms) figures[std::string(term.name)] = cost.*term.ms;
  (*parsed)["timing"]["cost"] = std::move(figures);
  if (acceleration_factor != 1.0 && parsed->contains("axes")) {
    for (Document& axis : (*parsed)["axes"]) {
      if (axis.contains("acceleration_mm_s2") && axis["acceleration_mm_s2"].is_number())
        axis["acceleration_mm_s2"] = axis["acceleration_mm_s2"].get<double>() * acceleration_factor;
    }
  }
  return parsed->dump(2) + "\n";
}

}  // namespace dripfeed::json
