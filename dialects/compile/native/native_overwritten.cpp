// What is reached after the setting, and from where a read is reached without it.
#include "dialects/compile/native/native_overwritten.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/compile/native/native_flow.h"
#include "dialects/compile/native/native_other_uses.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using Statements = std::vector<std::uint32_t>;

// Those of `candidates` that a run may execute between the setting and a read.
Statements between(const ir::Program& program, std::uint32_t setting, Statements candidates,
                   const std::vector<bool>& reads) {
  if (candidates.empty()) return candidates;
  constexpr std::size_t kMost = 100;  // each costs a walk over the program
  std::vector<bool> stops(reads.size(), false);
  const std::vector<bool> after = reached_after(program, {setting}, stops);
  // A modal call is made where the program moves.
  std::erase_if(candidates, [&](std::uint32_t one) {
    return !after[one] && program.statements[one].kind != ir::StatementKind::modal_call;
  });
  stops[setting] = true;
  // A value that nothing here reads is for others.
  const bool is_read = std::ranges::find(reads, true) != reads.end();
  const auto leads_to_read = [&](const Statements& from) {
    const std::vector<bool> reached = reached_after(program, from, stops);
    for (std::size_t i = 0; i < reads.size(); ++i)
      if (reads[i] && reached[i]) return true;
    return !is_read;
  };
  if (candidates.size() > kMost) return leads_to_read(candidates) ? candidates : Statements{};
  std::erase_if(candidates, [&](std::uint32_t one) { return !leads_to_read({one}); });
  return candidates;
}

// "O2 (line 7), O9010 (lines 8 and 9)"
std::string names_of(const ir::Program& program, const Statements& calls) {
  std::map<std::string, Statements> lines;
  for (const std::uint32_t one : calls) {
    const ir::Statement& s = program.statements[one];
    std::string name = facts::is_call(s.kind) ? std::string(program.strings.at(program.calls[s.payload].name))
                                              : std::string("EXECSTRING");
    if (name.empty()) name = "a program whose name is computed";
    Statements& here = lines[name];
    if (here.empty() || here.back() != s.line) here.push_back(s.line);
  }
  std::vector<std::string> out;
  out.reserve(lines.size());
  for (const auto& [name, here] : lines)
    out.push_back(fmt::format("{} (line{} {})", name, here.size() == 1 ? "" : "s", in_words(here)));
  return fmt::format("{}", fmt::join(out, ", "));
}

}  // namespace

Overwritten overwritten(const ir::Program& program, const ir::Control& control, const NativeVariable& variable,
                        std::string_view target, std::uint32_t setting, const std::vector<bool>& scope) {
  const OtherUses others = other_uses(program, variable, target, seen_by(program, control, variable), scope);
  if (!others.actions.empty())
    return {true, fmt::format("{} may set it at any time", lines_of(program, others.actions)), others.actions};
  std::vector<bool> reads(scope.size(), false);
  for (std::uint32_t i = 0; i < scope.size(); ++i) reads[i] = scope[i] && variable.is_read_by(program, i);
  for (const std::uint32_t one : others.reads) reads[one] = true;
  const Statements calls = between(program, setting, others.calls, reads);
  for (const std::uint32_t one : others.calls) reads[one] = true;
  const Statements writes = between(program, setting, others.writes, reads);
  if (!writes.empty())
    return {true,
            fmt::format("{} may set it before it is read, by a computed number or a text that is executed",
                        lines_of(program, writes)),
            writes};
  const Statements returns = between(program, setting, others.returns, reads);
  if (!returns.empty())
    return {true,
            fmt::format("{} may set it before it is read: a procedure gives back values in its arguments",
                        lines_of(program, returns)),
            returns};
  if (calls.empty()) return {};
  return {false,
          fmt::format("programs that the native text does not hold may set it before it is read: {}",
                      names_of(program, calls)),
          calls};
}

Overwritten overwritten_parameter(const ir::Program& program, const ir::Structure& procedure, ir::SymbolId symbol) {
  const auto head = std::ranges::find_if(program.statements, [&](const ir::Statement& s) {
    return s.kind == ir::StatementKind::procedure && &program.structures[s.payload] == &procedure;
  });
  const facts::StatementRange own =
      facts::section_of(program, static_cast<std::uint32_t>(head - program.statements.begin()));
  std::vector<bool> reads(program.statements.size(), false);
  std::vector<bool> scope = reads;
  const NativeVariable variable = NativeVariable::of_symbol(symbol);
  for (std::uint32_t i = own.first; i < own.last; ++i) {
    scope[i] = true;
    reads[i] = variable.is_read_by(program, i);
  }
  const std::string name = text::upper_case(program.strings.at(program.at(symbol).name));
  const OtherUses others = other_uses(program, variable, name, SeenBy::own_program, scope);
  Statements writes = others.writes;
  writes.insert(writes.end(), others.returns.begin(), others.returns.end());
  for (const NativeVariable::Setting& one : variable.settings(program)) writes.push_back(one.statement);
  const std::vector<bool> reached = reached_from(program, own.first, reads);
  std::erase_if(writes, [&](std::uint32_t one) { return reads[one] || !reached[one]; });
  if (writes.empty()) return {};
  std::ranges::sort(writes);
  return {true, fmt::format("{} may set it before the called program reads it", lines_of(program, writes)), writes};
}

std::string lines_of(const ir::Program& program, const std::vector<std::uint32_t>& statements) {
  Statements lines;
  for (const std::uint32_t one : statements) lines.push_back(program.statements[one].line);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return fmt::format("line{} {} of the native program", lines.size() == 1 ? "" : "s", in_words(lines));
}

std::string in_words(const std::vector<std::uint32_t>& lines) {
  constexpr std::size_t kMost = 8;
  const std::size_t shown = std::min(lines.size(), kMost);
  std::string out;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == lines.size();
    out += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", lines[i]);
  }
  if (shown < lines.size()) out += fmt::format(" and {} more", lines.size() - shown);
  return out;
}

}  // namespace dripfeed::compile
