// Rule one of the paper: names of the program (DEF) become numbered variables, which a SINUMERIK reads and sets faster.
#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "dialects/optimize/edit.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/value_facts.h"

namespace dripfeed::optimize {

namespace {

using ir::StatementKind;

class NameNumbering {
 public:
  explicit NameNumbering(Work& work)
      : work_(work),
        program_(work.program),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        liveness_(program_, places_, accesses_) {}

  bool run() {
    choose();
    if (number_of_.empty()) return false;
    rewrite();
    return true;
  }

 private:
  // A whole number stays one only as long as nothing rounds it when it is set.
  [[nodiscard]] bool keeps_its_values(Place place) const {
    if (places_.at(place).type == ir::ValueType::real) return true;
    return work_.control.semantics.integer_division_is_real &&
           std::ranges::all_of(program_.statements, [&](const ir::Statement& s) {
             if (s.kind != StatementKind::assign) return true;
             const ir::Assign& assign = program_.assigns[s.payload];
             return places_.of(program_.at(assign.target)) != place || passes::is_whole(program_, assign.value);
           });
  }

  // A loop's counter keeps its type, and what stays where it is keeps its names.
  [[nodiscard]] PlaceSet kept() const {
    PlaceSet out(places_.count());
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      const bool is_own_form = s.kind == StatementKind::assign || s.kind == StatementKind::block ||
                               s.kind == StatementKind::go_to || s.kind == StatementKind::define ||
                               s.kind == StatementKind::if_begin || s.kind == StatementKind::while_begin ||
                               s.kind == StatementKind::repeat_end;
      const Access& access = accesses_[i];
      if (s.kind == StatementKind::block) {
        for (const ir::Word& word : program_.words_of(program_.blocks[s.payload]))
          if (!takes_any_number(word.address) || access.is_fixed) keep_all(word.value, out);
      } else if (!is_own_form || access.is_fixed) {
        for (const Place p : access.reads) out.add(p);
        for (const Place p : access.sets) out.add(p);
      }
    }
    return out;
  }
  void keep_all(ir::ExpressionId id, PlaceSet& out) const {
    std::vector<Place> found;
    add_places(program_, places_, id, found);
    for (const Place p : found) out.add(p);
  }

  // Without a value it is 0 where it begins; a numbered one is what it was.
  [[nodiscard]] std::optional<std::uint32_t> definition_of(ir::SymbolId symbol) const {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != StatementKind::define) continue;
      const ir::Structure& d = program_.structures[s.payload];
      const auto at = static_cast<std::uint32_t>(symbol);
      if (at >= d.first_symbol && at < d.first_symbol + d.symbol_count) return i;
    }
    return {};
  }

  void choose() {
    const PlaceSet stay = kept();
    for (Place place = 0; place < places_.count(); ++place) {
      const PlaceFacts& facts = places_.at(place);
      if (facts.bank != ir::Bank::named || !facts.is_plain || stay.has(place) || !keeps_its_values(place)) continue;
      const std::optional<std::uint32_t> definition = definition_of(facts.symbol);
      if (!definition) continue;
      const std::optional<PlaceFacts> number = free_place(work_);
      if (!number) return;
      variable_of(program_, *number);  // taken
      number_of_[facts.symbol] = *number;
      const ir::Symbol& symbol = program_.at(facts.symbol);
      if (symbol.initial != ir::ExpressionId::none || liveness_.after(*definition, place))
        starts_.push_back(facts.symbol);
      work_.report(Rule::numbered, program_.statements[*definition].line,
                   fmt::format("{} is {}{}", program_.strings.at(symbol.name), number->bank == ir::Bank::r ? "R" : "#",
                               number->number));
    }
  }

  [[nodiscard]] ir::ExpressionId numbered(ir::ExpressionId id) {
    return rebuilt(program_, id, [this](ir::ExpressionId node) {
      const ir::Expression e = program_.at(node);
      if (e.op != ir::Operator::variable) return node;
      const ir::Variable v = program_.at(e.variable);
      const auto found = v.bank == ir::Bank::named ? number_of_.find(v.symbol) : number_of_.end();
      return found == number_of_.end() ? node : read_of(program_, found->second);
    });
  }

  void rewrite() {
    passes::Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    const std::uint32_t first = after_definitions();
    for (std::uint32_t i = 0; i < count; ++i) {
      out.at(i);
      const ir::Statement s = program_.statements[i];
      if (i == first) begin_values(out);
      if (s.kind == StatementKind::define) {
        define(i, out);
      } else if (s.kind == StatementKind::assign) {
        assign(program_.assigns[s.payload], out);
      } else {
        keep_with(program_, i, out, [this](ir::ExpressionId id) { return numbered(id); });
      }
    }
    out.finish();
  }

  void assign(const ir::Assign& old, passes::Rewrite& out) {
    const ir::Variable target = program_.at(old.target);
    const ir::ExpressionId value = numbered(old.value);
    const auto found = target.bank == ir::Bank::named ? number_of_.find(target.symbol) : number_of_.end();
    if (found == number_of_.end() && value == old.value) return out.keep();
    out.emit_assign(found == number_of_.end() ? old.target : variable_of(program_, found->second), value);
  }

  void define(std::uint32_t i, passes::Rewrite& out) const {
    const ir::Structure old = program_.structures[program_.statements[i].payload];
    // Symbols are known by where they stand, so a definition of some that stay is left whole.
    for (std::uint32_t n = 0; n < old.symbol_count; ++n)
      if (!number_of_.contains(static_cast<ir::SymbolId>(old.first_symbol + n))) return out.keep();
  }

  // No definition may stand after a block.
  [[nodiscard]] std::uint32_t after_definitions() const {
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (kind == StatementKind::define || kind == StatementKind::declaration || kind == StatementKind::procedure)
        first = i + 1;
    }
    return first;
  }
  void begin_values(passes::Rewrite& out) {
    for (const ir::SymbolId symbol : starts_) {
      ir::ExpressionId value = program_.at(symbol).initial;
      if (value == ir::ExpressionId::none) value = program_.add_constant(0.0);
      out.emit_assign(variable_of(program_, number_of_.at(symbol)), numbered(value));
      out.last().line = work_.new_line(out.last().line);
    }
    out.labels_from_here();
  }

  Work& work_;
  ir::Program& program_;
  Places places_;
  std::vector<Access> accesses_;
  Liveness liveness_;
  std::map<ir::SymbolId, PlaceFacts> number_of_;
  std::vector<ir::SymbolId> starts_;  // that need a value to begin with
};

}  // namespace

bool number_names(Work& work) { return !work.free.empty() && NameNumbering(work).run(); }

}  // namespace dripfeed::optimize
