// A program that is translated statement by statement, or block by block, is run as it was read. What the run took from
// outside is not known for the translation either, so that nothing is compared then.
#include <algorithm>
#include <string>

#include "dialects/compile/translate/inline_moves.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::compile {

namespace {

using ir::Function;
using ir::StatementKind;

// Not carried out by a run, and neither a move nor a write: translated by name, or refused.
bool is_translated_by_name(const interpreter::NotInterpreted& lost) {
  return lost.effects_known || lost.function == Function::machine_function ||
         lost.function == Function::reference_return;
}

bool has(const ir::Program& program, StatementKind kind) {
  return std::ranges::find(program.statements, kind, &ir::Statement::kind) != program.statements.end();
}

bool begins_transformation(const ir::Code& c) {
  return c.function == Function::transformation && c.argument != ir::kTransformationEnds;
}

bool is_section(const ir::Program& program, std::string_view name) {
  return std::ranges::any_of(program.sections,
                             [&](const ir::Section& s) { return program.strings.at(s.name) == name; });
}

// Of the first program of the text.
bool ends_as_subprogram(const ir::Program& program) {
  const std::size_t last = program.sections.size() > 1 ? program.sections.front().last : program.statements.size();
  bool returns = false;
  for (std::size_t i = 0; i < last; ++i) {
    if (program.statements[i].kind == StatementKind::program_end) return false;
    returns |= program.statements[i].kind == StatementKind::subprogram_return;
  }
  return returns;
}

}  // namespace

void InlineMoves::watch(const ir::Program& program, bool called) {
  source_ = program.source;
  not_compared_ = watched(program, called);
  if (!not_compared_.empty()) return runs_.clear();
  find_cycles(program);
  if (called) writes_.clear();  // an explicit program says itself what it would lose
}

std::string InlineMoves::watched(const ir::Program& program, bool called) {
  if (program.statements.size() > limits_.blocks) return "it runs too long";
  if (ends_as_subprogram(program)) return "it is a subprogram, which only its caller can run";
  if (has(program, StatementKind::procedure) && program.sections.size() < 2)
    return "it is a program with parameters, which only its caller can run";
  if (std::ranges::any_of(program.codes, begins_transformation))
    return "moves on a face or a cylinder come in pieces of each control's own";
  if (std::string levels = set_switches(program); !levels.empty()) return levels;
  ir::Control control = from_;
  control.semantics.unset_is_unknown = true;
  ProgramLibrary own(from_, [](std::string_view) { return std::nullopt; });
  ProgramLibrary& library = library_ == nullptr ? own : *library_;
  for (const std::uint32_t switches : settings_) {
    interpreter::RunOptions options;
    options.limits = limits_;
    options.skip_switches = switches;
    runs_.push_back(record(program, control, library, options, {}, {}));
    const RecordedRun& run = runs_.back();
    const interpreter::RunResult& result = run.result;
    for (const interpreter::RunDiagnostic& d : result.diagnostics) {
      if (d.diagnostic.severity != text::Severity::error) continue;
      // An alarm of its own control, which has no translation.
      if (d.diagnostic.id == text::DiagnosticId::no_feed && d.program == 0) diagnostics_.push_back(d.diagnostic);
      return "its run ends in line " + std::to_string(d.line) + ": " + text::message_of(d.diagnostic);
    }
    for (const interpreter::NotInterpreted& lost : result.not_interpreted) {
      const std::string place = lost.program == 0 ? " in line " + std::to_string(lost.first_line) : std::string();
      if (lost.is_input) return lost.name + place + " has a value that is not given";
      if (!is_translated_by_name(lost)) return lost.name + place + " is not interpreted";
    }
    for (std::size_t i = 1; i < result.programs.size() && !called; ++i) {
      const ir::Program* program_called = library.find(result.programs[i]);
      const bool brought_along = program_called != nullptr && program_called->is_standard;
      if (!brought_along && !is_section(program, result.programs[i]))
        return "it calls " + result.programs[i] + ", which is not translated with it";
    }
    if (!run.is_whole || result.ended == interpreter::Ended::limit) return "it runs too long";
    returns_ = result.ended != interpreter::Ended::end;
  }
  return {};
}

}  // namespace dripfeed::compile
