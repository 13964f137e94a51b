// The motion and G90 or G91 in effect, on all paths.
#include "dialects/compile/plain/machine_moves.h"

#include <algorithm>
#include <optional>
#include <string>

#include "dialects/facts/needs.h"
#include "dialects/facts/resolved.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

using ir::Function;

// Where one of the two goes at rapid by itself.
constexpr std::string_view kOther = "a move to a machine position by another motion than G0";
constexpr std::string_view kUnknown =
    "a move to a machine position where G0 or another motion is not known, taken as G0,";
constexpr std::string_view kIncrement = "a move to a machine position together with G91";

// MD10760 G53_TOOLCORR (ISO Milling, "Machine coordinate system").
constexpr std::string_view kLength =
    "SUPA where a tool length may be in effect, which MD10760 leaves out or keeps (D0 in the block states that it "
    "is left out),";

bool goes_to_machine(const ir::Code& c) { return c.function == Function::machine_coordinates; }

class MachineMoves {
 public:
  MachineMoves(const ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        to_(to),
        one_is_rapid_(from.semantics.machine_move == ir::MachineMove::rapid ||
                      to.semantics.machine_move == ir::MachineMove::rapid),
        modes_(program, from),
        from_(from) {}

  std::vector<text::Diagnostic> run() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != ir::StatementKind::block) continue;
      const ir::Block& block = program_.blocks[s.payload];
      if (std::ranges::any_of(program_.codes_of(block), goes_to_machine) &&
          std::ranges::any_of(program_.words_of(block), ir::is_axis, &ir::Word::address))
        look(i, s, block);
    }
    return std::move(diagnostics_);
  }

 private:
  void look(std::uint32_t i, const ir::Statement& s, const ir::Block& block) {
    std::optional<Function> motion;
    std::optional<Function> distance;
    if (const facts::Facts* facts = modes_.before(i); facts != nullptr) {
      distance = (*facts)[facts::Mode::distance].value.function;
      if (const facts::Setting* certain = (*facts)[facts::Mode::motion].certain()) motion = certain->function;
    }
    for (const ir::Code& c : program_.codes_of(block)) {
      if (c.group == ir::ModalGroup::motion) motion = c.function;
      if (facts::mode_of(c) == facts::Mode::distance) distance = c.function;
    }
    const auto is_increment = [&](const ir::Word& w) {
      return ir::is_axis(w.address) && (w.mode == ir::WordMode::incremental ||
                                        (w.mode == ir::WordMode::as_modal && distance == Function::incremental));
    };
    if (std::ranges::any_of(program_.words_of(block), is_increment))
      report(kIncrement, s, text::Severity::error);
    else if (one_is_rapid_ && !motion)
      report(kUnknown, s, text::Severity::warning);
    else if (one_is_rapid_ && *motion != Function::rapid)
      report(kOther, s, text::Severity::error);
    // The others leave the length out.
    if (keeps_length(i, block)) report(kLength, s, text::Severity::error);
  }

  [[nodiscard]] bool keeps_length(std::uint32_t i, const ir::Block& block) const {
    return from_.semantics.machine_move == ir::MachineMove::without_frames &&
           facts::moves_length_to_machine(program_, block, from_) && length_at(i) != facts::ToolLength::off;
  }

  [[nodiscard]] facts::ToolLength length_at(std::uint32_t i) const {
    const std::optional<facts::Facts> here = modes_.at(i);
    return here ? facts::tool_length(*here) : facts::ToolLength::unknown;
  }

  void report(passes::Refusal what, const ir::Statement& s, text::Severity severity) {
    diagnostics_.push_back(passes::diagnose(std::move(what), s.span, to_.title));
    diagnostics_.back().severity = severity;
  }

  const ir::Program& program_;
  const ir::Control& to_;
  bool one_is_rapid_;
  facts::Resolved modes_;
  const ir::Control& from_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

std::vector<text::Diagnostic> unlike_machine_moves(const ir::Program& program, const ir::Control& from,
                                                   const ir::Control& to) {
  if (from.semantics.machine_move == to.semantics.machine_move || std::ranges::none_of(program.codes, goes_to_machine))
    return {};
  return MachineMoves(program, from, to).run();
}

}  // namespace dripfeed::compile
