// The other controls leave the tool length out where they go to a machine position. Whether SINUMERIK does,
// MD10760 G53_TOOLCORR decides (ISO Milling, "Machine coordinate system"); D0 says so on all machines.
//
//   G43 H1 …                 D1 …
//   G53 Z0.                  SUPA Z0 D0
//                            D1
#include <algorithm>
#include <cstdint>
#include <vector>

#include "dialects/facts/needs.h"
#include "dialects/facts/resolved.h"
#include "dialects/passes/rewrite.h"
#include "dialects/sinumerik/writer/raise.h"
#include "dialects/sinumerik/writer/tool_offsets.h"

namespace dripfeed::sinumerik {

namespace {

using facts::ToolLength;
using ir::Function;

ir::Code code_of(Function function, std::int16_t argument, text::Span span) {
  ir::Code code;
  code.function = function;
  code.argument = argument;
  code.group = ir::ModalGroup::length_offset;
  code.letter = 'G';
  code.span = span;
  return code;
}

// A caller or a called program decides. Taken away it would be missed: the tool would come down by its length.
void warn_taken_as_on(const Raising& raising, text::Span span) {
  raising.report(text::DiagnosticId::unknown_modal_state, span,
                 {"whether the tool length is in effect", "it is taken away here and put back after it (D1)"});
  raising.diagnostics.back().severity = text::Severity::warning;
}

}  // namespace

void raise_machine_moves(const Raising& raising) {
  ir::Program& program = raising.program;
  if (raising.from.semantics.d_selects_edge) return;
  const auto goes = [&](const ir::Statement& s) {
    return s.kind == ir::StatementKind::block &&
           facts::moves_length_to_machine(program, program.blocks[s.payload], raising.from);
  };
  if (std::ranges::none_of(program.statements, goes)) return;
  const facts::Resolved known(program, raising.from);
  passes::Rewrite out(program);
  const auto count = static_cast<std::uint32_t>(program.statements.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    out.at(i);
    const ir::Statement s = program.statements[i];
    const bool looks = goes(s) && program.blocks[s.payload].rest_level == 0;  // otherwise it is refused
    const std::optional<facts::Facts> here = looks ? known.at(i) : std::nullopt;
    const ToolLength none = looks ? ToolLength::unknown : ToolLength::off;  // no path leads here
    const ToolLength length = here ? facts::tool_length(*here) : none;
    if (length == ToolLength::unknown) warn_taken_as_on(raising, s.span);
    if (length == ToolLength::off) {
      out.keep();
      continue;
    }
    const ir::Block block = program.blocks[s.payload];
    const auto codes = program.codes_of(block);
    const auto words = program.words_of(block);
    std::vector<ir::Code> all(codes.begin(), codes.end());
    all.push_back(code_of(Function::length_offset_off, 0, s.span));
    out.emit_block(all, {words.begin(), words.end()});
    out.last().skip_level = s.skip_level;
    out.emit_block({code_of(Function::length_offset_plus, kLengthAgain, s.span)}, {});
    out.last().skip_level = s.skip_level;
  }
  out.finish();
}

}  // namespace dripfeed::sinumerik
