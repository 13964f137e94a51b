// Each program that runs is looked at once; of its lines, those that ran count.
#include "dialects/compile/plain/lost_writes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/passes/refusal.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::Bank;

constexpr std::size_t kMostNames = 8;  // in one sentence
constexpr std::string_view kPlainBlocks = "plain blocks";

text::Diagnostic cannot_write(passes::Refusal what, text::Span span) {
  return passes::diagnose(std::move(what), span, std::string(kPlainBlocks));
}

std::string_view bank_name(Bank bank) { return bank == Bank::hash ? "#" : bank == Bank::r ? "R" : "$"; }

std::string key_of(const ir::Program& program, const ir::Variable& v) {
  switch (v.bank) {
    case Bank::hash:
    case Bank::r:
      return v.index == ir::ExpressionId::none ? fmt::format("{}{}", bank_name(v.bank), v.number)
                                               : std::string(bank_name(v.bank));
    case Bank::named:
      return v.symbol == ir::SymbolId::none ? std::string(v.span.in(program.source.text()))
                                            : std::string(program.strings.at(program.at(v.symbol).name));
    case Bank::system: return v.name == ir::StringId::none ? "$" : std::string(program.strings.at(v.name));
  }
  return {};
}

}  // namespace

std::optional<OutsideWrite> outside_write(const ir::Program& program, const ir::Variable& v,
                                          const ir::Control& control) {
  OutsideWrite out{.name = std::string(v.span.in(program.source.text())), .variable = key_of(program, v)};
  if (out.name.empty()) out.name = out.variable;
  const bool has_number = v.index == ir::ExpressionId::none;
  if (v.bank == Bank::hash && has_number) {
    const ir::VariableRange* range = ir::find_variable(control, Bank::hash, v.number);
    if (range != nullptr && range->use == ir::VariableUse::local) return std::nullopt;
    out.is_shared = range != nullptr && range->use != ir::VariableUse::system;
  } else if (v.bank == Bank::hash || v.bank == Bank::r) {
    out.is_shared = true;
  } else if (v.bank == Bank::named) {
    if (v.symbol != ir::SymbolId::none && !program.at(v.symbol).is_global) return std::nullopt;
    out.is_shared = true;
  } else {
    const bool in_table = v.number < control.system_variables.size();
    // Its shift is in the positions.
    if (in_table && control.system_variables[v.number].kind == ir::SystemValue::programmable_frame) return std::nullopt;
    out.is_shared = ir::use_of_system(control, v.number) == ir::SystemUse::memory;
  }
  return out;
}

std::map<std::uint32_t, std::size_t> writes_by_line(const ir::Program& program, const ir::Control& control) {
  std::map<std::uint32_t, std::size_t> out;
  for (const ir::Statement& s : program.statements) {
    if (s.kind == ir::StatementKind::output) ++out[s.line];
    if (s.kind == ir::StatementKind::assign &&
        outside_write(program, program.at(program.assigns[s.payload].target), control))
      ++out[s.line];
    if (s.kind != ir::StatementKind::block) continue;
    const auto codes = program.codes_of(program.blocks[s.payload]);
    if (std::ranges::find(codes, ir::Function::data_input, &ir::Code::function) != codes.end()) ++out[s.line];
  }
  return out;
}

ByLine<LostWrites::Writes> LostWrites::look_at(const ir::Program& program) {
  ByLine<Writes> out;
  for (const ir::Statement& s : program.statements) {
    // A count of parts reads itself, for no one but those who come later.
    const bool assigns = s.kind == ir::StatementKind::assign;
    const std::string target = assigns ? key_of(program, program.at(program.assigns[s.payload].target)) : "";
    for (const passes::VariableUseAt& use : passes::variables_of(program, s)) {
      const ir::Variable& v = program.at(use.variable);
      if (!use.set) {
        if (std::string key = key_of(program, v); key != target) read_.insert(std::move(key));
        continue;
      }
      if (program.is_standard) continue;
      if (std::optional<OutsideWrite> write = outside_write(program, v, control_))
        out.row(s.line).push_back(std::move(*write));
    }
    if (s.kind == ir::StatementKind::native && program.natives[s.payload].writes) {
      const std::string name(program.strings.at(program.natives[s.payload].name));
      out.row(s.line).push_back({.name = "a file (" + name + ")", .variable = name, .is_shared = false});
    }
    if (s.kind == ir::StatementKind::output)
      out.row(s.line).push_back({.name = "a device", .variable = "a device", .is_shared = false});
  }
  return out;
}

void LostWrites::executed(std::uint32_t index, const ir::Program* program, std::uint32_t line, text::Span place) {
  ByLine<Writes>* lines = programs_.of(index);
  if (lines == nullptr) lines = &programs_.add(index, program == nullptr ? ByLine<Writes>() : look_at(*program));
  Writes* const writes = lines->at(line);
  if (writes == nullptr) return;
  for (const OutsideWrite& write : *writes)
    if (reported_.insert(write.variable).second) found_.push_back({write, place});
  writes->clear();  // once is enough
}

std::vector<text::Diagnostic> LostWrites::found() const {
  std::vector<text::Diagnostic> out;
  std::vector<std::string> computed_with;
  text::Span first;
  for (const Found& one : found_) {
    const std::string& key = one.write.variable;
    const bool may_be_read = read_.contains(key) || read_.contains(key.substr(0, 1)) || key.size() == 1;
    if (!one.write.is_shared || !may_be_read) {
      const bool is_variable = one.write.is_shared;
      out.push_back(cannot_write(
          passes::kept_value(is_variable ? fmt::format("the value that {} keeps for others", one.write.name)
                                         : fmt::format("the write to {}", one.write.name)),
          one.place));
      continue;
    }
    if (computed_with.empty()) first = one.place;
    computed_with.push_back(one.write.name);
  }
  if (computed_with.empty()) return out;
  const std::size_t more = computed_with.size() - std::min(computed_with.size(), kMostNames);
  computed_with.resize(computed_with.size() - more);
  out.push_back(cannot_write(passes::kept_value(fmt::format("what {}{} hold at the end", fmt::join(computed_with, ", "),
                                                            more == 0 ? "" : fmt::format(" and {} more", more))),
                             first));
  out.back().severity = text::Severity::warning;
  return out;
}

}  // namespace dripfeed::compile
