// Three ways: the bytes themselves, raise and print, or run, raise and print.
#include "dialects/compile/convert.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "dialects/compile/call_levels.h"
#include "dialects/compile/carry_comments.h"
#include "dialects/compile/common_numbers.h"
#include "dialects/compile/convert_thin.h"
#include "dialects/compile/definition_files.h"
#include "dialects/compile/dialect.h"
#include "dialects/compile/explicit_program.h"
#include "dialects/compile/lower_turning.h"
#include "dialects/compile/machine_moves.h"
#include "dialects/compile/moves_in_place.h"
#include "dialects/compile/own_cycles.h"
#include "dialects/compile/parameter_calls.h"
#include "dialects/compile/print_for.h"
#include "dialects/compile/settle_faces.h"
#include "dialects/compile/several_programs.h"
#include "dialects/compile/source_lines.h"
#include "dialects/compile/splice_iso.h"
#include "dialects/compile/target_axes.h"
#include "dialects/compile/thread_leads.h"
#include "dialects/passes/absolute_centers.h"
#include "dialects/passes/arc_words.h"
#include "dialects/passes/labels.h"
#include "dialects/passes/machine_functions.h"
#include "dialects/passes/main_return.h"
#include "dialects/passes/polar_positions.h"
#include "dialects/passes/rigid_taps.h"
#include "dialects/passes/safe_start.h"
#include "dialects/passes/settle_modes.h"
#include "dialects/passes/structures.h"

namespace dripfeed::compile {

namespace {

void append(std::vector<text::Diagnostic>& out, std::vector<text::Diagnostic> more) {
  out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

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

bool repeats_a_part(const ir::Statement& s) { return s.kind == ir::StatementKind::repeat_section; }

constexpr std::uint32_t kHighestBlockNumber = 9999;  // that all of them take

// Operators find their place by the block numbers: the first block that a numbered line makes has its number.
void number_blocks(const ir::Program& program, ExplicitProgram& made) {
  std::map<std::uint32_t, std::uint32_t> numbers;  // by line
  for (const ir::Label& label : program.labels)
    if (label.number != ir::kNoIndex) numbers.try_emplace(program.statements[label.statement].line, label.number);
  for (std::uint32_t i = 0; i < made.program.statements.size() && !numbers.empty(); ++i) {
    const std::uint32_t origin = made.program.statements[i].line;
    const auto number = origin == 0 ? numbers.end() : numbers.find(made.origins[origin - 1].line);
    if (number == numbers.end()) continue;
    ir::Label label;
    label.number = number->second;
    label.statement = i;
    made.program.labels.push_back(label);
    numbers.erase(number);
  }
}

class Converter {
 public:
  Converter(const ConvertRequest& request, const Dialect& from, const Dialect& to)
      : request_(request), from_(from), to_(to), in_place_(request.from, request.to, request.library, request.limits) {}

  ConvertResult convert() {
    if (&from_ == &to_ && request_.mode == ConvertMode::macro) {
      result_.text = request_.source.text();
      return std::move(result_);
    }
    translate();
    forget_what_is_told();
    refuse_long_blocks();
    proofread();
    return std::move(result_);
  }

 private:
  // The program that was read is gone before its translation is: each takes some hundred bytes a block.
  void translate() {
    ir::ReadResult read = from_.read(request_.source, request_.from);
    append(result_.diagnostics, std::move(read.diagnostics));
    append(result_.diagnostics, unmatched_structures(read.program, request_.from));
    if (!text::has_error(result_.diagnostics)) refuse_faulty(read.program);
    if (text::has_error(result_.diagnostics)) return;
    append(result_.diagnostics, unlike_machine_moves(read.program, request_.from, request_.to));
    if (request_.mode == ConvertMode::macro)
      append(result_.diagnostics, own_cycles(read.program, request_.to, request_.library));
    if (request_.mode == ConvertMode::macro) {
      if (!ir::has_numbered_variables(request_.to)) passes::returns_of_main_as_jumps(read.program);
      if (uses_iso_mode(read.program)) {
        in_place_.run_as(read.program);
        append(result_.diagnostics, splice_iso_parts(read.program, request_.from, request_.to));
        if (text::has_error(result_.diagnostics)) return;
      }
      append(result_.diagnostics, in_place_.lower(read.program));
      told_ = result_.diagnostics.size();
      // A contour is entered from its cycle, which the steps behind this do not know.
      if (read.program.sections.size() > 1 && text::has_error(result_.diagnostics)) return;
      append(result_.diagnostics, settle_leads(read.program, request_.from, request_.to));
      append(result_.diagnostics, lower_turning(read.program, request_.from, request_.to));
      append(result_.diagnostics, settle_faces(read.program, request_.from, request_.to));
      append(result_.diagnostics, passes::settle_taps(read.program, request_.from, request_.to));
    }
    append(result_.diagnostics, passes::foreign_machine_functions(read.program, request_.from, request_.to));
    if (request_.mode == ConvertMode::macro) {
      // One program is the whole text, however many statements it gets.
      if (read.program.sections.size() == 1) read.program.sections.clear();
      if (read.program.sections.empty()) lower(read.program);
      settle(read.program);
      if (&from_ != &to_ && ir::has_numbered_variables(request_.to))
        call_parameters_as_macros(read.program, request_.library);
      if (read.program.sections.size() > 1) {
        drop_unread_arguments(read.program, request_.from, request_.to);
        common_.emplace(read.program, request_.from, request_.to, request_.library);
        several(read.program);
      } else {
        print(read.program, request_.from);
      }
      if (!text::has_error(result_.diagnostics)) comments(read.program);
    } else {
      in_place_.watch(read.program, true);
      explicit_blocks(read.program);
    }
  }

  // Of a statement that could not be written as its moves, the reason is told; what raising says of it then is no more.
  void forget_what_is_told() {
    const auto begin = result_.diagnostics.begin() + static_cast<std::ptrdiff_t>(told_);
    const auto is_told = [&](const text::Diagnostic& one) {
      return one.id == text::DiagnosticId::cannot_translate &&
             std::any_of(result_.diagnostics.begin(), begin, [&](const text::Diagnostic& earlier) {
               return earlier.id == one.id && earlier.severity == text::Severity::error &&
                      earlier.span.begin <= one.span.begin && one.span.begin < earlier.span.end;
             });
    };
    result_.diagnostics.erase(std::remove_if(begin, result_.diagnostics.end(), is_told), result_.diagnostics.end());
  }

  // What its own control would alarm on has no meaning that could be translated. A name that is not defined may be the
  // control's global data: raising tells where that matters.
  void refuse_faulty(const ir::Program& program) {
    std::vector<text::Diagnostic> found = from_.validate(program, request_.from, ir::Delivery::memory);
    std::erase_if(found, [](const text::Diagnostic& one) {
      return one.severity != text::Severity::error || one.id == text::DiagnosticId::unknown_name;
    });
    append(result_.diagnostics, std::move(found));
  }

  void print(const ir::Program& program, const ir::Control& from) {
    append(result_.diagnostics, foreign_axis_words(program, from, request_.to));
    ir::RaiseResult raised = raise(program, from);
    append(result_.diagnostics, std::move(raised.diagnostics));
    if (text::has_error(result_.diagnostics)) return;
    ir::PrintResult printed = print_for(to_, raised.program, request_.to);
    result_.text = std::move(printed.text);
    result_.origin_lines = std::move(printed.origin_lines);
  }

  // What only one of the two can say, before anything is asked of the ways through the program.
  void lower(ir::Program& program) {
    if (&from_ == &to_) return;
    if (!ir::has_numbered_variables(request_.to)) {
      append(result_.diagnostics, passes::lower_computed_jumps(program).diagnostics);
    } else if (std::ranges::any_of(program.statements, repeats_a_part)) {
      passes::FreeNumbers numbers(program, kHighestBlockNumber);
      append(result_.diagnostics, passes::lower_repeated_parts(program, numbers).diagnostics);
    }
    // Behind the jumps that repeat: they lead there with other modes, too.
    append(result_.diagnostics, passes::lower_polar_positions(program, request_.from, request_.to));
  }

  // With what the control's definition files declare; what was run has it by then.
  ir::RaiseResult raise(const ir::Program& program, const ir::Control& from) {
    const bool alone = request_.library == nullptr || request_.mode != ConvertMode::macro || &from_ == &to_;
    if (alone || from.definition_files.empty()) return raise_with_room(program, from);
    ir::Program defined = program;
    add_definitions(defined, from, *request_.library);
    return raise_with_room(defined, from);
  }

  // Local variables are what a program may always have; common ones only where nothing that runs with it has them.
  ir::RaiseResult raise_with_room(const ir::Program& program, const ir::Control& from) {
    ir::RaiseResult raised = to_.raise(program, from, request_.to);
    const bool too_few = std::ranges::any_of(
        raised.diagnostics, [](const text::Diagnostic& d) { return d.id == text::DiagnosticId::not_enough_variables; });
    if (too_few && !common_) common_.emplace(program, from, request_.to, request_.library);
    if (too_few)
      if (const auto wider = common_->control_for(program.name)) raised = to_.raise(program, from, *wider);
    if (common_ && !text::has_error(raised.diagnostics)) common_->took(program.name, raised.program);
    return raised;
  }

  // What the other control would take otherwise, if it were only printed.
  void settle(ir::Program& program) {
    append(result_.diagnostics, passes::settle_modes(program, request_.from, request_.to));
    append(result_.diagnostics, passes::settle_arcs(program, request_.from, request_.to));
    append(result_.diagnostics, passes::settle_centers(program, request_.from, request_.to));
  }

  void several(const ir::Program& text) {
    append(result_.diagnostics, foreign_axis_words(text, request_.from, request_.to));
    JoinedPrograms joined(text, request_.to);
    CallLevels levels;
    for (const ir::Section& section : text.sections) {
      ir::Program program = program_of(text, section);
      lower(program);
      ir::RaiseResult raised = raise(program, request_.from);
      append(result_.diagnostics, std::move(raised.diagnostics));
      raised.program.name = joined.name_there(program);
      levels.add(raised.program.name, raised.program);
      if (!text::has_error(result_.diagnostics))
        joined.add(program, raised.program, print_for(to_, raised.program, request_.to));
    }
    append(result_.diagnostics, joined.diagnostics());
    append(result_.diagnostics, levels.too_deep(request_.to));
    if (text::has_error(result_.diagnostics)) return;
    ir::PrintResult printed = joined.take();
    result_.text = std::move(printed.text);
    result_.origin_lines = std::move(printed.origin_lines);
  }

  void comments(const ir::Program& program) {
    ir::PrintResult printed{.text = std::move(result_.text), .origin_lines = std::move(result_.origin_lines)};
    carry_comments(program, request_.to, to_.comments, printed, result_.diagnostics);
    result_.text = std::move(printed.text);
    result_.origin_lines = std::move(printed.origin_lines);
  }

  // What the other control would not read is no translation: its length is told at the line that it came from.
  void refuse_long_blocks() {
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
  void refuse_long_block(std::size_t line, std::size_t bytes) {
    result_.diagnostics.push_back(
        ir::diagnose(request_.to, text::DiagnosticId::block_too_long, span_of_origin(line),
                     {std::to_string(bytes), std::to_string(request_.to.limits.block_length_bytes)}));
  }

  // The line of the source that a line of the translation, from 0, came from; empty where none did.
  [[nodiscard]] text::Span span_of_origin(std::size_t line) const {
    const std::uint32_t origin = line < result_.origin_lines.size() ? result_.origin_lines[line] : 0;
    return span_of_line(request_.source, origin);
  }

  // What the other control would alarm on is no translation either.
  void proofread() {
    if (result_.text.empty() || text::has_error(result_.diagnostics)) return;
    const text::Source written("translation", result_.text);
    ir::ReadResult read = to_.read(written, request_.to);
    append(read.diagnostics, to_.validate(read.program, request_.to, ir::Delivery::memory));
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
      append(result_.diagnostics, in_place_.compare(read.program, result_.origin_lines));
      result_.not_verified = in_place_.not_compared();
    }
    if (text::has_error(result_.diagnostics)) result_.text.clear();
  }

  void say_skip_decided(const ir::Program& program) {
    for (const ir::Statement& s : program.statements) {
      const bool rest = s.kind == ir::StatementKind::block && program.blocks[s.payload].rest_level != 0;
      if (s.skip_level == 0 && !rest) continue;
      result_.diagnostics.push_back(ir::diagnose(request_.from, text::DiagnosticId::block_skip_decided, s.span, {}));
      return;
    }
  }

  void explicit_blocks(const ir::Program& program) {
    interpreter::ProgramFinder& none = interpreter::no_programs();
    interpreter::ProgramFinder& finder = request_.library == nullptr ? none : *request_.library;
    ExplicitProgram made = explicit_program(program, request_.from, finder,
                                            {.limits = request_.limits, .initial_values = {}, .own_unit = true});
    const ProgramLibrary nothing(request_.from, {});
    const RunTexts texts(program, request_.library == nullptr ? nothing : *request_.library);
    append(result_.diagnostics, run_faults(made, texts));
    say_skip_decided(program);
    append(result_.diagnostics, passes::assumed_modes(program, request_.from));
    append(result_.diagnostics, passes::unsaid_modes(program, request_.from, false).diagnostics);
    if (text::has_error(result_.diagnostics)) return;
    number_blocks(program, made);
    print(made.program, made.control);
    if (text::has_error(result_.diagnostics)) return;
    for (std::uint32_t& line : result_.origin_lines) {
      if (line != 0) line = made.origins[line - 1].line;
    }
    comments(program);
  }

  const ConvertRequest& request_;
  const Dialect& from_;
  const Dialect& to_;
  MovesInPlace in_place_;
  std::size_t told_ = 0;  // diagnostics up to those of in_place_
  std::optional<CommonNumbers> common_;
  ConvertResult result_;
};

}  // namespace

ConvertResult convert(const ConvertRequest& request) {
  auto thin = convert_thin(request);
  return thin ? std::move(*thin) : convert_whole(request);
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
  out.diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::cannot_translate, {}, {"the program", unknown}));
  return out;
}

}  // namespace dripfeed::compile
