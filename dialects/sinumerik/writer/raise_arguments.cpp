// Macros; raise_macro_calls.cpp has the arguments of their calls. A subprogram that reads local variables before it
// sets them has them from its call, and a macro has local variables of its own: parameters and definitions here.
//
//   O9010                           PROC L9010(REAL ARG_A, REAL ARG_B, …, REAL ARG_Z)
//                                   DEF BOOL NO_B
//                                   NO_B=NOT $P_SUBPAR[2]
//   IF[#2EQ#0]THEN #2=5.            IF NO_B / ARG_B=5 / NO_B=0 / ENDIF
//   G01 Z-#1 F#2                    G1 Z=-ARG_A F=ARG_B
//   G65 P9011 X#1                   L9011(,,,,,,,,,,,,,,,,,,ARG_A)
//
// A word with an empty variable is no word: its block is written with and without it. Called by M98 the variables would
// be the caller's; a program in which that may be is refused.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "dialects/ir/sections.h"
#include "dialects/passes/macro_arguments.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/set_on_all_paths.h"
#include "dialects/passes/walk.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

constexpr std::size_t kMostVariants = 3;  // variables that may be empty in one block

// What the names are made of.
struct Local {
  ir::SymbolId symbol = ir::SymbolId::none;
  ir::SymbolId flag = ir::SymbolId::none;  // BOOL: it is empty
  bool is_parameter = false;
};

class Macro {
 public:
  explicit Macro(const Raising& raising) : raising_(raising), program_(raising.program), out_(program_) {}

  std::set<ir::SymbolId> run() {
    find_locals();
    if (locals_.empty()) return {};
    const auto unset = passes::reads_before_set(program_, [this](const ir::Variable& v) { return local_of(v); });
    const bool takes = ir::is_subprogram(program_) && std::ranges::any_of(unset, [](const passes::UnsetRead& read) {
                         return passes::position_of_local(read.watched).has_value();
                       });
    if (!takes && !calls(ir::CallKind::macro)) return {};
    refuse_sharing();
    declare(takes);
    for (const passes::UnsetRead& read : unset) {
      if (locals_.at(read.watched).is_parameter)
        unset_.emplace(read.statement, read.variable);
      else
        may_be_empty(read);
    }
    find_flags();
    rewrite(takes);
    rename();
    return std::move(kept_);
  }

 private:
  [[nodiscard]] std::optional<std::uint32_t> local_of(const ir::Variable& v) const {
    if (v.bank != ir::Bank::hash || v.index != ExpressionId::none) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(raising_.from, v.bank, v.number);
    const bool is_local = range != nullptr && range->use == ir::VariableUse::local;
    return is_local ? std::optional(v.number) : std::nullopt;
  }

  void find_locals() {
    for (const ir::Statement& s : program_.statements)
      for (const passes::VariableUseAt& use : passes::variables_of(program_, s))
        if (const auto number = local_of(program_.at(use.variable))) locals_[*number];
  }

  [[nodiscard]] bool calls(ir::CallKind kind) const {
    return std::ranges::any_of(program_.statements, [&](const ir::Statement& s) {
      const bool call = s.kind == StatementKind::call || s.kind == StatementKind::modal_call;
      return call && program_.calls[s.payload].kind == kind;
    });
  }

  void refuse_sharing() {
    for (const ir::Statement& s : program_.statements) {
      if (s.kind == StatementKind::call && program_.calls[s.payload].kind != ir::CallKind::macro)
        raising_.cannot(passes::kept_value("a subprogram (M98), which would share the local variables of this macro,"),
                        s.span);
      for (const passes::VariableUseAt& use : passes::variables_of(program_, s)) {
        const ir::Variable& v = program_.at(use.variable);
        if (v.bank == ir::Bank::hash && v.index != ExpressionId::none)
          raising_.cannot(passes::computed("a variable of computed number in a macro"),
                          v.span.empty() ? s.span : v.span);
      }
    }
  }

  void may_be_empty(const passes::UnsetRead& read) {
    if (!reported_.insert(read.watched).second) return;
    raising_.cannot(passes::not_known("the variable #" + std::to_string(read.watched) + ", which may be empty here,"),
                    program_.at(read.variable).span);
  }

  // --- names

  ir::SymbolId add_symbol(const std::string& name, ir::ValueType type) {
    ir::Symbol symbol;
    symbol.name = program_.strings.add(name);
    symbol.type = type;
    const ir::SymbolId id = program_.add(symbol);
    kept_.insert(id);
    return id;
  }

  // All letters, because a caller may give more than are used; symbols of one kind stand together.
  void declare(bool takes) {
    first_parameter_ = static_cast<std::uint32_t>(program_.symbols.size());
    if (takes) {
      for (const passes::ArgumentLetter& letter : passes::kArgumentLetters) {
        const ir::SymbolId id = add_symbol(std::string("ARG_") + letter.letter, ir::ValueType::real);
        program_.symbols[static_cast<std::uint32_t>(id)].is_parameter = true;
        if (const auto local = locals_.find(letter.number); local != locals_.end())
          local->second = {.symbol = id, .is_parameter = true};
      }
    }
    first_local_ = static_cast<std::uint32_t>(program_.symbols.size());
    for (auto& [number, local] : locals_)
      if (!local.is_parameter) local.symbol = add_symbol("LOCAL_" + std::to_string(number), ir::ValueType::real);
    first_flag_ = static_cast<std::uint32_t>(program_.symbols.size());
  }

  // --- which variables need to know that they are empty

  [[nodiscard]] const ir::Variable* plain(ExpressionId id, bool signed_too) const {
    if (id == ExpressionId::none) return nullptr;
    const ir::Expression& e = program_.at(id);
    if (signed_too && e.op == Operator::negate) return plain(e.a, false);
    return e.op == Operator::variable ? &program_.at(e.variable) : nullptr;
  }
  [[nodiscard]] ir::VariableId variable_in(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    return e.op == Operator::negate ? variable_in(e.a) : e.variable;
  }
  // A variable alone that may be empty at the statement; 0 for all else.
  [[nodiscard]] std::uint32_t empty_here(std::uint32_t statement, ExpressionId id, bool signed_too) const {
    const ir::Variable* v = plain(id, signed_too);
    if (v == nullptr || !unset_.contains({statement, variable_in(id)})) return 0;
    return v->number;
  }
  [[nodiscard]] bool is_vacant(ExpressionId id) const { return program_.at(id).op == Operator::vacant; }
  [[nodiscard]] bool is_equality(ExpressionId id) const {
    const Operator op = program_.at(id).op;
    return op == Operator::equal || op == Operator::not_equal;
  }
  // The parameter whose being empty an equality asks for: #1 EQ #0.
  [[nodiscard]] std::uint32_t asked(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    for (const auto& [one, other] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      const ir::Variable* v = plain(one, false);
      const auto number = v == nullptr ? std::nullopt : local_of(*v);
      if (number && is_vacant(other) && locals_.at(*number).is_parameter) return *number;
    }
    return 0;
  }

  void find_flags() {
    std::set<std::uint32_t> needed;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::block)
        for (const ir::Word& w : program_.words_of(program_.blocks[s.payload]))
          needed.insert(empty_here(i, w.value, true));
      passes::for_each_root(
          program_, s,
          [&](ExpressionId root) {
            passes::for_each_node(program_, root, [&](ExpressionId id) {
              if (!is_equality(id)) return;
              needed.insert(asked(id));
              needed.insert(empty_here(i, program_.at(id).a, false));
              needed.insert(empty_here(i, program_.at(id).b, false));
            });
          },
          [](ir::VariableId) {});
    }
    needed.erase(0);
    for (const std::uint32_t number : needed) {
      const char letter = passes::kArgumentLetters[*passes::position_of_local(number)].letter;
      locals_.at(number).flag = add_symbol(std::string("NO_") + letter, ir::ValueType::boolean);
    }
  }

  // --- statements

  void rewrite(bool takes) {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      if (i == 0) head(takes);
      index_ = i;
      statement(program_.statements[i]);
    }
    out_.finish();
  }

  void head(bool takes) {
    if (takes) {
      ir::Structure procedure;
      procedure.first_symbol = first_parameter_;
      procedure.symbol_count = first_local_ - first_parameter_;
      out_.emit_structure(StatementKind::procedure, procedure);
      // M98 shares them, G65 does not: this text does not say which calls it.
      raising_.cannot(
          passes::of_call("what a caller by M98 has in the local variables that are taken as arguments here"),
          program_.statements.front().span);
      raising_.diagnostics.back().severity = text::Severity::warning;
      if (program_.name.size() > 1 && program_.name.front() == 'O')
        program_.name.front() = 'L';
      else
        raising_.cannot(passes::of_call("a macro without a program number"), program_.statements.front().span);
    }
    define(first_local_, first_flag_);
    define(first_flag_, static_cast<std::uint32_t>(program_.symbols.size()));
    for (const auto& [number, local] : locals_) {
      if (local.flag == ir::SymbolId::none) continue;
      ir::Variable given;
      given.bank = ir::Bank::system;
      given.number = find_system_variable("$P_SUBPAR");
      given.name = program_.strings.add("$P_SUBPAR");
      given.index = program_.add_constant(static_cast<double>(*passes::position_of_local(number) + 1), {}, false);
      const ExpressionId value = program_.add_operator(Operator::logic_not, program_.add_variable(given));
      out_.emit_assign(program_.add(of(local.flag)), value);
    }
  }
  void define(std::uint32_t first, std::uint32_t last) {
    if (first == last) return;
    ir::Structure definition;
    definition.first_symbol = first;
    definition.symbol_count = last - first;
    out_.emit_structure(StatementKind::define, definition);
  }

  static ir::Variable of(ir::SymbolId symbol) {
    ir::Variable v;
    v.bank = ir::Bank::named;
    v.symbol = symbol;
    return v;
  }
  ExpressionId is_empty(std::uint32_t number) { return program_.add_variable(of(locals_.at(number).flag)); }

  void statement(const ir::Statement& s) {
    if (s.kind == StatementKind::block) return block(s);
    if (s.kind == StatementKind::assign) return assign(s);
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) {
      for (const ir::Argument& argument : program_.arguments_of(program_.calls[s.payload]))
        if (empty_here(index_, argument.value, true) != 0)
          raising_.cannot(passes::not_known("an argument that may be empty"), s.span);
    }
    if (s.kind == StatementKind::go_to) {
      const ExpressionId condition = conditioned(program_.jumps[s.payload].condition);
      program_.jumps[s.payload].condition = condition;
    }
    if (s.kind == StatementKind::if_begin || s.kind == StatementKind::while_begin) {
      const ExpressionId condition = conditioned(program_.structures[s.payload].condition);
      program_.structures[s.payload].condition = condition;
    }
    out_.keep();
  }

  void assign(const ir::Statement& s) {
    const ir::Assign set = program_.assigns[s.payload];
    if (empty_here(index_, set.value, true) != 0)
      raising_.cannot(passes::not_known("a value that may be empty, handed on to another variable,"), s.span);
    out_.keep();
    const auto number = local_of(program_.at(set.target));
    if (!number || locals_.at(*number).flag == ir::SymbolId::none) return;
    out_.emit_assign(program_.add(of(locals_.at(*number).flag)), program_.add_constant(0.0, {}, false));
  }

  ExpressionId conditioned(ExpressionId id) {
    if (id == ExpressionId::none) return id;
    ir::Expression e = program_.at(id);
    if (e.op == Operator::logic_and || e.op == Operator::logic_or || e.op == Operator::logic_xor ||
        e.op == Operator::logic_not) {
      e.a = conditioned(e.a);
      if (e.op != Operator::logic_not) e.b = conditioned(e.b);
      return program_.add(e);
    }
    if (!is_equality(id)) return id;
    const bool equal = e.op == Operator::equal;
    if (const std::uint32_t number = asked(id); number != 0)
      return equal ? is_empty(number) : program_.add_operator(Operator::logic_not, is_empty(number));
    const std::uint32_t a = empty_here(index_, e.a, false);
    const std::uint32_t b = empty_here(index_, e.b, false);
    if (a == 0 && b == 0) return id;
    if (a != 0 && b != 0) {
      raising_.cannot(passes::not_known("a comparison of two variables that may be empty"), e.span);
      return id;
    }
    // An empty one equals no number, not even 0.
    const ExpressionId empty = is_empty(a != 0 ? a : b);
    if (!equal) return program_.add_operator(Operator::logic_or, empty, id);
    return program_.add_operator(Operator::logic_and, program_.add_operator(Operator::logic_not, empty), id);
  }

  // Once for each case in which its variables may be empty.
  void block(const ir::Statement& s) {
    const ir::Block block = program_.blocks[s.payload];
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    std::vector<std::uint32_t> numbers;
    for (const ir::Word& w : words) {
      const std::uint32_t number = empty_here(index_, w.value, true);
      if (number != 0 && std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
    }
    const bool many = numbers.size() > kMostVariants;
    const bool skipped = !numbers.empty() && (s.skip_level != 0 || block.rest_level != 0);
    if (many) raising_.cannot(passes::not_known("a block with so many words that may be empty"), s.span);
    if (skipped) raising_.cannot(passes::at_switch("block skip of a block whose words may be empty"), s.span);
    if (numbers.empty() || many || skipped) return out_.keep();
    const std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    variants(codes, words, numbers);
  }

  void variants(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words,
                std::vector<std::uint32_t> numbers) {
    if (numbers.empty()) {
      if (!codes.empty() || !words.empty()) out_.emit_block(codes, words);
      return;
    }
    const std::uint32_t number = numbers.back();
    numbers.pop_back();
    std::vector<ir::Word> without;
    std::ranges::copy_if(words, std::back_inserter(without),
                         [&](const ir::Word& w) { return empty_here(index_, w.value, true) != number; });
    ir::Structure choice;
    choice.condition = is_empty(number);
    out_.emit_structure(StatementKind::if_begin, choice);
    variants(codes, without, numbers);
    out_.emit_structure(StatementKind::else_begin, {});
    variants(codes, words, numbers);
    out_.emit_structure(StatementKind::if_end, {});
  }

  void rename() {
    for (ir::Variable& v : program_.variables) {
      const auto number = local_of(v);
      const auto local = number ? locals_.find(*number) : locals_.end();
      if (local == locals_.end()) continue;
      v.bank = ir::Bank::named;
      v.symbol = local->second.symbol;
    }
  }

  const Raising& raising_;
  ir::Program& program_;
  passes::Rewrite out_;
  std::map<std::uint32_t, Local> locals_;  // by number
  std::set<std::pair<std::uint32_t, ir::VariableId>> unset_;
  std::set<std::uint32_t> reported_;
  std::set<ir::SymbolId> kept_;
  std::uint32_t first_parameter_ = 0;
  std::uint32_t first_local_ = 0;
  std::uint32_t first_flag_ = 0;
  std::uint32_t index_ = 0;
};

}  // namespace

std::set<ir::SymbolId> raise_arguments(const Raising& raising) {
  if (!raising.from.semantics.has_vacant) return {};
  return Macro(raising).run();
}

}  // namespace dripfeed::sinumerik
