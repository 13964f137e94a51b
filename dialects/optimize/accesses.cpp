// Reads and sets by the roots of each statement's expressions.
#include "dialects/optimize/accesses.h"

#include <algorithm>

#include "dialects/facts/calls.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/optimize/expressions.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/walk.h"

namespace dripfeed::optimize {

namespace {

using ir::StatementKind;

class Reader {
 public:
  Reader(const ir::Program& program, const Places& places, Access& out)
      : program_(program), places_(places), out_(out) {}

  void read(ir::ExpressionId id) {
    passes::for_each_node(program_, id, [this](ir::ExpressionId node) {
      const ir::Expression& e = program_.at(node);
      if (e.op == ir::Operator::variable) read(program_.at(e.variable));
    });
  }

  void set(ir::VariableId id) {
    const ir::Variable& v = program_.at(id);
    for (const ir::ExpressionId index : {v.index, v.index2, v.index3}) read(index);
    if (const Place place = places_.of(v); place != kNoPlace) {
      out_.sets.push_back(place);
      return;
    }
    out_.is_fixed = true;
    out_.sets_shared = out_.sets_shared || v.bank == ir::Bank::hash || v.bank == ir::Bank::r;
  }

  // What is passed as it is may be passed by reference, and come back changed.
  void pass(const ir::Call& call, Access& out) {
    for (const ir::Argument& argument : program_.arguments_of(call)) {
      if (argument.value == ir::ExpressionId::none) continue;
      if (const Place place = place_at(program_, places_, argument.value); place != kNoPlace) out.sets.push_back(place);
    }
    out.sets_for_sure = false;
  }

 private:
  void read(const ir::Variable& v) {
    if (const Place place = places_.of(v); place != kNoPlace) {
      out_.reads.push_back(place);
      out_.reads_outside = out_.reads_outside || !places_.at(place).is_plain;
      return;
    }
    out_.reads_outside = true;
    out_.reads_shared = out_.reads_shared || v.bank == ir::Bank::hash || v.bank == ir::Bank::r;
  }

  const ir::Program& program_;
  const Places& places_;
  Access& out_;
};

// Kinds whose effect is in the expressions that passes::for_each_root shows.
bool is_understood(StatementKind kind) {
  switch (kind) {
    case StatementKind::empty:
    case StatementKind::block:
    case StatementKind::assign:
    case StatementKind::go_to:
    case StatementKind::program_end:
    case StatementKind::subprogram_return:
    case StatementKind::message:
    case StatementKind::alarm:
    case StatementKind::output:
    case StatementKind::define:
    case StatementKind::declaration:
    case StatementKind::procedure: return true;
    default: return ir::is_structure(kind);
  }
}

// M0, M1: an operator may look at variables there, and set them.
bool stops(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::block &&
         std::ranges::any_of(program.codes_of(program.blocks[s.payload]), [](const ir::Code& c) {
           return c.function == ir::Function::program_stop || c.function == ir::Function::optional_stop;
         });
}

std::string obstacle_at(const ir::Program& program, const ir::Statement& s) {
  if (ir::is_structure(s.kind) && (s.skip_level != 0 || program.structures[s.payload].partner == ir::kNoIndex) &&
      s.kind != StatementKind::else_begin)
    return "a loop or IF whose beginning or end is missing or may be skipped";
  switch (s.kind) {
    case StatementKind::modal_call:
      return facts::is_standard_cycle(program, s) ? "" : "a modal call, which every move repeats";
    case StatementKind::execute_text: return "a text that is executed (EXECSTRING)";
    case StatementKind::repeat_section: return "a part of the program that is repeated (REPEAT)";
    case StatementKind::return_to: return "a return to a block of the caller";
    case StatementKind::native:
      return "\"" + std::string(program.strings.at(program.natives[s.payload].name)) + "\", which is not interpreted";
    case StatementKind::call:
      return program.calls[s.payload].name == ir::StringId::none ? "a call of a part of the program" : "";
    case StatementKind::go_to:
      return program.jumps[s.payload].computed != ir::ExpressionId::none ? "a jump to a computed block" : "";
    default: return {};
  }
}

}  // namespace

Access access_of(const ir::Program& program, const Places& places, std::uint32_t statement) {
  const ir::Statement& s = program.statements[statement];
  Access out;
  Reader reader(program, places, out);
  passes::for_each_root(
      program, s, [&](ir::ExpressionId id) { reader.read(id); }, [&](ir::VariableId id) { reader.set(id); });
  out.sets_for_sure = out.sets_for_sure && s.skip_level == 0;
  out.is_fixed = out.is_fixed || s.skip_level != 0 || !is_understood(s.kind);
  if (facts::is_call(s.kind) || s.kind == StatementKind::native) out.reads_shared = out.sets_shared = true;
  if (stops(program, s)) out.reads_shared = out.sets_shared = true;
  if (facts::is_call(s.kind)) reader.pass(program.calls[s.payload], out);
  if (s.kind == StatementKind::for_end) {
    const std::uint32_t begin = program.structures[s.payload].partner;
    if (begin != ir::kNoIndex) reader.set(program.structures[program.statements[begin].payload].counter);
  }
  if (s.kind == StatementKind::for_begin || s.kind == StatementKind::for_end)
    for (const Place p : out.sets) out.reads.push_back(p);
  if (s.kind == StatementKind::define || s.kind == StatementKind::procedure) {
    const ir::Structure& d = program.structures[s.payload];
    for (std::uint32_t i = 0; i < d.symbol_count; ++i) {
      ir::Variable named;
      named.bank = ir::Bank::named;
      named.symbol = static_cast<ir::SymbolId>(d.first_symbol + i);
      if (const Place place = places.of(named); place != kNoPlace) out.sets.push_back(place);
    }
  }
  return out;
}

std::vector<Access> accesses_of(const ir::Program& program, const Places& places) {
  std::vector<Access> out;
  out.reserve(program.statements.size());
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) out.push_back(access_of(program, places, i));
  return out;
}

std::vector<bool> parameters_of(const ir::Program& program, const Places& places, const std::vector<Access>& accesses) {
  std::vector<std::uint32_t> sets(places.count(), 0);
  std::vector<bool> out(places.count(), false);
  std::uint32_t depth = 0;
  for (std::uint32_t i = 0; i < accesses.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::define) continue;
    const bool is_end = s.kind == StatementKind::if_end || passes::ends_loop(s.kind);
    if (is_end && depth > 0) --depth;
    if (ir::is_structure(s.kind) && !is_end && s.kind != StatementKind::else_begin) ++depth;
    const bool by_numbers = s.kind == StatementKind::assign && accesses[i].reads.empty() && !accesses[i].reads_outside;
    for (const Place p : accesses[i].sets) out[p] = ++sets[p] == 1 && depth == 0 && by_numbers;
  }
  return out;
}

namespace {

std::string obstacle_in(const ir::Program& program, const ir::Statement& s) {
  if (s.kind == StatementKind::call && ir::runs_contour(program.calls[s.payload]))
    return "a cycle that runs blocks of the program as its contour";
  return obstacle_at(program, s);
}

bool has_shape(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::block &&
         std::ranges::any_of(program.codes_of(program.blocks[s.payload]),
                             [](const ir::Code& code) { return code.function == ir::Function::repetitive_cycle; });
}

constexpr const char* kRunsShape = "a cycle that runs blocks of the program as its shape";

}  // namespace

std::string obstacle(const ir::Program& program) {
  if (!program.foreign_parts.empty()) return "blocks in the control's other language";
  if (std::ranges::any_of(program.statements, [&](const ir::Statement& s) { return has_shape(program, s); }))
    return kRunsShape;
  for (const ir::Statement& s : program.statements)
    if (const std::string found = obstacle_in(program, s); !found.empty())
      return found + " (line " + std::to_string(s.line) + ")";
  return {};
}

std::string obstacle(const ir::Program& program, std::uint32_t first, std::uint32_t last) {
  if (!program.foreign_parts.empty()) return "blocks in the control's other language";
  for (std::uint32_t i = first; i < last; ++i) {
    const ir::Statement& s = program.statements[i];
    if (has_shape(program, s)) return kRunsShape;
    if (std::string found = obstacle_in(program, s); !found.empty()) return found;
  }
  return {};
}

}  // namespace dripfeed::optimize
