// The parts are read out of a copy of the text in which everything else is blank, so that every place stays where it
// is.
#include "dialects/compile/dialect/iso_mode.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <tuple>

#include "dialects/fanuc/fanuc.h"
#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

constexpr bool ends_line(char c) { return c == '\n' || c == '\r'; }

// Capital letters, as small ones mean the same on this control. Without what a semicolon makes a comment, as in Siemens
// mode (in brackets it is part of one already), and without the % of a tape and the O number of a program, which begin
// and end nothing inside of a text.
void copy_part(std::string_view from, std::span<char> to) {
  enum class Place : std::uint8_t { line_begin, program_number, block, comment };
  Place place = Place::line_begin;
  int brackets = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const char c = from[i] >= 'a' && from[i] <= 'z' ? static_cast<char>(from[i] - 'a' + 'A') : from[i];
    if (ends_line(c)) {
      brackets = 0;
      place = Place::line_begin;
      continue;
    }
    brackets += static_cast<int>(c == '(') - static_cast<int>(c == ')');
    if ((c == ';' && brackets <= 0) || (c == '%' && place == Place::line_begin))
      place = Place::comment;
    else if (c == 'O' && place == Place::line_begin)
      place = Place::program_number;
    else if (place == Place::program_number ? c < '0' || c > '9' : place == Place::line_begin && c != ' ' && c != '\t')
      place = Place::block;
    if (place == Place::block) to[i] = c;
  }
}

std::string text_of_parts(const ir::Program& host) {
  const std::string_view whole = host.source.text();
  std::string text(whole);
  std::ranges::replace_if(text, [](char c) { return !ends_line(c); }, ' ');
  for (const ir::ForeignPart& part : host.foreign_parts)
    copy_part(part.text.in(whole), std::span(text).subspan(part.text.begin, part.text.size()));
  return text;
}

std::uint32_t add_native(ir::Program& program, std::string_view name, bool moves) {
  program.natives.push_back({.name = program.strings.add(name), .effects_known = false, .moves = moves});
  return static_cast<std::uint32_t>(program.natives.size() - 1);
}

// What a block of Siemens mode has set no one sees here: the blank before each part stands for it.
void mark_blocks_before_parts(const ir::Program& host, ir::Program& iso) {
  const auto begin_of = [](const ir::Statement& s) { return s.span.begin; };
  for (const ir::ForeignPart& part : host.foreign_parts) {
    const auto first = std::ranges::lower_bound(iso.statements, part.text.begin, {}, begin_of);
    if (first == iso.statements.begin() || std::prev(first)->kind != StatementKind::empty) continue;
    std::prev(first)->kind = StatementKind::native;
    std::prev(first)->payload = add_native(iso, "blocks in Siemens mode", true);
  }
}

bool is_of_iso_mode(StatementKind kind) {
  constexpr StatementKind kKinds[] = {
      StatementKind::empty,      StatementKind::block,          StatementKind::call,
      StatementKind::modal_call, StatementKind::modal_call_end, StatementKind::subprogram_return,
      StatementKind::return_to,  StatementKind::program_end,    StatementKind::native};
  return std::ranges::find(kKinds, kind) != std::end(kKinds);
}

bool has_variables(const ir::Program& program, const ir::Statement& first) {
  const auto tokens = std::span(program.tokens).subspan(first.tokens.first, first.tokens.last - first.tokens.first);
  return std::ranges::any_of(tokens, [&](const ir::Token& t) {
    return t.kind != ir::TokenKind::comment &&
           t.span.in(program.source.text()).find_first_of("#[") != std::string::npos;
  });
}

// Variables, conditions and loops.
void keep_macro_language(ir::Program& iso) {
  bool macro = false;
  for (ir::Statement& s : iso.statements) {
    const bool begins_block = s.tokens.first < s.tokens.last;
    if (begins_block) macro = has_variables(iso, s);
    if (!macro && is_of_iso_mode(s.kind)) continue;
    s.kind = StatementKind::native;
    s.payload = add_native(iso, "Custom Macro B in ISO mode", true);
  }
}

// M17 returns as M99 does.
std::span<const ir::CodeRow> iso_m_codes() {
  static const std::vector<ir::CodeRow> rows = [] {
    const ir::Control fanuc = fanuc::control(ir::MachineKind::mill, ir::GSystem::a);
    std::vector<ir::CodeRow> all(fanuc.m_codes.begin(), fanuc.m_codes.end());
    ir::CodeRow m17 = *ir::find_code(all, 990);
    m17.name = "M17";
    m17.number10 = 170;
    m17.reference = "Function Manual ISO Dialects, subprograms";
    std::erase_if(all, [](const ir::CodeRow& row) { return row.number10 == 170; });
    all.push_back(m17);
    std::ranges::sort(all, {}, &ir::CodeRow::number10);
    return all;
  }();
  return rows;
}

// A part is not a program: what every program has, its host has, and which branch the run takes is to be seen there.
bool concerns_host(const text::Diagnostic& d) {
  constexpr DiagnosticId kIds[] = {DiagnosticId::missing_program_number, DiagnosticId::missing_tape_mark,
                                   DiagnosticId::missing_program_end, DiagnosticId::unreachable,
                                   DiagnosticId::endless_loop};
  return std::ranges::find(kIds, d.id) != std::end(kIds);
}

void join(std::vector<text::Diagnostic>& all, std::vector<text::Diagnostic> more, const ir::Program& host) {
  const auto is_outside = [&host](const text::Diagnostic& d) {
    const auto begin_of = [](const ir::ForeignPart& part) { return part.text.begin; };
    const auto next = std::ranges::upper_bound(host.foreign_parts, d.span.begin, {}, begin_of);
    return next == host.foreign_parts.begin() || std::prev(next)->text.end <= d.span.begin;
  };
  std::erase_if(more, [&](const text::Diagnostic& d) { return concerns_host(d) || is_outside(d); });
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  std::ranges::sort(all, {}, [](const text::Diagnostic& d) { return std::tuple(d.span.begin, d.id, d.span.end); });
}

}  // namespace

bool has_iso_mode(const ir::Control& control) { return control.dialect == "sinumerik-840d"; }

ir::Control iso_control(const ir::Control& sinumerik) {
  ir::Control c = fanuc::control(sinumerik.kind, sinumerik.g_system);
  c.title = sinumerik.title + ", ISO mode";
  c.axes = sinumerik.axes;
  c.m_codes = iso_m_codes();
  c.alarms = sinumerik::iso_alarms();
  c.limits.block_length_bytes = sinumerik.limits.block_length_bytes;
  c.limits.call_nesting = sinumerik.limits.call_nesting;
  c.limits.macro_nesting = sinumerik.limits.macro_nesting;
  c.cost = sinumerik.cost;
  c.code_calls = sinumerik.code_calls;
  c.machine_functions = sinumerik.machine_functions;
  c.from_profile = sinumerik.from_profile;
  ir::Semantics& s = c.semantics;
  const ir::Semantics& own = sinumerik.semantics;
  s.decimal_mode = own.iso_decimal_mode;
  s.decimal_mode_confirmed = own.iso_decimal_mode_confirmed;
  s.least_increment_mm = own.least_increment_mm;
  s.least_increment_deg = own.least_increment_deg;
  // A mill's X is a radius and a lathe's a diameter as in Siemens mode: positions are kept through the switch.
  s.power_on_diameter = own.power_on_diameter;
  s.power_on_known = own.power_on_known;
  s.arc_tolerance_mm = own.arc_tolerance_mm;
  s.arc_tolerance_factor = own.arc_tolerance_factor;
  s.arc_without_center_is_line = false;
  s.chip_break_retract_mm = own.chip_break_retract_mm;
  s.peck_clearance_mm = own.peck_clearance_mm;
  s.cycle_depth_mm = own.cycle_depth_mm;
  s.cycle_retract_mm = own.cycle_retract_mm;
  s.end_in_subprogram_returns = own.end_in_subprogram_returns;
  return c;
}

ir::ReadResult read_iso_parts(const ir::Program& host, const ir::Control& iso) {
  ir::ReadResult result = fanuc::Stages::read(text::Source(std::string(host.source.name()), text_of_parts(host)), iso);
  keep_macro_language(result.program);
  mark_blocks_before_parts(host, result.program);
  return result;
}

bool begins_with_procedure(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty() || line.front() == ';' || line.front() == '%' || line.front() == '(') continue;
    if ((line.front() == 'N' || line.front() == 'n') && line.size() > 1 && line[1] >= '0' && line[1] <= '9') {
      line.remove_prefix(std::min(line.find_first_not_of("0123456789", 1), line.size()));
      line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    }
    constexpr std::string_view kProc = "PROC ";
    return line.size() > kProc.size() && std::ranges::equal(line.substr(0, kProc.size()), kProc, {}, [](char c) {
             return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c == '\t' ? ' ' : c;
           });
  }
  return false;
}

ir::ReadResult read_sinumerik(const text::Source& source, const ir::Control& control) {
  ir::ReadResult result = sinumerik::read(source, control);
  if (!result.program.foreign_parts.empty())
    join(result.diagnostics, read_iso_parts(result.program, iso_control(control)).diagnostics, result.program);
  sinumerik::soften_unreached(result.program, result.diagnostics);
  return result;
}

std::vector<text::Diagnostic> validate_sinumerik(const ir::Program& program, const ir::Control& control,
                                                 ir::Delivery delivery) {
  std::vector<text::Diagnostic> found = sinumerik::validate(program, control, delivery);
  if (!program.foreign_parts.empty()) {
    const ir::Control iso = iso_control(control);
    const ir::ReadResult parts = read_iso_parts(program, iso);
    join(found, fanuc::Stages::validate(parts.program, iso, delivery), program);
    join(found, sinumerik::validate_iso(parts.program, iso), program);
  }
  sinumerik::soften_unreached(program, found);
  return found;
}

}  // namespace dripfeed::compile
