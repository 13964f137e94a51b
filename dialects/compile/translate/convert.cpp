// Reading, refusing what has no meaning, the passes, and reading again what they wrote.
#include "dialects/compile/translate/convert.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/dialect/source_lines.h"
#include "dialects/compile/dialect/target_axes.h"
#include "dialects/compile/translate/convert_thin.h"
#include "dialects/compile/translate/converter.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

enum class Side : std::uint8_t { none, begin, end };
Side side_of(ir::StatementKind kind) {
  using enum ir::StatementKind;
  switch (kind) {
    case if_begin:
    case while_begin:
    case repeat_begin:
    case for_begin:
    case loop_begin: return Side::begin;
    case else_begin:
    case if_end:
    case while_end:
    case repeat_end:
    case for_end:
    case loop_end: return Side::end;
    case empty:
    case block:
    case assign:
    case go_to:
    case define:
    case call:
    case procedure:
    case declaration:
    case subprogram_return:
    case return_to:
    case modal_call:
    case modal_call_end:
    case output:
    case program_end:
    case message:
    case alarm:
    case native:
    case repeat_section:
    case execute_text: return Side::none;
  }
  return Side::none;
}

// Structures without their other end: readers leave them to validation, and no control has words for half of one.
std::vector<text::Diagnostic> unmatched_structures(const ir::Program& program, const ir::Control& control) {
  std::vector<text::Diagnostic> out;
  for (const ir::Statement& s : program.statements) {
    const Side side = side_of(s.kind);
    if (side == Side::none || program.structures[s.payload].partner != ir::kNoIndex) continue;
    const std::string_view written = s.span.in(program.source.text());
    const std::string word(written.substr(0, written.find_first_of(" \t[(")));
    const bool begins = side == Side::begin;
    out.push_back(ir::diagnose(control,
                               begins ? text::DiagnosticId::missing_end : text::DiagnosticId::end_without_begin, s.span,
                               {word, begins ? "end" : "beginning"}));
  }
  return out;
}

}  // namespace

void Converter::add(std::vector<text::Diagnostic> diagnostics) {
  std::ranges::move(diagnostics, std::back_inserter(result_.diagnostics));
}

ConvertResult Converter::convert() {
  if (&from_ == &to_ && request_.mode == ConvertMode::macro) {
    result_.text = request_.source.text();
    return std::move(result_);
  }
  translate();
  drop_repeated_diagnostics();
  refuse_long_blocks();
  proofread();
  return std::move(result_);
}

// The program that was read is gone before its translation is: each takes some hundred bytes a block.
void Converter::translate() {
  ir::ReadResult read = from_.read(request_.source, request_.from);
  add(std::move(read.diagnostics));
  add(unmatched_structures(read.program, request_.from));
  if (!has_error()) refuse_faulty(read.program);
  if (has_error()) return;
  for (const TranslationPass& pass : passes_of(request_.mode))
    if (!(this->*pass.run)(read.program)) return;
}

// A statement that could not be written as its moves has its reason already: what raising reports of it is left out.
void Converter::drop_repeated_diagnostics() {
  const auto begin = result_.diagnostics.begin() + static_cast<std::ptrdiff_t>(diagnostics_before_);
  const auto is_repeated = [&](const text::Diagnostic& one) {
    return passes::is_refusal(one.id) &&
           std::any_of(result_.diagnostics.begin(), begin, [&](const text::Diagnostic& earlier) {
             return passes::is_refusal(earlier.id) && earlier.severity == text::Severity::error &&
                    earlier.span.begin <= one.span.begin && one.span.begin < earlier.span.end;
           });
  };
  result_.diagnostics.erase(std::remove_if(begin, result_.diagnostics.end(), is_repeated), result_.diagnostics.end());
}

// What its own control would alarm on has no meaning that could be translated. A name that is not defined may be the
// control's global data: raising reports where that matters.
void Converter::refuse_faulty(const ir::Program& program) {
  std::vector<text::Diagnostic> found = from_.validate(program, request_.from, ir::Delivery::memory);
  std::erase_if(found, [](const text::Diagnostic& one) {
    return one.severity != text::Severity::error || one.id == text::DiagnosticId::unknown_name;
  });
  add(std::move(found));
}

// A block that is too long for the other control is refused at the line that it came from.
void Converter::refuse_long_blocks() {
  const std::size_t most = request_.to.limits.block_length_bytes;
  if (most == 0) return;
  std::size_t begin = 0;
  for (std::size_t line = 0; begin < result_.text.size(); ++line) {
    const std::size_t end = std::min(result_.text.find('\n', begin), result_.text.size());
    if (end - begin > most) refuse_long_block(line, end - begin);
    begin = end + 1;
  }
  if (text::has_error(result_.diagnostics)) result_.text.clear();
}

// `line`: of the translation, from 0.
void Converter::refuse_long_block(std::size_t line, std::size_t bytes) {
  result_.diagnostics.push_back(
      ir::diagnose(request_.to, text::DiagnosticId::block_too_long, span_of_origin(line),
                   {std::to_string(bytes), std::to_string(request_.to.limits.block_length_bytes)}));
}

// The line of the source that a line of the translation, from 0, came from; empty where none did.
text::Span Converter::span_of_origin(std::size_t line) const {
  const std::uint32_t origin = line < result_.origin_lines.size() ? result_.origin_lines[line] : 0;
  return span_of_line(request_.source, origin);
}

// What the other control would alarm on is no translation either.
void Converter::proofread() {
  if (result_.text.empty() || text::has_error(result_.diagnostics)) return;
  const text::Source written("translation", result_.text);
  ir::ReadResult read = to_.read(written, request_.to);
  std::ranges::move(to_.validate(read.program, request_.to, ir::Delivery::memory),
                    std::back_inserter(read.diagnostics));
  for (text::Diagnostic& one : read.diagnostics) {
    if (one.severity != text::Severity::error) continue;
    const std::uint32_t line = written.position(one.span.begin).line;
    one.span = span_of_origin(line - 1);
    // The alarm is the other control's.
    const std::string alarm = one.alarm.empty() ? "" : ", which is " + one.alarm + " on " + request_.to.title;
    one.alarm.clear();
    one.notes = {{.span = one.span, .text = "translated to \"" + std::string(written.line(line)) + "\"" + alarm}};
    result_.diagnostics.push_back(std::move(one));
  }
  if (!text::has_error(result_.diagnostics)) {
    add(inline_moves_.compare(read.program, result_.origin_lines));
    result_.not_verified = inline_moves_.not_compared();
  }
  if (text::has_error(result_.diagnostics)) result_.text.clear();
}

namespace {

ConvertResult convert_once(const ConvertRequest& request) {
  auto thin = convert_thin(request);
  return thin ? std::move(*thin) : convert_whole(request);
}

// Whether plain blocks would do where a macro does not: found out by writing them.
void note_whether_explicit_does(const ConvertRequest& request, ConvertResult& result) {
  const auto refusal = std::ranges::find_if(result.diagnostics, [](const text::Diagnostic& d) {
    return d.severity == text::Severity::error && passes::is_refusal(d.id);
  });
  const bool same_control = request.from.dialect == request.to.dialect;
  if (request.mode != ConvertMode::macro || same_control || refusal == result.diagnostics.end()) return;
  ConvertRequest plain = request;
  plain.mode = ConvertMode::explicit_blocks;
  const bool does = !convert_once(plain).text.empty();
  refusal->notes.push_back(
      {.span = refusal->span,
       .text = does ? "in explicit mode the whole program can be translated, as the moves that it makes now"
                    : "in explicit mode this program cannot be translated either"});
}

}  // namespace

ConvertResult convert(const ConvertRequest& request) {
  ConvertResult result = convert_once(request);
  note_whether_explicit_does(request, result);
  return result;
}

ConvertResult convert_whole(const ConvertRequest& request) {
  const Dialect* from = find_dialect(request.from.dialect);
  const Dialect* to = find_dialect(request.to.dialect);
  if (from != nullptr && to != nullptr) {
    ConvertRequest own = request;
    if (!own.to.from_profile) own.to.axes = joint_axes(own.to, own.from);
    return Converter(own, *from, *to).convert();
  }
  ConvertResult out;
  const std::string& unknown = from == nullptr ? request.from.dialect : request.to.dialect;
  out.diagnostics.push_back(passes::diagnose("the program", {}, unknown));
  return out;
}

}  // namespace dripfeed::compile
