// A condition that cannot be decided keeps the call.
#include "dialects/compile/translate/call_conditions.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/translate/inlined_calls.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/block_codes.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/walk.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

// nullopt: too many lie in each other.
std::optional<LoopNumbers> loop_numbers(const CalledBody& body, std::vector<std::uint8_t> used, std::uint32_t most) {
  LoopNumbers out;
  const ir::Program& text = *body.text;
  for (std::uint32_t i = body.first; i < body.last; ++i) {
    const StatementKind kind = text.statements[i].kind;
    if (kind == StatementKind::while_end || kind == StatementKind::loop_end) used.pop_back();
    if (kind != StatementKind::while_begin && kind != StatementKind::loop_begin) continue;
    std::uint8_t number = text.structures[text.statements[i].payload].loop_number;
    const auto is_used = [&](std::uint8_t n) { return std::ranges::find(used, n) != used.end(); };
    if (is_used(number))
      for (number = 1; is_used(number);) ++number;
    used.push_back(number);
    if (most > 0 && used.size() > most) return {};
    out[i] = out[text.structures[text.statements[i].payload].partner] = number;
  }
  return out;
}

// Statements after which the next one of the text comes, and that call nothing.
bool goes_straight_on(StatementKind kind) {
  switch (kind) {
    case StatementKind::empty:
    case StatementKind::block:
    case StatementKind::assign:
    case StatementKind::define:
    case StatementKind::procedure:
    case StatementKind::declaration:
    case StatementKind::message: return true;
    default: return false;
  }
}

bool may_set_path(const ir::Program& text, const ir::Block& block) {
  return ir::has_code(text, block, ir::Function::continuous_path) ||
         std::ranges::any_of(text.codes_of(block),
                             [](const ir::Code& code) { return code.number != ir::ExpressionId::none; });
}

}  // namespace

LoopsAround loops_around(const ir::Program& text, const ir::Section& range, std::uint32_t statement) {
  LoopsAround out;
  for (std::uint32_t i = range.first; i < range.last; ++i) {
    const ir::Statement& s = text.statements[i];
    if (s.kind == StatementKind::go_to && i > statement)
      if (const std::uint32_t to = facts::target_of(text, i); to != ir::kNoIndex && to <= statement) out.repeats = true;
    if (i >= statement || !passes::begins_loop(s.kind)) continue;
    const ir::Structure& loop = text.structures[s.payload];
    if (loop.partner == ir::kNoIndex || loop.partner < statement) continue;
    out.repeats = true;
    out.numbers.push_back(loop.loop_number);
  }
  return out;
}

CallConditions::CallConditions(const ir::Program& text, const Callee& main, const Dialect& dialect,
                               const ir::Control& control, ProgramLibrary& library)
    : text_(text), main_(main), dialect_(dialect), control_(control), library_(library) {
  const ir::Section range = main.range();
  for (std::uint32_t i = range.first; i < range.last; ++i) look_at(i);
}

void CallConditions::look_at(std::uint32_t i) {
  const ir::Statement& s = text_.statements[i];
  if (s.kind == StatementKind::modal_call) main_why_ = "a modal call is in effect in its caller";
  if (s.kind == StatementKind::define) {
    const ir::Structure& d = text_.structures[s.payload];
    for (std::uint32_t n = 0; n < d.symbol_count; ++n)
      names_.insert(text::upper_case(text_.strings.at(text_.symbols[d.first_symbol + n].name)));
  }
  if (reads_own_place(text_, s)) main_why_ = "its caller reads the number of a block";
}

// Of how it is called.
std::string CallConditions::refusal(const Callee& caller, std::uint32_t i, const Callee& target,
                                    const Around& around) const {
  const ir::Program& text = *caller.text;
  const ir::Statement& s = text.statements[i];
  const ir::Call& call = text.calls[s.payload];
  if (!main_why_.empty()) return main_why_;
  if (call.kind == ir::CallKind::macro) return "the call gives it variables of its own";
  if (call.kind == ir::CallKind::external) return "it is a program of another device";
  if (call.in_other_language) return "it is called in the control's other language";
  if (call.argument_count > 0) return "it takes arguments";
  if (call.repeats != ir::ExpressionId::none) return "the call repeats it";
  if (call.start != ir::ExpressionId::none || call.first_label != ir::ExpressionId::none)
    return "the call runs a part of it";
  if (s.skip_level != 0) return "block skip may leave the call out";
  const bool shares = (i > 0 && text.statements[i - 1].line == s.line) ||
                      (i + std::size_t{1} < text.statements.size() && text.statements[i + 1].line == s.line);
  if (shares) return "the block of the call has other words";
  if (target.text == nullptr) return "its text is not at hand";
  if (std::ranges::find(around.callers, target) != around.callers.end()) return "it calls itself";
  return has_errors(*target.text) ? "its text has an error" : "";
}

std::expected<TakenBody, std::string> CallConditions::body_of(const Callee& target, const Around& around) {
  auto taken = called_body(*target.text, target.range());
  if (!taken) return std::unexpected(std::move(taken.error()));
  TakenBody out{.body = *taken, .numbers = {}};
  const CalledBody& body = out.body;
  if (dialect_.return_code_rests && body.returns_by_code && !rests_at_calls())
    return std::unexpected(
        "its return stops the tool between moves, where continuous-path mode may be in effect (RET does not)");
  const std::uint32_t most = around.repeats ? kMostBlocksInLoop : kMostBlocksOnce;
  if (body.blocks > most)
    return std::unexpected(fmt::format("its {} blocks are more than the {} for which it pays {}", body.blocks, most,
                                       around.repeats ? "in a loop" : "outside of loops"));
  for (std::uint32_t n = body.first; n < body.last; ++n)
    if (std::string why = refusal_in_body(target, n); !why.empty()) return std::unexpected(std::move(why));
  if (!body.has_loop_numbers) return out;
  auto found = loop_numbers(body, around.loops, control_.limits.loop_nesting);
  if (!found) return std::unexpected("its loops would lie too deep in those around the call");
  out.numbers = std::move(*found);
  return out;
}

std::string CallConditions::refusal_in_body(const Callee& target, std::uint32_t n) const {
  const ir::Program& text = *target.text;
  const ir::Statement& s = text.statements[n];
  if (reads_own_place(text, s)) return "it reads the number of a block";
  for (const passes::VariableUseAt& use : passes::variables_of(text, s)) {
    const ir::Variable& v = text.at(use.variable);
    if (v.bank != ir::Bank::named) continue;
    const std::string name = text::upper_case(text.strings.at(text.at(v.symbol).name));
    if (names_.contains(name)) return "it uses the name " + name + ", which its caller defines";
  }
  if (s.kind != StatementKind::call) return {};
  const ir::Call& call = text.calls[s.payload];
  if (call.cycle != nullptr) return {};
  if (call.name == ir::StringId::none) return "it calls a program that a value decides";
  const std::string name(text.strings.at(call.name));
  return find(name, text) == find(name, text_) ? "" : "it calls " + name + " of its own file";
}

bool CallConditions::reads_own_place(const ir::Program& text, const ir::Statement& s) const {
  return std::ranges::any_of(passes::variables_of(text, s), [&](const passes::VariableUseAt& use) {
    const ir::Variable& v = text.at(use.variable);
    return v.bank == ir::Bank::hash && v.index == ir::ExpressionId::none &&
           std::ranges::any_of(control_.system_variables, [&](const ir::SystemVariableRow& row) {
             return row.name.empty() && v.number >= row.first && v.number <= row.last &&
                    (row.kind == ir::SystemValue::block_number || row.kind == ir::SystemValue::program_number);
           });
  });
}

// Exact stop is in effect wherever a program is called: the main program states it before anything else, and neither
// it nor what it calls states another mode.
bool CallConditions::rests_at_calls() {
  if (!rests_) {
    std::vector<Callee> seen;
    rests_ = states_exact_stop_first() && keeps_exact_stop(main_, seen);
  }
  return *rests_;
}

bool CallConditions::states_exact_stop_first() const {
  const ir::Section range = main_.range();
  for (std::uint32_t i = range.first; i < range.last; ++i) {
    const ir::Statement& s = text_.statements[i];
    if (!goes_straight_on(s.kind)) return false;
    if (s.kind != StatementKind::block || s.skip_level != 0) continue;
    const ir::Block& block = text_.blocks[s.payload];
    if (block.rest_level == 0 && ir::has_code(text_, block, ir::Function::exact_stop_mode)) return true;
  }
  return false;
}

bool CallConditions::keeps_exact_stop(const Callee& program, std::vector<Callee>& seen) const {
  if (program.text == nullptr) return false;
  if (std::ranges::find(seen, program) != seen.end()) return true;
  seen.push_back(program);
  const ir::Program& text = *program.text;
  const ir::Section range = program.range();
  for (std::uint32_t i = range.first; i < range.last; ++i) {
    const ir::Statement& s = text.statements[i];
    if (s.kind == StatementKind::native || s.kind == StatementKind::execute_text) return false;
    if (s.kind == StatementKind::block && may_set_path(text, text.blocks[s.payload])) return false;
    if (!facts::is_call(s.kind) || text.calls[s.payload].cycle != nullptr) continue;
    const ir::StringId name = text.calls[s.payload].name;
    if (name == ir::StringId::none || !keeps_exact_stop(find(std::string(text.strings.at(name)), text), seen))
      return false;
  }
  return true;
}

bool CallConditions::has_errors(const ir::Program& text) const {
  return std::ranges::any_of(library_.loaded(), [&](const auto& one) {
    return &one->read.program == &text && text::has_error(one->read.diagnostics);
  });
}

Callee CallConditions::find(const std::string& name, const ir::Program& from) const {
  for (const ir::Program* text : {&from, &text_})
    if (const auto section = ir::section_named(*text, name)) return {text, *section};
  if (name == text_.name && from.sections.empty() && &from == &text_) return main_;
  const ir::Program* found = library_.find(name);
  if (found == nullptr) return {};
  return {found, ir::section_named(*found, name).value_or(0)};
}

}  // namespace dripfeed::compile
