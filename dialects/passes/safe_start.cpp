// The text's order is taken for the order in which it runs: what is stated after a jump was stated as well.
#include "dialects/passes/safe_start.h"

#include <algorithm>
#include <optional>

#include "dialects/ir/sections.h"

namespace dripfeed::passes {

namespace {

using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

bool moves(const ir::Program& program, const ir::Block& block) {
  return std::ranges::any_of(program.words_of(block), ir::is_axis, &ir::Word::address);
}

struct Start {
  std::vector<ModalGroup> stated;
  text::Span first_move;
};

// What is stated up to the first block that moves; nothing when none does or another program may say it.
std::optional<Start> start_of(const ir::Program& program) {
  if (ir::is_subprogram(program)) return std::nullopt;
  Start start;
  for (const ir::Statement& s : program.statements) {
    if (s.kind == StatementKind::call) return std::nullopt;
    if (s.kind != StatementKind::block) continue;
    const ir::Block& block = program.blocks[s.payload];
    for (const ir::Code& c : program.codes_of(block)) start.stated.push_back(c.group);
    start.first_move = s.span;
    if (moves(program, block)) return start;
  }
  return std::nullopt;
}

Function diameter_function(ir::DiameterMode mode) {
  if (mode == ir::DiameterMode::radius) return Function::diameter_off;
  return mode == ir::DiameterMode::diameter ? Function::diameter_on : Function::diameter_absolute_only;
}

struct WarningRow {
  ModalGroup group;
  text::DiagnosticId id;
};
constexpr std::string_view kHowToStateUnit =
    "the translation would have to claim one: state it in the program, by --modes, or in the machine's profile";
constexpr WarningRow kWarnings[] = {
    {ModalGroup::unit, text::DiagnosticId::unit_not_stated},
    {ModalGroup::distance, text::DiagnosticId::distance_mode_not_stated},
};

}  // namespace

UnstatedModes unstated_modes(const ir::Program& program, const ir::Control& from, bool diameter) {
  UnstatedModes out;
  const std::optional<Start> start = start_of(program);
  if (!start) return out;
  const ir::Semantics& s = from.semantics;
  const auto states = [&](ModalGroup group) { return std::ranges::find(start->stated, group) != start->stated.end(); };
  const auto given = [&](ModalGroup group) { return std::ranges::find(from.caller_modes, group, &ir::CodeRow::group); };
  const auto add = [&](ModalGroup group, Function function) {
    if (states(group)) return;
    const auto row = given(group);
    out.modes.push_back({group, row == from.caller_modes.end() ? function : row->function});
  };
  add(ModalGroup::motion, s.power_on_motion);
  add(ModalGroup::plane, s.power_on_plane);
  add(ModalGroup::unit, s.power_on_unit);
  add(ModalGroup::distance, s.power_on_distance);
  if (!states(ModalGroup::surface_speed)) add(ModalGroup::feed, s.power_on_feed);
  if (diameter) add(ModalGroup::diameter, diameter_function(s.power_on_diameter));
  if (s.power_on_known) return out;
  for (const WarningRow& row : kWarnings) {
    const bool by_letter = row.group == ModalGroup::distance && s.incremental_letters_uvw;
    const bool is_given = given(row.group) != from.caller_modes.end();
    if (states(row.group) || by_letter || is_given) continue;
    out.diagnostics.push_back(text::make_diagnostic(row.id, start->first_move));
    // An inch for a millimetre scraps the part: nothing is written that was taken for granted.
    if (row.group != ModalGroup::unit) continue;
    out.diagnostics.back().severity = text::Severity::error;
    out.diagnostics.back().notes = {{.span = start->first_move, .text = std::string(kHowToStateUnit)}};
  }
  return out;
}

void insert_first(ir::Program& program, std::span<const ir::Code> codes) {
  if (codes.empty()) return;
  ir::Block block;
  block.first_code = static_cast<std::uint32_t>(program.codes.size());
  block.code_count = static_cast<std::uint32_t>(codes.size());
  block.first_word = static_cast<std::uint32_t>(program.words.size());
  program.codes.insert(program.codes.end(), codes.begin(), codes.end());
  program.blocks.push_back(block);
  ir::Statement statement;
  statement.kind = StatementKind::block;
  statement.payload = static_cast<std::uint32_t>(program.blocks.size() - 1);
  program.statements.insert(program.statements.begin(), statement);
  for (ir::Label& label : program.labels) ++label.statement;
  for (ir::Structure& structure : program.structures) {
    if (structure.partner != ir::kNoIndex) ++structure.partner;
  }
  for (ir::ForeignPart& part : program.foreign_parts) {
    ++part.first;
    ++part.last;
  }
}

}  // namespace dripfeed::passes
