// A cycle's initial level is where the tool stands when the cycle begins, and stays so until G80.
#include "dialects/macro_b/writer/drill_levels.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "dialects/facts/resolved.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

namespace {

using facts::Mode;
using ir::Address;
using ir::Function;

class DrillLevels {
 public:
  DrillLevels(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to), facts_(program, from) {}

  std::vector<text::Diagnostic> run() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i)
      if (program_.statements[i].kind == ir::StatementKind::block) block(i);
    return std::move(diagnostics_);
  }

 private:
  void block(std::uint32_t i) {
    const ir::Block& block = program_.blocks[program_.statements[i].payload];
    const facts::Facts* before = facts_.before(i);
    if (before == nullptr) return;
    const facts::Setting* mode = (*before)[Mode::cycle].certain();
    bool drills = mode != nullptr && mode->function == Function::drill;
    const bool stays = drills;
    bool along_x = drills && mode->argument >= ir::kDrillAlongX;
    for (const ir::Code& c : program_.codes_of(block)) {
      if (c.function == Function::data_input || c.function == Function::not_modelled) return;
      if (c.group != ir::ModalGroup::cycle && c.group != ir::ModalGroup::motion) continue;
      drills = c.function == Function::drill;
      along_x = drills && c.argument >= ir::kDrillAlongX;
    }
    if (!drills) return;
    for (std::uint32_t n = block.first_word; n < block.first_word + block.word_count; ++n)
      if (program_.words[n].address == Address::r)
        level(program_.words[n], along_x ? std::nullopt : initial_level(*before, stays), *before);
  }

  static std::optional<double> initial_level(const facts::Facts& before, bool stays) {
    if (!stays) {
      const double* z = before[facts::Number::z].certain();
      return z == nullptr ? std::nullopt : std::optional(*z);
    }
    const facts::Written* kept = before[facts::Kept::initial].certain();
    return kept == nullptr || !kept->is_stated || !kept->is_number ? std::nullopt : std::optional(kept->number);
  }

  void level(ir::Word& w, std::optional<double> initial, const facts::Facts& before) {
    const facts::Known<facts::Setting>& distance = before[Mode::distance];
    if (distance.agrees() && distance.value.function == Function::incremental) return;  // a distance on both
    const std::optional<double> written = number(w.value);
    if (!initial || !written) {
      diagnostics_.push_back(passes::diagnose(
          passes::not_known(
              "R of a drilling cycle, a distance from the initial level on one of the two controls, where "
              "that level is not known,"),
          w.span, to_.title));
      return;
    }
    w.value = program_.add_constant(from_.semantics.drill_r_from_initial ? *initial + *written : *written - *initial,
                                    program_.at(w.value).span);
  }

  // As a length; nothing where it is computed, or counts increments.
  [[nodiscard]] std::optional<double> number(ir::ExpressionId id) const {
    if (id == ir::ExpressionId::none) return std::nullopt;
    const ir::Expression& e = program_.at(id);
    const bool negative = e.op == ir::Operator::negate;
    const ir::Expression& written = negative ? program_.at(e.a) : e;
    if (written.op != ir::Operator::constant) return std::nullopt;
    const bool counts =
        !written.has_point && written.value != 0.0 && from_.semantics.decimal_mode == ir::DecimalMode::least_increment;
    return counts ? std::nullopt : std::optional(negative ? -written.value : written.value);
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  facts::Resolved facts_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

std::vector<text::Diagnostic> drill_levels(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  // What is written for taps of other languages is in the terms of `to` already.
  const bool alike = from.semantics.drill_r_from_initial == to.semantics.drill_r_from_initial;
  if (alike || !ir::has_numbered_variables(from)) return {};
  const bool drills = std::ranges::find(program.codes, Function::drill, &ir::Code::function) != program.codes.end();
  return drills ? DrillLevels(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::macro_b
