// First the definitions get their numbers, then the uses are looked through, then the program is rewritten with its
// initial values in front.
#include "dialects/macro_b/writer/place_globals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/set_on_all_paths.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;
using ir::SymbolId;

constexpr std::uint32_t kMostGuards = 8;  // of one array one by one; more are made in a loop

std::uint32_t at_least_one(std::uint32_t size) { return std::max<std::uint32_t>(size, 1); }

std::uint32_t elements_of(const ir::Symbol& s) {
  return at_least_one(s.dimension1) * at_least_one(s.dimension2) * at_least_one(s.dimension3);
}

bool is_number(const ir::Symbol& s) {
  return s.type == ir::ValueType::real || s.type == ir::ValueType::integer || s.type == ir::ValueType::boolean;
}

class Placing {
 public:
  Placing(ir::Program& program, const ir::Control& to) : program_(program), to_(to), out_(program) {}

  PlacedGlobals run() {
    for (const ir::Statement& s : program_.statements)
      if (s.kind == StatementKind::define && s.line != 0) defined_at_.insert(s.line);
    definitions_alone_ = !defined_at_.empty() && std::ranges::all_of(program_.statements, [this](const auto& s) {
      return s.line == 0 || s.kind == StatementKind::define || s.kind == StatementKind::empty || is_initial(s) ||
             s.kind == StatementKind::subprogram_return || s.kind == StatementKind::program_end;
    });
    collect();
    if (known_.empty()) return {};
    point_uses_to_definitions();
    if (!definitions_alone_) note_uses();
    write();
    return std::move(placed_);
  }

 private:
  struct Global {
    bool fits = false;
    bool is_reported = false;
    bool own = false;                             // the text itself defines it
    bool all = false;                             // read with an index that is computed
    std::set<std::uint32_t> read;                 // elements, counted through; 0 of a scalar
    std::map<std::uint32_t, ExpressionId> given;  // elements with a value of their own
  };

  [[nodiscard]] bool is_global(const ir::Variable& v) const {
    return v.bank == ir::Bank::named && v.symbol != SymbolId::none && program_.at(v.symbol).is_global;
  }

  // The value of an element in a definition, as the reader gives it: next to the definition.
  [[nodiscard]] bool is_initial(const ir::Statement& s) const {
    if (s.kind != StatementKind::assign || (s.line != 0 && !defined_at_.contains(s.line))) return false;
    const ir::Assign& assign = program_.assigns[s.payload];
    return is_global(program_.at(assign.target)) && program_.at(assign.value).op == Operator::constant;
  }

  void collect() {
    for (const ir::Statement& s : program_.statements) {
      if (s.kind == StatementKind::define) define(s);
      if (is_initial(s) && (s.line == 0 || definitions_alone_)) initial(program_.assigns[s.payload]);
    }
  }

  void define(const ir::Statement& s) {
    const ir::Structure& list = program_.structures[s.payload];
    for (std::uint32_t i = 0; i < list.symbol_count; ++i) {
      const auto id = static_cast<SymbolId>(list.first_symbol + i);
      const ir::Symbol& symbol = program_.at(id);
      if (!symbol.is_global) continue;
      const auto [at, is_new] = by_name_.try_emplace(symbol.name, id);
      Global& global = known_[at->second];
      global.own |= s.line != 0;
      placed_.defined.insert(at->second);
      if (!is_new || !is_number(symbol)) continue;
      global.fits = place(id, elements_of(symbol));
      if (!global.fits) placed_.unplaced.insert(id);
    }
  }

  // The first gap that is large enough.
  bool place(SymbolId id, std::uint32_t count) {
    for (const ir::VariableRange& range : to_.variables) {
      if (range.bank != ir::Bank::hash || range.use != ir::VariableUse::permanent || !range.writable) continue;
      for (std::uint32_t first = range.first; first + count <= range.last + 1; ++first) {
        const auto taken = placed_.reserved.lower_bound(first);
        if (taken != placed_.reserved.end() && *taken < first + count) continue;
        placed_.numbers.emplace(id, first);
        for (std::uint32_t n = first; n < first + count; ++n) placed_.reserved.insert(n);
        return true;
      }
    }
    return false;
  }

  void initial(const ir::Assign& assign) {
    const ir::Variable& v = program_.at(assign.target);
    const auto id = by_name_.find(program_.at(v.symbol).name);
    const auto element = element_of(v);
    if (id != by_name_.end() && element) known_[id->second].given.try_emplace(*element, assign.value);
  }

  // Counted through row by row; nothing where an index is computed.
  [[nodiscard]] std::optional<std::uint32_t> element_of(const ir::Variable& v) const {
    const ir::Symbol& s = program_.at(v.symbol);
    std::uint32_t flat = 0;
    std::uint32_t rest = elements_of(s);
    const std::pair<ExpressionId, std::uint32_t> indices[] = {
        {v.index, s.dimension1}, {v.index2, s.dimension2}, {v.index3, s.dimension3}};
    for (const auto& [index, size] : indices) {
      rest /= at_least_one(size);
      if (index == ExpressionId::none) continue;
      const ir::Expression& e = program_.at(index);
      if (e.op != Operator::constant) return std::nullopt;
      flat += static_cast<std::uint32_t>(std::max(0.0, std::round(e.value))) * rest;
    }
    return flat;
  }

  void point_uses_to_definitions() {
    for (ir::Variable& v : program_.variables) {
      if (!is_global(v)) continue;
      const auto found = by_name_.find(program_.at(v.symbol).name);
      if (found != by_name_.end()) v.symbol = found->second;
    }
  }

  void note_uses() {
    for (const ir::Statement& s : program_.statements) {
      if (s.line == 0) continue;
      for (const passes::VariableUseAt& use : passes::variables_of(program_, s)) {
        const ir::Variable& v = program_.at(use.variable);
        const auto found = is_global(v) ? known_.find(v.symbol) : known_.end();
        if (found != known_.end()) note(found->second, v, s, use.set);
      }
    }
    const auto scalar = [this](const ir::Variable& v) -> std::optional<std::uint32_t> {
      if (!is_global(v) || v.index != ExpressionId::none) return std::nullopt;
      return static_cast<std::uint32_t>(v.symbol);
    };
    for (const passes::UnsetRead& read : passes::reads_before_set(program_, scalar)) {
      const auto found = known_.find(program_.at(read.variable).symbol);
      if (found != known_.end()) found->second.read.insert(0);
    }
  }

  void note(Global& global, const ir::Variable& v, const ir::Statement& s, bool set) {
    const ir::Symbol& symbol = program_.at(v.symbol);
    if (!is_number(symbol)) return;  // said where numbers are given out
    const std::uint32_t count = elements_of(symbol);
    const std::string name(program_.strings.at(symbol.name));
    if (!global.fits)
      return cannot(
          global, v, s,
          passes::kept_value(fmt::format("the global data {} ({} number{}), for which no permanent variables are left,",
                                         name, count, count == 1 ? "" : "s")));
    if (symbol.dimension1 == 0) return;
    if (v.index == ExpressionId::none)
      return cannot(global, v, s, passes::of_value("the array " + name + " as a whole"));
    const auto element = element_of(v);
    if (element && *element >= count)
      return cannot(global, v, s,
                    passes::of_value(fmt::format("an element of {} beyond its {} elements", name, count)));
    // The elements of an array are not followed one by one: a value that is set later is there already.
    if (set) return;
    if (element)
      global.read.insert(*element);
    else
      global.all = true;
  }

  void cannot(Global& global, const ir::Variable& v, const ir::Statement& s, passes::Refusal what) {
    if (std::exchange(global.is_reported, true)) return;
    placed_.diagnostics.push_back(passes::diagnose(std::move(what), v.span.empty() ? s.span : v.span, to_.title));
  }

  void write() {
    const bool procedure = std::ranges::any_of(
        program_.statements, [](const ir::Statement& s) { return s.kind == StatementKind::procedure; });
    bool written = false;
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      // A label at the first block is jumped to again, where nothing is vacant any more.
      if (!written && !procedure && s.line != 0) written = guards();
      const bool taken_out = is_definition(s) || (is_initial(s) && (s.line == 0 || definitions_alone_));
      if (!taken_out) out_.keep();
      if (!written && s.kind == StatementKind::procedure) written = guards();
    }
    out_.finish();
  }

  // Of global data alone; one that has others too is kept for them.
  [[nodiscard]] bool is_definition(const ir::Statement& s) const {
    if (s.kind != StatementKind::define) return false;
    const ir::Structure& list = program_.structures[s.payload];
    for (std::uint32_t i = 0; i < list.symbol_count; ++i)
      if (!program_.symbols[list.first_symbol + i].is_global) return false;
    return true;
  }

  bool guards() {
    for (auto& [id, global] : known_) {
      const std::uint32_t count = elements_of(program_.at(id));
      if (!global.fits) continue;
      const bool all = definitions_alone_ ? global.own : global.all;
      if (all && count > kMostGuards && has_one_value(id, global)) {
        guard_in_loop(id, count, value_of(id, global, 0));
        continue;
      }
      if (all)
        for (std::uint32_t k = 0; k < count; ++k) global.read.insert(k);
      for (const std::uint32_t k : global.read) {
        const bool scalar = program_.at(id).dimension1 == 0;
        guard(id, scalar ? ExpressionId::none : program_.add_constant(k),
              program_.add_constant(value_of(id, global, k)));
      }
    }
    return true;
  }

  // Of an element when no one has set it, as its type takes it.
  [[nodiscard]] double value_of(SymbolId id, const Global& global, std::uint32_t element) const {
    const ir::Symbol& symbol = program_.at(id);
    const auto own = global.given.find(element);
    const ExpressionId given = own == global.given.end() ? symbol.initial : own->second;
    const double value = given == ExpressionId::none ? 0.0 : program_.at(given).value;
    if (symbol.type == ir::ValueType::integer) return std::floor(value + 0.5);
    return symbol.type == ir::ValueType::boolean && value != 0.0 ? 1.0 : value;
  }
  [[nodiscard]] bool has_one_value(SymbolId id, const Global& global) const {
    for (std::uint32_t k = 1; k < elements_of(program_.at(id)); ++k)
      if (value_of(id, global, k) != value_of(id, global, 0)) return false;
    return true;
  }

  void guard(SymbolId id, ExpressionId index, ExpressionId value) {
    ir::Variable element;
    element.bank = ir::Bank::named;
    element.symbol = id;
    element.index = index;
    ir::Expression vacant;
    vacant.op = Operator::vacant;
    ir::Structure unset;
    unset.condition = program_.add_operator(Operator::equal, program_.add_variable(element), program_.add(vacant));
    out_.emit_structure(StatementKind::if_begin, unset);
    out_.emit_assign(program_.add(element), value);
    out_.emit_structure(StatementKind::if_end, {});
  }

  void guard_in_loop(SymbolId id, std::uint32_t count, double value) {
    if (counter_ == SymbolId::none) {
      ir::Symbol symbol;
      symbol.name = program_.strings.add("element");
      counter_ = program_.add(symbol);
    }
    ir::Variable counter;
    counter.bank = ir::Bank::named;
    counter.symbol = counter_;
    ir::Structure loop;
    loop.counter = program_.add(counter);
    loop.first = program_.add_constant(0.0);
    loop.last = program_.add_constant(count - 1.0);
    out_.emit_structure(StatementKind::for_begin, loop);
    guard(id, program_.add_variable(counter), program_.add_constant(value));
    out_.emit_structure(StatementKind::for_end, {});
  }

  ir::Program& program_;
  const ir::Control& to_;
  passes::Rewrite out_;
  PlacedGlobals placed_;
  bool definitions_alone_ = false;
  std::set<std::uint32_t> defined_at_;  // lines of the program's own definitions
  std::map<ir::StringId, SymbolId> by_name_;
  std::map<SymbolId, Global> known_;
  SymbolId counter_ = SymbolId::none;
};

}  // namespace

PlacedGlobals place_globals(ir::Program& program, const ir::Control& to) { return Placing(program, to).run(); }

}  // namespace dripfeed::macro_b
