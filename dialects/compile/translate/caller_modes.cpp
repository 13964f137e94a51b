// The text is read as a block of the control's own language: what is not a code of a group that stays in effect is
// refused.
#include "dialects/compile/translate/caller_modes.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::compile {

namespace {

using ir::ModalGroup;

bool stays(ModalGroup group) {
  constexpr ModalGroup kGroups[] = {ModalGroup::motion,       ModalGroup::plane,       ModalGroup::distance,
                                    ModalGroup::feed,         ModalGroup::unit,        ModalGroup::comp,
                                    ModalGroup::return_level, ModalGroup::work_offset, ModalGroup::surface_speed,
                                    ModalGroup::exact_stop,   ModalGroup::diameter,    ModalGroup::spindle,
                                    ModalGroup::coolant};
  return std::ranges::find(kGroups, group) != std::end(kGroups);
}

}  // namespace

std::expected<std::vector<ir::CodeRow>, std::string> read_caller_modes(const Dialect& dialect,
                                                                       const ir::Control& control,
                                                                       std::string_view text) {
  const text::Source source("modes", std::string(text));
  const ir::ReadResult read = dialect.read(source, control);
  const auto refuse = [&](text::Span span) {
    return std::unexpected(
        fmt::format("\"{}\" is not a mode of {}: codes that stay in effect are, as in \"G18 G95 G97\"",
                    span.empty() ? text : span.in(source.text()), control.title));
  };
  for (const text::Diagnostic& d : read.diagnostics)
    if (d.severity == text::Severity::error) return refuse(d.span);
  std::vector<ir::CodeRow> modes;
  for (const ir::Statement& s : read.program.statements) {
    if (s.kind == ir::StatementKind::empty) continue;
    if (s.kind != ir::StatementKind::block) return refuse(s.span);
    const ir::Block& block = read.program.blocks[s.payload];
    if (block.word_count != 0) return refuse(read.program.words_of(block).front().span);
    for (const ir::Code& code : read.program.codes_of(block)) {
      if (!stays(code.group) || code.number != ir::ExpressionId::none || code.function == ir::Function::not_modelled)
        return refuse(code.span);
      ir::CodeRow& row = modes.emplace_back();
      row.function = code.function;
      row.argument = code.argument;
      row.group = code.group;
    }
  }
  if (modes.empty()) return refuse({});
  return modes;
}

}  // namespace dripfeed::compile
