// One run feeds all checks: the motions fan out. A check that lacks something says so instead of guessing.
#include "server/app/checks/examine.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/run_texts.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "dialects/compile/render/render.h"
#include "dialects/ir/axis_letters.h"
#include "server/app/checks/line_characters.h"
#include "server/app/checks/machine_facts.h"
#include "server/app/checks/outputs_written.h"
#include "server/app/checks/surface_checks.h"
#include "server/app/checks/warn_once.h"

namespace dripfeed::app {

ir::Control for_check(const ir::Control& given) {
  ir::Control control = given;
  control.semantics.unset_is_unknown = true;
  return control;
}

namespace {

ir::FeedMode feed_mode_of(ir::Function function) {
  if (function == ir::Function::feed_per_rev) return ir::FeedMode::per_rev;
  return function == ir::Function::feed_inverse_time ? ir::FeedMode::inverse_time : ir::FeedMode::per_min;
}

double part_size(const std::optional<family::Geometry>& geometry) {
  if (!geometry || !geometry->stock) return 0.0;
  if (const auto* cylinder = std::get_if<family::CylinderStock>(&*geometry->stock)) {
    return std::max(cylinder->diameter_mm, cylinder->z_mm.high - cylinder->z_mm.low);
  }
  const auto& box = std::get<family::BoxStock>(*geometry->stock);
  return std::max({box.x_mm.high - box.x_mm.low, box.y_mm.high - box.y_mm.low, box.z_mm.high - box.z_mm.low});
}

class Checks {
 public:
  Checks(const Examination& e, CheckReport& report)
      : e_(e), report_(report), surfaces_(e, SurfaceScope::all, report.checks.not_checked) {
    make_envelope();
    make_timing();
  }

  std::vector<ir::MotionSink*> sinks() {
    std::vector<ir::MotionSink*> all = surfaces_.sinks();
    if (envelope_) all.push_back(envelope_.get());
    if (timing_) all.push_back(timing_.get());
    return all;
  }

  void finish() {
    if (envelope_) report_.checks.envelope = envelope_->finish();
    if (timing_) report_.checks.timing = timing_->finish();
    if (report_.checks.envelope && report_.checks.envelope->lost_place) report_.checks.has_unknown_effects = true;
    if (timing_ && !report_.checks.timing->is_whole) report_.checks.has_unknown_effects = true;
    surfaces_.finish(report_.checks, report_.pictures);
    checks::for_each_check(report_.checks, [this](auto& one) { name_alarms(one.findings); });
  }

 private:
  // A control may have one alarm for each side of a limit: soft overtravel + and -.
  void name_alarms(checks::FindingList& findings) const {
    findings.name_alarms([this](const checks::Finding& one) {
      const auto side = one.value > one.limit ? ir::AlarmDetail::above : ir::AlarmDetail::below;
      return std::string(ir::alarm_of(e_.control, one.id, side));
    });
  }

  void skip(std::string_view why) { report_.checks.not_checked.add(why); }

  void make_envelope() {
    if (e_.profile == nullptr) return skip("travel, feed and spindle limits: no machine is named");
    envelope_ = std::make_unique<envelope::Envelope>(
        envelope::Settings{.machine = e_.profile->machine,
                           .arc_tolerance_mm = e_.control.semantics.arc_tolerance_mm,
                           .arc_tolerance_factor = e_.control.semantics.arc_tolerance_factor,
                           .work_offset = 1,
                           .part_size_mm = part_size(e_.geometry),
                           .d_selects_edge = e_.control.semantics.d_selects_edge});
  }

  void make_timing() {
    if (e_.profile == nullptr) return skip("time: no machine is named");
    auto settings = timing_settings(e_, e_.source.text());
    if (!settings) return skip(settings.error());
    timing_ = std::make_unique<timing::Timing>(std::move(*settings));
  }

  const Examination& e_;
  CheckReport& report_;
  std::unique_ptr<envelope::Envelope> envelope_;
  std::unique_ptr<timing::Timing> timing_;
  SurfaceChecks surfaces_;
};

// "stopped at the budget of 60 s"
std::string why_ended(const interpreter::RunResult& run) {
  const auto is_limit = [](const interpreter::RunDiagnostic& one) {
    return one.diagnostic.id == text::DiagnosticId::limit_reached;
  };
  const auto found = std::ranges::find_if(run.diagnostics, is_limit);
  if (found == run.diagnostics.end()) return "the program loops without end";
  return fmt::format("the run was stopped at the budget of {}", found->diagnostic.arguments.front());
}

// G30 stands in one of the programs that were run.
bool goes_to_second_reference(const ir::Program& main, const compile::ProgramLibrary& library) {
  constexpr std::int16_t kSecond = 2;
  const auto has_one = [](const ir::Program& program) {
    return std::ranges::any_of(program.codes, [](const ir::Code& code) {
      return code.function == ir::Function::reference_return && code.argument == kSecond;
    });
  };
  return has_one(main) ||
         std::ranges::any_of(library.loaded(), [&](const auto& loaded) { return has_one(loaded->read.program); });
}

// The linear axes whose reference point the machine's profile does not say: "X, Z".
std::string axes_without_reference(const machine::Profile& profile, bool second) {
  std::string letters;
  for (const checks::MachineAxis& axis : profile.machine.axes) {
    const bool is_rotary = axis.axis >= ir::Axis::a && axis.axis <= ir::Axis::c;
    if (is_rotary || (axis.reference && (!second || axis.second_reference))) continue;
    letters += letters.empty() ? "" : ", ";
    letters += ir::kAxisLetters[static_cast<std::size_t>(axis.axis)];
  }
  return letters;
}

// What follows from an order whose effect on the moves is known.
void add_consequence(const interpreter::NotInterpreted& one, CheckReport& report) {
  if (!one.effects_known) return;
  const auto add = [&](std::string_view consequence) {
    report.checks.not_checked.add(fmt::format("{}: {}", one.name, consequence), one.first_line);
  };
  if (one.function == ir::Function::other_spindle)
    add("the machine's profile states the limits of the main spindle alone");
  if (one.function == ir::Function::continuous_path)
    add("how far the machine leaves the path to smooth it is the control's; times are estimates");
  if (one.function == ir::Function::feed_per_min) add("it states how feeds count; times are estimates");
}

// Whether what was not carried out leaves it open what the program does; the reason is then among what was not checked.
bool leaves_open(const interpreter::NotInterpreted& one, const Examination& e, bool second_reference,
                 CheckReport& report) {
  if (one.is_model)
    report.checks.not_checked.add(
        fmt::format("{}: the control has its own; times and loads in between are estimates", one.name), one.first_line);
  if (one.effects_known && one.function == ir::Function::data_input)
    report.checks.not_checked.add(
        fmt::format("{}: the program changes the control's tool data, and they stay so after its end", one.name),
        one.first_line);
  add_consequence(one, report);
  const bool is_named_tool = one.effects_known && one.function == ir::Function::tool_change;
  if (is_named_tool && e.profile != nullptr && !e.profile->machine.tools.empty())
    report.checks.not_checked.add(
        fmt::format("{}: which tool this is is not known; \"name\" of the tools in the machine's profile decides this",
                    one.name),
        one.first_line);
  if (one.effects_known) return false;
  if (one.function == ir::Function::reference_return) {
    if (e.profile == nullptr) {
      report.checks.not_checked.add(fmt::format("{}: no machine is named", one.name), one.first_line);
      return false;
    }
    const std::string without = axes_without_reference(*e.profile, second_reference);
    if (without.empty()) return false;
    report.checks.not_checked.add(
        fmt::format("{}: \"reference_mm\"{} of {} in the machine's profile decides this", one.name,
                    second_reference ? " and \"second_reference_mm\"" : "", without),
        one.first_line);
    return true;
  }
  if (one.function == ir::Function::machine_function) {
    report.checks.not_checked.add(
        fmt::format("{}: what it does is not known; \"machine_functions\" of the machine's profile decides this",
                    one.name),
        one.first_line);
    return true;
  }
  report.checks.not_checked.add(fmt::format("{}: {}", one.name, one.is_input ? "input not known" : "not interpreted"),
                                one.first_line);
  return true;
}

// H21 with tool 1 where the profile's tool 1 has the offset 21.
bool is_settled(const text::Diagnostic& one, const machine::Profile* profile) {
  if (one.id != text::DiagnosticId::length_offset_of_other_tool || profile == nullptr) return false;
  return std::ranges::any_of(profile->machine.tools, [&](const checks::Tool& tool) {
    return std::to_string(tool.offset) == one.arguments[0] && "T" + std::to_string(tool.number) == one.arguments[1];
  });
}

// Faults of places: where a number without a point is read as the machine is set, its setting decides them.
bool follows_from_places(text::DiagnosticId id) {
  return id == text::DiagnosticId::arc_radius_mismatch || id == text::DiagnosticId::cycle_shape_not_monotonic;
}

// Whether numbers without a point stand in the text, and no profile says how the machine reads them.
bool decimals_are_open(const CheckReport& report) {
  return std::ranges::any_of(report.checks.diagnostics, [](const text::Diagnostic& one) {
    return one.id == text::DiagnosticId::missing_decimal_point;
  });
}

void leave_to_decimals(text::Diagnostic& diagnostic) {
  diagnostic.severity = text::Severity::warning;
  diagnostic.is_open = true;
  diagnostic.notes.push_back(
      {diagnostic.span, "how the machine reads numbers without a point decides this: write the points"});
}

// A run that an open fault ended did not see the rest.
bool ended_openly(const interpreter::RunResult& run) {
  return run.ended == interpreter::Ended::alarm && !run.diagnostics.empty() &&
         run.diagnostics.back().diagnostic.severity != text::Severity::error;
}

// What the run said: alarms and warnings, and what it met and did not carry out.
void take_run(const interpreter::RunResult& run, const Examination& e, const compile::RunTexts& texts,
              bool second_reference, CheckReport& report) {
  for (const interpreter::RunDiagnostic& one : run.diagnostics) {
    if (is_settled(one.diagnostic, e.profile)) continue;
    text::Diagnostic diagnostic = texts.placed(one, run);
    if (follows_from_places(diagnostic.id) && decimals_are_open(report)) leave_to_decimals(diagnostic);
    report.checks.diagnostics.push_back(std::move(diagnostic));
  }
  for (const interpreter::NotInterpreted& one : run.not_interpreted)
    if (leaves_open(one, e, second_reference, report)) report.checks.has_unknown_effects = true;
  report.programs = run.programs;
  report.blocks = run.blocks;
  report.ran = run.ended == interpreter::Ended::end;
  const bool on_unknown_path = run.ended == interpreter::Ended::alarm && !text::has_error(report.checks.diagnostics);
  if (ended_openly(run) || on_unknown_path) {
    const std::string why = ended_openly(run) ? text::message_of(run.diagnostics.back().diagnostic)
                                              : "the run ended there, on a path that values decide which are not known";
    report.checks.has_unknown_effects = true;
    report.checks.not_checked.add(fmt::format("what follows line {}: {}", run.last.line, why), run.last.line);
  }
  if (run.ended != interpreter::Ended::limit) return;
  report.checks.has_unknown_effects = true;
  report.checks.not_checked.add(fmt::format("what follows line {}: {}", run.last.line, why_ended(run)), run.last.line);
}

// The control alarms on them when it comes to the call.
void take_errors(const compile::ProgramLibrary::Loaded& called, CheckReport& report) {
  const auto source = std::make_shared<const text::Source>(called.read.program.source);
  for (const text::Diagnostic& one : called.read.diagnostics) {
    if (one.severity != text::Severity::error) continue;
    report.checks.diagnostics.push_back(one);
    report.checks.diagnostics.back().elsewhere = source;
  }
  report.checks.has_unknown_effects = true;
  report.checks.not_checked.add(fmt::format("{}: the called program has errors of its own", called.name));
}

// Which programs of the run stand in another text.
Followed::Run run_into(ir::MotionSink& sink, const Examination& e, const ir::Program& program,
                       const compile::ThinProgram* thin, CheckReport& report) {
  const ir::Control control = for_check(e.control);
  compile::ProgramLibrary library(
      control, e.find_called ? e.find_called : [](std::string_view) { return std::nullopt; });
  interpreter::RunOptions options;
  options.used_up = e.used_up;
  if (thin != nullptr) options.stretches = &thin->stretches;
  interpreter::RunResult run = compile::execute(program, control, &library, sink, options);
  if (thin != nullptr) thin->place(run);
  const compile::RunTexts texts(program, library);
  take_run(run, e, texts, goes_to_second_reference(program, library), report);
  bool writes = list_outputs(program, e.control, report.checks.not_checked);
  for (const auto& loaded : library.loaded()) {
    writes |= list_outputs(loaded->read.program, e.control, report.checks.not_checked);
    if (text::has_error(loaded->read.diagnostics)) take_errors(*loaded, report);
  }
  if (writes) report.checks.has_unknown_effects = true;
  std::vector<bool> is_elsewhere;
  for (const std::string& name : run.programs)
    is_elsewhere.push_back(!is_elsewhere.empty() && texts.find(name) != nullptr);
  return {std::move(is_elsewhere), std::move(run.strings)};
}

void run_checks(const Examination& e, const ir::Program& program, const compile::ThinProgram* thin,
                CheckReport& report) {
  Checks checks(e, report);
  compile::FanOut sinks(checks.sinks());
  run_into(sinks, e, program, thin, report);
  checks.finish();
}

// What was taken for granted against the text's own word.
void report_contradiction(const Examination& e, CheckReport& report) {
  if (e.control.contradiction.size() < 2) return;
  const ir::SystemEvidence& a = e.control.contradiction[0];
  const ir::SystemEvidence& b = e.control.contradiction[1];
  const auto letter = [](ir::GSystem system) {
    return std::string(1, static_cast<char>('A' + static_cast<int>(system)));
  };
  const std::string_view line = e.source.line(a.line);
  const auto begin = static_cast<std::uint32_t>(line.data() - e.source.text().data());
  report.checks.diagnostics.push_back(text::make_diagnostic(
      text::DiagnosticId::control_contradicted, {begin, begin + static_cast<std::uint32_t>(line.size())},
      {std::to_string(a.line), a.code, letter(a.system), std::to_string(b.line), b.code, letter(b.system)}));
  report.checks.has_unknown_effects = true;
  report.checks.not_checked.add(
      fmt::format("what the codes do in another G-code system than {}, which was taken", letter(e.control.g_system)));
}

void sort_and_join(std::vector<text::Diagnostic>& diagnostics) {
  // Those of the text itself first, then those of each called program.
  std::ranges::stable_sort(diagnostics, {}, [](const text::Diagnostic& d) {
    return std::pair(d.elsewhere == nullptr ? std::string_view() : std::string_view(d.elsewhere->name()), d.span.begin);
  });
  // What reading and running both saw is stated once.
  const auto same = [](const text::Diagnostic& a, const text::Diagnostic& b) {
    return a.id == b.id && a.span.begin == b.span.begin && a.arguments == b.arguments && a.elsewhere == b.elsewhere;
  };
  diagnostics.erase(std::unique(diagnostics.begin(), diagnostics.end(), same), diagnostics.end());
}

}  // namespace

std::expected<timing::Settings, std::string> timing_settings(const Examination& e, std::string_view text) {
  timing::Settings settings;
  settings.machine = e.profile->machine;
  settings.cost = e.control.cost;
  settings.x_is_diameter = x_is_diameter(e.control, e.profile);
  settings.keep_whole = e.timing.keep_whole;
  settings.wants_curve = e.timing.wants_curve;
  settings.threads = e.timing.threads;
  settings.most_kept = most_kept_motions(text.size());
  if (e.delivery != ir::Delivery::drip || !machine::feeds_characters(e.profile->line.link.kind)) return settings;
  const auto effective = machine::effective_line(e.profile->line);  // the URL's options count
  if (!effective) return std::unexpected(effective.error());
  const machine::LineSettings& line = *effective;
  const double bits = line.framing.bits_per_char();
  settings.line = timing::Line{.baud = static_cast<double>(line.baud),
                               .bits_per_char = bits,
                               .pace = machine::is_blind(line.link.kind) ? feed::kBlindRate : 1.0,
                               .latency_s = line.latency_chars * bits / line.baud,
                               .char_delay_s = line.char_delay_ms * 1e-3,
                               .line_delay_s = line.line_delay_ms * 1e-3};
  settings.line_bytes = bytes_of_lines(text, machine::wire_format_of(line));
  return settings;
}

std::vector<std::uint32_t> bytes_of_lines(std::string_view text, const tape_code::WireFormat& format) {
  std::vector<std::uint32_t> bytes;
  tape_code::WireFormat blocks = format;
  blocks.leader_chars = blocks.trailer_chars = 0;
  // The next of each is looked for when it has been passed: one of the two is often in the whole text not once.
  std::size_t line_feed = text.find('\n');
  std::size_t carriage_return = text.find('\r');
  for (std::size_t begin = 0; begin < text.size();) {
    if (line_feed < begin) line_feed = text.find('\n', begin);
    if (carriage_return < begin) carriage_return = text.find('\r', begin);
    const std::size_t end = std::min({line_feed, carriage_return, text.size()});
    // A block with an even number of characters has an odd one with its EOB.
    const std::uint64_t odd_blocks = (end - begin) % 2 == 0 ? 1 : 0;
    bytes.push_back(static_cast<std::uint32_t>(tape_code::wire_length(blocks, end - begin + 1, 1, odd_blocks)));
    if (end == text.size()) break;
    begin = end + text::eob_length(text, end);
  }
  return bytes;
}

TextReading read_text(const Examination& e, const compile::ThinProgram* thin) {
  TextReading out;
  CheckReport& report = out.report;
  report.source = e.source;
  report.dialect = e.dialect->name;
  report.control_title = e.control.title;
  report.kind = e.control.kind;
  report.g_system = e.control.g_system;
  report.feed_mode = feed_mode_of(e.control.semantics.power_on_feed);
  report.because_line = e.control.because_line;
  report.inferred = e.inferred;

  if (thin == nullptr) out.read = e.dialect->read(e.source, e.control);
  const ir::ReadResult& read = thin == nullptr ? out.read : thin->read_result;
  std::vector<text::Diagnostic>& diagnostics = report.checks.diagnostics;
  diagnostics = read.diagnostics;
  out.readable = !text::has_error(diagnostics);
  auto more = e.dialect->validate(read.program, e.control, e.delivery);
  diagnostics.insert(diagnostics.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  check_characters(e, read.program, diagnostics);
  if (thin != nullptr) thin->place(diagnostics);
  if (e.geometry) {
    if (auto fault = compile::fault_of_machine(e.geometry->machine, e.control))
      diagnostics.push_back(std::move(*fault));
  }
  report_contradiction(e, report);
  sort_and_join(diagnostics);
  return out;
}

namespace {

// Calls run(e, program, thin, report) where the text can be run.
template <class Run>
CheckReport examine_by(const Examination& given, Run run) {
  Examination e = given;
  e.control = compile::with_definitions(std::move(e.control), e.find_called);
  const auto thin = compile::ThinProgram::read(e.source, *e.dialect, e.control);
  TextReading text = read_text(e, thin.get());
  CheckReport& report = text.report;
  if (text.readable) {
    run(e, thin == nullptr ? text.read.program : thin->read_result.program, thin.get(), report);
  } else {
    report.checks.not_checked.add("what the program does: it has errors that keep it from being run");
  }
  for (const std::string& one : e.assumed) report.checks.not_checked.add(one);
  sort_and_join(report.checks.diagnostics);
  warn_once(report.checks.diagnostics);
  return std::move(report);
}

}  // namespace

CheckReport examine(const Examination& examination) {
  CheckReport report = examine_by(examination, run_checks);
  report.verdict = checks::verdict_of(report.checks);
  return report;
}

Followed follow(const Examination& examination, ir::MotionSink& sink) {
  Followed out;
  out.report =
      examine_by(examination, [&](const Examination& e, const ir::Program& program, const compile::ThinProgram* thin,
                                  CheckReport& report) { out.run = run_into(sink, e, program, thin, report); });
  return out;
}

}  // namespace dripfeed::app
