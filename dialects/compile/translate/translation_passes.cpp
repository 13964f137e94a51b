// The passes of a translation, one list for each mode. A pass changes the program, or refuses what it cannot say in the
// other control's words; what it refuses does not keep the next ones from being heard, unless it returns false.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "dialects/compile/dialect/definition_files.h"
#include "dialects/compile/dialect/print_for.h"
#include "dialects/compile/dialect/target_axes.h"
#include "dialects/compile/plain/explicit_program.h"
#include "dialects/compile/plain/machine_moves.h"
#include "dialects/compile/translate/call_levels.h"
#include "dialects/compile/translate/carry_comments.h"
#include "dialects/compile/translate/converter.h"
#include "dialects/compile/translate/lower_turning.h"
#include "dialects/compile/translate/own_cycles.h"
#include "dialects/compile/translate/parameter_calls.h"
#include "dialects/compile/translate/several_programs.h"
#include "dialects/compile/translate/splice_iso.h"
#include "dialects/compile/translate/thread_leads.h"
#include "dialects/compile/translate/translate_faces.h"
#include "dialects/passes/absolute_centers.h"
#include "dialects/passes/arc_words.h"
#include "dialects/passes/explicit_modes.h"
#include "dialects/passes/labels.h"
#include "dialects/passes/machine_functions.h"
#include "dialects/passes/main_return.h"
#include "dialects/passes/polar_positions.h"
#include "dialects/passes/rigid_taps.h"
#include "dialects/passes/safe_start.h"
#include "dialects/passes/shifted_increments.h"
#include "dialects/passes/structures.h"

namespace dripfeed::compile {

namespace {

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

}  // namespace

std::span<const TranslationPass> Converter::passes_of(ConvertMode mode) {
  using C = Converter;
  static constexpr std::array kMacro = {
      TranslationPass{"axes that only one of the machines has", "on the program as written", &C::refuse_unlike_axes},
      TranslationPass{"cycles of the shop's own", "a program that is named like a standard cycle is not a cycle",
                      &C::refuse_own_cycles},
      TranslationPass{"M99 of a main program", "later passes see jumps alone", &C::translate_main_returns},
      TranslationPass{"parts in ISO mode", "from here on the program has one language", &C::splice_iso},
      TranslationPass{"statements without an equal, as their moves",
                      "the source is run: no pass before it has changed what it does", &C::write_as_moves},
      TranslationPass{"leads of threads", "cycles are lowered with the leads that they then have",
                      &C::translate_thread_leads},
      TranslationPass{"turning and thread cycles", "their blocks have modes, which are settled below",
                      &C::lower_turning_cycles},
      TranslationPass{"moves on a face or a cylinder", "before the modes: it begins and ends with some",
                      &C::translate_faces_and_cylinders},
      TranslationPass{"rigid taps", "before the modes: a tap changes the feed in effect", &C::translate_rigid_taps},
      TranslationPass{"M functions of the machine", "what is left of them is the program's own",
                      &C::refuse_machine_functions},
      TranslationPass{"computed jumps, repeated parts, polar positions",
                      "before anything is asked of the paths through the program", &C::lower_flow},
      TranslationPass{"increments after a change of the frame", "polar positions are coordinates by now",
                      &C::place_shifted_increments},
      TranslationPass{"modes, arcs and centres", "on the paths as they will be", &C::make_modes_explicit},
      TranslationPass{"calls with parameters", "the letters of a macro are taken last: all uses are known",
                      &C::call_as_macros},
      TranslationPass{"raise and print", "nothing but spelling is left", &C::print_programs},
      TranslationPass{"comments", "they follow the lines that were printed", &C::carry_all_comments}};
  static constexpr std::array kExplicit = {
      TranslationPass{"axes that only one of the machines has", "on the program as written", &C::refuse_unlike_axes},
      TranslationPass{"M functions of the machine", "on the program as written", &C::refuse_machine_functions},
      TranslationPass{"run of the source", "for the comparison, before the blocks are written", &C::watch_run},
      TranslationPass{"blocks of the run, printed", "what it did is all that is left", &C::print_run}};
  if (mode == ConvertMode::macro) return kMacro;
  return kExplicit;
}

bool Converter::refuse_unlike_axes(ir::Program& program) {
  add(unlike_machine_moves(program, request_.from, request_.to));
  return true;
}

bool Converter::refuse_own_cycles(ir::Program& program) {
  add(own_cycles(program, request_.to, request_.library));
  return true;
}

bool Converter::translate_main_returns(ir::Program& program) {
  if (!ir::has_numbered_variables(request_.to)) passes::returns_of_main_as_jumps(program);
  return true;
}

bool Converter::splice_iso(ir::Program& program) {
  if (!uses_iso_mode(program)) return true;
  inline_moves_.run_as(program);
  add(splice_iso_parts(program, request_.from, request_.to));
  return !has_error();
}

// A contour is entered from its cycle, which the later passes of a text of several programs do not know.
bool Converter::write_as_moves(ir::Program& program) {
  add(inline_moves_.lower(program));
  diagnostics_before_ = result_.diagnostics.size();
  return program.sections.size() <= 1 || !has_error();
}

bool Converter::translate_thread_leads(ir::Program& program) {
  add(translate_leads(program, request_.from, request_.to));
  return true;
}

bool Converter::lower_turning_cycles(ir::Program& program) {
  add(lower_turning(program, request_.from, request_.to));
  return true;
}

bool Converter::translate_faces_and_cylinders(ir::Program& program) {
  add(translate_faces(program, request_.from, request_.to));
  return true;
}

bool Converter::translate_rigid_taps(ir::Program& program) {
  add(passes::translate_taps(program, request_.from, request_.to));
  return true;
}

bool Converter::refuse_machine_functions(ir::Program& program) {
  add(passes::foreign_machine_functions(program, request_.from, request_.to));
  return true;
}

// One program is the whole text, however many statements it gets. Of several, each is lowered where it is printed.
bool Converter::lower_flow(ir::Program& program) {
  if (program.sections.size() == 1) program.sections.clear();
  if (program.sections.empty()) lower(program);
  return true;
}

bool Converter::place_shifted_increments(ir::Program& program) {
  passes::place_shifted_increments(program, request_.from, request_.to);
  return true;
}

// What the other control would take otherwise, if it were only printed.
bool Converter::make_modes_explicit(ir::Program& program) {
  add(passes::make_modes_explicit(program, request_.from, request_.to));
  add(passes::translate_arcs(program, request_.from, request_.to));
  add(passes::translate_centers(program, request_.from, request_.to));
  return true;
}

bool Converter::call_as_macros(ir::Program& program) {
  if (&from_ != &to_ && ir::has_numbered_variables(request_.to)) call_parameters_as_macros(program, request_.library);
  return true;
}

bool Converter::print_programs(ir::Program& program) {
  if (program.sections.size() <= 1) {
    print(program, request_.from);
    return !has_error();
  }
  drop_unread_arguments(program, request_.from, request_.to);
  common_.emplace(program, request_.from, request_.to, request_.library);
  several(program);
  return !has_error();
}

bool Converter::carry_all_comments(ir::Program& program) {
  ir::PrintResult printed{.text = std::move(result_.text), .origin_lines = std::move(result_.origin_lines)};
  carry_comments(program, request_.to, to_.comments, printed, result_.diagnostics);
  result_.text = std::move(printed.text);
  result_.origin_lines = std::move(printed.origin_lines);
  return true;
}

bool Converter::watch_run(ir::Program& program) {
  inline_moves_.watch(program, true);
  return true;
}

void Converter::print(const ir::Program& program, const ir::Control& from) {
  add(foreign_axis_words(program, from, request_.to));
  ir::RaiseResult raised = raise(program, from);
  add(std::move(raised.diagnostics));
  if (text::has_error(result_.diagnostics)) return;
  ir::PrintResult printed = print_for(to_, raised.program, request_.to);
  result_.text = std::move(printed.text);
  result_.origin_lines = std::move(printed.origin_lines);
}

// What only one of the two can say, before anything is asked of the paths through the program.
void Converter::lower(ir::Program& program) {
  if (&from_ == &to_) return;
  if (!ir::has_numbered_variables(request_.to)) {
    add(passes::lower_computed_jumps(program).diagnostics);
  } else if (std::ranges::any_of(program.statements, repeats_a_part)) {
    passes::FreeNumbers numbers(program, kHighestBlockNumber);
    add(passes::lower_repeated_parts(program, numbers).diagnostics);
  }
  // After the jumps that repeat: they lead there with other modes, too.
  add(passes::lower_polar_positions(program, request_.from, request_.to));
}

// With what the control's definition files declare; what was run has it by then.
ir::RaiseResult Converter::raise(const ir::Program& program, const ir::Control& from) {
  const bool alone = request_.library == nullptr || request_.mode != ConvertMode::macro || &from_ == &to_;
  if (alone || from.definition_files.empty()) return raise_with_room(program, from);
  ir::Program defined = program;
  add_definitions(defined, from, *request_.library);
  return raise_with_room(defined, from);
}

// Local variables are what a program may always have; common ones only where nothing that runs with it has them.
ir::RaiseResult Converter::raise_with_room(const ir::Program& program, const ir::Control& from) {
  ir::RaiseResult raised = to_.raise(program, from, request_.to);
  const bool too_few = std::ranges::any_of(
      raised.diagnostics, [](const text::Diagnostic& d) { return d.id == text::DiagnosticId::not_enough_variables; });
  if (too_few && !common_) common_.emplace(program, from, request_.to, request_.library);
  if (too_few)
    if (const auto wider = common_->control_for(program.name)) raised = to_.raise(program, from, *wider);
  if (common_ && !text::has_error(raised.diagnostics)) common_->took(program.name, raised.program);
  return raised;
}

void Converter::several(const ir::Program& text) {
  add(foreign_axis_words(text, request_.from, request_.to));
  JoinedPrograms joined(text, request_.to);
  CallLevels levels;
  for (const ir::Section& section : text.sections) {
    ir::Program program = program_of(text, section);
    lower(program);
    ir::RaiseResult raised = raise(program, request_.from);
    add(std::move(raised.diagnostics));
    raised.program.name = joined.name_there(program);
    levels.add(raised.program.name, raised.program);
    if (!text::has_error(result_.diagnostics))
      joined.add(program, raised.program, print_for(to_, raised.program, request_.to));
  }
  add(joined.diagnostics());
  add(levels.too_deep(request_.to));
  if (text::has_error(result_.diagnostics)) return;
  ir::PrintResult printed = joined.take();
  result_.text = std::move(printed.text);
  result_.origin_lines = std::move(printed.origin_lines);
}

void Converter::report_skip_decided(const ir::Program& program) {
  for (const ir::Statement& s : program.statements) {
    const bool rest = s.kind == ir::StatementKind::block && program.blocks[s.payload].rest_level != 0;
    if (s.skip_level == 0 && !rest) continue;
    result_.diagnostics.push_back(ir::diagnose(request_.from, text::DiagnosticId::block_skip_decided, s.span, {}));
    return;
  }
}

bool Converter::print_run(ir::Program& program) {
  interpreter::ProgramFinder& none = interpreter::no_programs();
  interpreter::ProgramFinder& finder = request_.library == nullptr ? none : *request_.library;
  ExplicitProgram made = explicit_program(program, request_.from, finder,
                                          {.limits = request_.limits, .initial_values = {}, .own_unit = true});
  const ProgramLibrary nothing(request_.from, {});
  const RunTexts texts(program, request_.library == nullptr ? nothing : *request_.library);
  add(run_faults(made, texts));
  report_skip_decided(program);
  add(passes::assumed_modes(program, request_.from));
  add(passes::unstated_modes(program, request_.from, false).diagnostics);
  if (text::has_error(result_.diagnostics)) return false;
  number_blocks(program, made);
  // Writers name lines in what they refuse.
  for (ir::Statement& s : made.program.statements)
    if (s.line != 0) s.line = made.origins[s.line - 1].line;
  print(made.program, made.control);
  return !text::has_error(result_.diagnostics) && carry_all_comments(program);
}

}  // namespace dripfeed::compile
