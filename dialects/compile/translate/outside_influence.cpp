// By kind of statement, then by variable: a table of what a program may not hold.
#include "dialects/compile/translate/outside_influence.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "dialects/facts/calls.h"
#include "dialects/ir/frame_use.h"
#include "dialects/passes/set_on_all_paths.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

struct KindRow {
  StatementKind kind;
  std::string_view what;
};
constexpr auto kKinds = std::to_array<KindRow>({
    {StatementKind::procedure, "a program with parameters"},
    {StatementKind::execute_text, "a text that is executed as a block"},
    {StatementKind::return_to, "a return to a block of the caller"},
});

// Frames and transformations: the moves are known without them.
constexpr auto kFrames = std::to_array<ir::Function>({
    ir::Function::polar_words_on,
    ir::Function::transformation,
    ir::Function::local_shift,
    ir::Function::local_shift_add,
    ir::Function::axial_shift,
    ir::Function::rotate,
    ir::Function::scale,
    ir::Function::mirror,
    ir::Function::data_input,
});

bool has_axes(const ir::Program& program, const ir::Block& block) {
  return std::ranges::any_of(program.words_of(block), ir::is_axis, &ir::Word::address);
}

class Search {
 public:
  explicit Search(const ir::Program& program) : program_(program) {}

  std::optional<OutsideInfluence> run() {
    for (const ir::Statement& s : program_.statements) {
      if (auto found = of_statement(s)) return found;
      for (const passes::VariableUseAt& use : passes::variables_of(program_, s))
        if (auto found = of_variable(program_.at(use.variable))) return found;
    }
    return unset();
  }

 private:
  std::optional<OutsideInfluence> of_statement(const ir::Statement& s) {
    const auto row = std::ranges::find(kKinds, s.kind, &KindRow::kind);
    if (row != kKinds.end()) return OutsideInfluence{std::string(row->what), s.span};
    const bool calls = s.kind == StatementKind::call || s.kind == StatementKind::modal_call;
    if (calls && !facts::is_standard_cycle(program_, s)) return OutsideInfluence{"a call of another program", s.span};
    if (s.kind == StatementKind::native && !program_.natives[s.payload].effects_known)
      return OutsideInfluence{std::string(program_.strings.at(program_.natives[s.payload].name)), s.span};
    if (s.kind != StatementKind::block) return std::nullopt;
    const ir::Block& block = program_.blocks[s.payload];
    for (const ir::Code& c : program_.codes_of(block)) {
      const bool sets = c.function == ir::Function::set_coordinates && has_axes(program_, block);
      const bool ends = ir::ends_frame(c.function, c.argument);
      if (sets || (!ends && std::ranges::find(kFrames, c.function) != kFrames.end()))
        return OutsideInfluence{"another coordinate system (" + std::string(ir::name_of(c.function)) + ")", s.span};
    }
    return std::nullopt;
  }

  std::optional<OutsideInfluence> of_variable(const ir::Variable& v) const {
    const auto named = [&](std::string_view why) {
      return OutsideInfluence{"the variable " + std::string(v.span.in(program_.source.text())) + std::string(why),
                              v.span};
    };
    if (v.bank == ir::Bank::system) return named(", which the control knows,");
    if (v.bank == ir::Bank::named) {
      const bool own = v.symbol != ir::SymbolId::none && !program_.at(v.symbol).is_global;
      return own ? std::nullopt : std::optional(named(", which the control keeps,"));
    }
    return v.index == ir::ExpressionId::none ? std::nullopt : std::optional(named(", whose number is computed,"));
  }

  // Declared ones begin with a value of their own.
  std::optional<OutsideInfluence> unset() const {
    std::map<std::pair<ir::Bank, std::uint32_t>, std::uint32_t> numbers;
    const auto watched = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
      if (v.bank == ir::Bank::named) return std::nullopt;
      return numbers.try_emplace({v.bank, v.number}, static_cast<std::uint32_t>(numbers.size())).first->second;
    };
    const std::vector<passes::UnsetRead> reads = passes::reads_before_set(program_, watched);
    if (reads.empty()) return std::nullopt;
    const ir::Variable& v = program_.at(reads.front().variable);
    return OutsideInfluence{"the variable " + std::string(v.span.in(program_.source.text())) +
                                ", which nothing here sets before it is read,",
                            v.span};
  }

  const ir::Program& program_;
};

}  // namespace

std::optional<OutsideInfluence> outside_influence(const ir::Program& program) { return Search(program).run(); }

}  // namespace dripfeed::compile
