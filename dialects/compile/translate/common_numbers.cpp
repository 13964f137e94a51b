// The call graph is walked by names; programs of the library are read when they are met.
#include "dialects/compile/translate/common_numbers.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "dialects/compile/dialect/definition_files.h"
#include "dialects/macro_b/writer/place_globals.h"
#include "dialects/passes/allocation.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

bool goes_back(StatementKind kind) {
  return kind == StatementKind::procedure || kind == StatementKind::subprogram_return ||
         kind == StatementKind::return_to;
}

}  // namespace

CommonNumbers::CommonNumbers(const ir::Program& text, const ir::Control& from, const ir::Control& to,
                             ProgramLibrary* library)
    : to_(to), library_(library) {
  const auto count = static_cast<std::uint32_t>(text.statements.size());
  if (text.sections.empty()) note(text.name, text, 0, count);
  for (const ir::Section& section : text.sections)
    note(std::string(text.strings.at(section.name)), text, section.first, section.last);
  for (auto& [name, facts] : facts_) facts.in_text = true;
  if (library == nullptr) return;
  ir::Program definitions;
  add_definitions(definitions, from, *library);
  reserved_ = macro_b::place_globals(definitions, to).reserved;
}

void CommonNumbers::note(const std::string& name, const ir::Program& program, std::uint32_t first, std::uint32_t last) {
  Facts facts;
  facts.is_main = true;
  for (std::uint32_t i = first; i < last; ++i) {
    const ir::Statement& s = program.statements[i];
    facts.is_main = facts.is_main && !goes_back(s.kind);
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) {
      const ir::Call& call = program.calls[s.payload];
      facts.calls_unknown |= call.name == ir::StringId::none || call.kind == ir::CallKind::external;
      facts.calls.emplace(program.strings.at(call.name));
    }
    for (const passes::VariableUseAt& use : passes::variables_of(program, s)) {
      const ir::Variable& v = program.at(use.variable);
      if (v.bank == ir::Bank::r && v.index == ir::ExpressionId::none) facts.numbers.insert(v.number);
    }
  }
  facts_.insert_or_assign(name, std::move(facts));
}

// nullptr where there is no program.
const CommonNumbers::Facts* CommonNumbers::facts_of(const std::string& name) {
  if (const auto known = facts_.find(name); known != facts_.end()) return &known->second;
  const ir::Program* program = library_ == nullptr ? nullptr : library_->find(name);
  // Which of several programs of a text is meant, and what they share with one another, is not looked into.
  if (program == nullptr || program->sections.size() > 1) return nullptr;
  note(name, *program, 0, static_cast<std::uint32_t>(program->statements.size()));
  return &facts_.at(name);
}

std::optional<std::set<std::string>> CommonNumbers::reached_from(const std::string& name) {
  std::set<std::string> reached;
  std::vector<std::string> open = {name};
  while (!open.empty()) {
    const Facts* facts = facts_of(open.back());
    open.pop_back();
    if (facts == nullptr || facts->calls_unknown) return std::nullopt;
    for (const std::string& called : facts->calls)
      if (reached.insert(called).second) open.push_back(called);
  }
  return reached;
}

std::optional<ir::Control> CommonNumbers::control_for(const std::string& program) {
  const auto reached = reached_from(program);
  if (!reached || reached->contains(program)) return std::nullopt;
  std::set<std::string> together = *reached;
  bool has_main = facts_.at(program).is_main;
  std::vector<std::string> callers;
  for (const auto& [name, facts] : facts_)
    if (facts.in_text && name != program) callers.push_back(name);
  for (const std::string& name : callers) {
    const auto below = reached_from(name);
    if (!below) return std::nullopt;
    together.insert(below->begin(), below->end());  // their numbers of the other bank
    if (!below->contains(program)) continue;
    together.insert(name);
    has_main = has_main || facts_.at(name).is_main;
  }
  if (!has_main) return std::nullopt;

  std::set<std::uint32_t> taken = reserved_;
  together.insert(program);
  for (const std::string& name : together) {
    for (const std::uint32_t n : facts_.at(name).numbers)
      taken.insert(passes::shared_number(to_, ir::Bank::hash, n, reserved_));
    const auto below = reached_from(name);
    const bool at_once = reached->contains(name) || (below && below->contains(program));
    if (at_once && given_.contains(name)) taken.insert(given_.at(name).begin(), given_.at(name).end());
  }
  ir::Control widened = to_;
  for (const ir::VariableUse use : {ir::VariableUse::common, ir::VariableUse::permanent}) {
    for (const ir::VariableRange& range : to_.variables) {
      if (range.bank != ir::Bank::hash || range.use != use || !range.writable) continue;
      for (std::uint32_t n = range.first; n <= range.last; ++n) {
        if (taken.contains(n)) continue;
        ir::VariableRange free = range;
        free.use = ir::VariableUse::local;
        free.first = n;
        while (n < range.last && !taken.contains(n + 1)) ++n;
        free.last = n;
        widened.variables.push_back(free);
      }
    }
  }
  return widened;
}

void CommonNumbers::took(const std::string& program, const ir::Program& raised) {
  std::set<std::uint32_t>& given = given_[program];
  for (const ir::Statement& s : raised.statements) {
    for (const passes::VariableUseAt& use : passes::variables_of(raised, s)) {
      const ir::Variable& v = raised.at(use.variable);
      if (v.bank != ir::Bank::hash) continue;
      if (v.index == ir::ExpressionId::none)
        given.insert(v.number);
      else
        took_array(given, raised, v.index);
    }
  }
}

// Where it begins is written, where it ends is not: no one gets what comes after it.
void CommonNumbers::took_array(std::set<std::uint32_t>& given, const ir::Program& raised, ir::ExpressionId index) {
  const ir::Expression& e = raised.at(index);
  const bool has_base = e.op == ir::Operator::add && raised.at(e.b).op == ir::Operator::constant;
  const auto base = has_base ? static_cast<std::uint32_t>(raised.at(e.b).value) : 0;
  if (reserved_.contains(base)) return;
  for (const ir::VariableRange& range : to_.variables) {
    const bool own = range.bank == ir::Bank::hash && range.use != ir::VariableUse::system;
    const bool local = own && range.use == ir::VariableUse::local;
    if (local && has_base && range.first <= base && base <= range.last) return;
    if (!own || local) continue;
    for (std::uint32_t n = std::max(base, range.first); n <= range.last; ++n) given.insert(n);
  }
}

}  // namespace dripfeed::compile
