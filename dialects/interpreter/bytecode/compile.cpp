// Laying out symbols, then one pass over the statements; branches to statements that are not compiled yet are put down
// and set at the end.
#include "dialects/interpreter/bytecode/compile.h"

#include <algorithm>

#include "dialects/interpreter/bytecode/statement_compiler.h"

namespace dripfeed::interpreter {

namespace {

using ir::ValueType;

// Gives each symbol its registers. Arrays lie row by row.
bool lay_out_symbols(const ir::Program& program, const Limits& limits, SharedData& shared, CompiledProgram& out) {
  std::uint64_t numbers = 0;
  std::uint64_t strings = 0;
  for (std::uint32_t i = 0; i < program.symbols.size(); ++i) {
    const ir::Symbol& symbol = program.symbols[i];
    if (symbol.is_global) {  // lies in the control
      out.symbols.push_back({.slot = shared.id_of(program.strings.at(symbol.name))});
      continue;
    }
    std::uint64_t& next = symbol.type == ValueType::string ? strings : numbers;
    SymbolSlot slot{.slot = static_cast<std::uint32_t>(next)};
    std::uint64_t count = 1;
    if (symbol.dimension1 > 0) {
      const std::uint32_t columns = std::max<std::uint32_t>(symbol.dimension2, 1);
      const std::uint32_t layers = std::max<std::uint32_t>(symbol.dimension3, 1);
      count = std::uint64_t{symbol.dimension1} * columns * layers;
      slot.array = static_cast<std::uint32_t>(out.arrays.size());
      out.arrays.push_back({slot.slot, symbol.dimension1, columns, layers, symbol.type, static_cast<ir::SymbolId>(i)});
    }
    next += count;
    if (numbers + strings > limits.variables) return false;
    out.symbols.push_back(slot);
  }
  out.declared_slots = out.frame_slots = static_cast<std::uint32_t>(numbers);
  out.declared_strings = out.string_slots = static_cast<std::uint32_t>(strings);
  return true;
}

// Of the section's own head, the first PROC there.
void lay_out_parameters(const ir::Program& program, std::uint32_t section, CompiledProgram& out) {
  const bool is_only = program.sections.empty();
  const std::size_t first = is_only ? 0 : program.sections[section].first;
  const std::size_t last = is_only ? program.statements.size() : program.sections[section].last;
  for (std::size_t at = first; at < last; ++at) {
    const ir::Statement& statement = program.statements[at];
    if (statement.kind != ir::StatementKind::procedure || statement.payload == ir::kNoIndex) continue;
    const ir::Structure& head = program.structures[statement.payload];
    out.has_procedure = true;
    out.saves_modal = head.saves_modal;
    for (std::uint32_t i = 0; i < head.symbol_count; ++i) {
      const ir::Symbol& symbol = program.symbols[head.first_symbol + i];
      if (!symbol.is_parameter) continue;
      out.parameters.push_back({out.symbols[head.first_symbol + i].slot, symbol.type, symbol.by_reference});
    }
    return;
  }
}

}  // namespace

std::unique_ptr<CompiledProgram> compile(const ir::Program& program, std::uint32_t section, std::uint32_t index,
                                         const CompileContext& context, std::uint32_t last) {
  auto out = std::make_unique<CompiledProgram>();
  out->source = &program;
  out->rules = &context.rules;
  out->section = section;
  out->index = index;
  out->keeps_place = program.is_standard;
  const bool fits = lay_out_symbols(program, context.limits, context.shared, *out);
  CodeBuilder builder(*out, context);
  if (!fits) {  // none has a place
    out->symbols.clear();
    out->arrays.clear();
    builder.emit_failure({}, text::DiagnosticId::limit_reached, {"variables"});
    return out;
  }
  lay_out_parameters(program, section, *out);
  StatementCompiler(builder).compile(last);
  return out;
}

std::unique_ptr<CompiledProgram> compile_foreign(const ir::Program& foreign, text::Span part,
                                                 const CompiledProgram& host, const CompileContext& context) {
  auto out = std::make_unique<CompiledProgram>();
  out->source = &foreign;
  out->rules = &context.rules;
  out->index = host.index;
  out->is_foreign = true;
  CodeBuilder builder(*out, context);
  const auto begin_of = [](const ir::Statement& s) { return s.span.begin; };
  const auto first = std::ranges::lower_bound(foreign.statements, part.begin, {}, begin_of);
  const auto last = std::ranges::lower_bound(first, foreign.statements.end(), part.end, {}, begin_of);
  StatementCompiler(builder).compile_part(static_cast<std::uint32_t>(first - foreign.statements.begin()),
                                          static_cast<std::uint32_t>(last - foreign.statements.begin()));
  return out;
}

std::unique_ptr<CompiledProgram> compile_text(ir::Program& program, const CompiledProgram& host,
                                              const CompileContext& context) {
  auto out = std::make_unique<CompiledProgram>();
  out->source = &program;
  out->rules = host.rules;
  out->index = host.index;
  out->keeps_place = out->is_text = true;
  out->arrays = host.arrays;
  for (std::uint32_t i = 0; i < program.symbols.size(); ++i) {
    ir::Symbol& symbol = program.symbols[i];
    const std::string_view name = program.strings.at(symbol.name);
    SymbolSlot slot{.slot = context.shared.id_of(name)};
    const auto& declared = host.source->symbols;
    for (std::uint32_t k = 0; k < declared.size(); ++k) {
      if (declared[k].is_global || host.source->strings.at(declared[k].name) != name) continue;
      const ir::StringId own_name = symbol.name;
      symbol = declared[k];
      symbol.name = own_name;
      slot = host.symbols[k];
      if (slot.array != SymbolSlot{}.array) out->arrays[slot.array].symbol = static_cast<ir::SymbolId>(i);
      break;
    }
    out->symbols.push_back(slot);
  }
  // Its temporaries come after everything that the host uses.
  out->declared_slots = out->frame_slots = host.frame_slots;
  out->declared_strings = out->string_slots = host.string_slots;
  CodeBuilder builder(*out, context);
  StatementCompiler(builder).compile();
  return out;
}

}  // namespace dripfeed::interpreter
