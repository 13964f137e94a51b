// First every use is noted: which variables, where, and which numbers of the target bank the program has already. Then
// numbers are given, each variable its own as long as there are enough of them: a program is read by people, too. Only
// when there are too few, scalars that are never alive at the same time share one.
#include "dialects/passes/allocation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "dialects/passes/live_ranges.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

namespace {

using ir::Bank;
using ir::ExpressionId;
using ir::VariableUse;

// What is to get a number: a symbol, a number of another bank, or that bank as a whole.
struct Wanted {
  AllocatedVariable place;
  LiveRange live;
  bool given = false;
  bool refused = false;  // that it cannot be placed
};

// The ranges of the target that programs may use, in the order in which they are given away.
std::vector<ir::VariableRange> ranges_for_users(const ir::Control& to, Bank bank) {
  static constexpr std::array kOrder = {VariableUse::common, VariableUse::permanent, VariableUse::local};
  std::vector<ir::VariableRange> ranges;
  for (const VariableUse use : kOrder) {
    for (const ir::VariableRange& range : to.variables)
      if (range.bank == bank && range.use == use && range.writable) ranges.push_back(range);
  }
  return ranges;
}

class Allocator {
 public:
  Allocator(ir::Program& program, const ir::Control& from, const ir::Control& to, Bank bank,
            const AllocationRules& rules)
      : program_(program), from_(from), to_(to), bank_(bank), rules_(rules), live_(program) {}

  AllocationReport run() {
    define_to_assign();
    collect();
    if (whole_bank_) widen_to_bank();
    if (!place_all(false) && !place_all(true)) too_few();
    if (report_.diagnostics.empty()) rewrite();
    for (const auto& [key, wanted] : wanted_) report_.variables.push_back(wanted.place);
    return std::move(report_);
  }

 private:
  using Key = std::pair<Bank, std::uint32_t>;  // named: the symbol's index; hash, r: the number

  // DEF becomes the assignment of what it initialises with; variables of the target have no such statement.
  void define_to_assign() {
    const bool any = std::ranges::any_of(program_.statements,
                                         [](const ir::Statement& s) { return s.kind == ir::StatementKind::define; });
    if (!any) return;
    Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out.at(i);
      const ir::Statement& s = program_.statements[i];
      const bool kept = s.kind == ir::StatementKind::define &&
                        rules_.kept.contains(static_cast<ir::SymbolId>(program_.structures[s.payload].first_symbol));
      if (s.kind != ir::StatementKind::define || kept) {
        out.keep();
        continue;
      }
      const ir::Structure head = program_.structures[s.payload];
      for (std::uint32_t k = 0; k < head.symbol_count; ++k)
        initialise(static_cast<ir::SymbolId>(head.first_symbol + k), out);
    }
    out.finish();
    live_ = LiveRanges(program_);
  }

  void initialise(ir::SymbolId id, Rewrite& out) {
    const ir::Symbol symbol = program_.at(id);
    if (!is_number(symbol)) return;
    for (std::uint32_t k = 0; k < count_of(symbol); ++k) {
      ir::Variable element;
      element.bank = Bank::named;
      element.symbol = id;
      element.span = symbol.span;
      if (symbol.dimension1 != 0) element.index = program_.add_constant(k);
      out.emit_assign(program_.add(element), initial_value(symbol));
    }
  }

  // A constant as its type takes it.
  ExpressionId initial_value(const ir::Symbol& symbol) {
    if (symbol.initial == ExpressionId::none) return program_.add_constant(0.0);
    const ir::Expression& e = program_.at(symbol.initial);
    if (e.op != ir::Operator::constant) return symbol.initial;
    if (symbol.type == ir::ValueType::integer) return program_.add_constant(std::floor(e.value + 0.5), e.span);
    if (symbol.type == ir::ValueType::boolean) return program_.add_constant(e.value != 0.0 ? 1.0 : 0.0, e.span);
    return symbol.initial;
  }

  static bool is_number(const ir::Symbol& symbol) {
    return symbol.type == ir::ValueType::integer || symbol.type == ir::ValueType::real ||
           symbol.type == ir::ValueType::boolean;
  }
  static std::uint32_t count_of(const ir::Symbol& symbol) {
    const std::uint32_t rows = std::max<std::uint32_t>(1, symbol.dimension1);
    return rows * std::max<std::uint32_t>(1, symbol.dimension2) * std::max<std::uint32_t>(1, symbol.dimension3);
  }

  void collect() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      for (const VariableUseAt& use : variables_of(program_, program_.statements[i])) note(use, i);
    }
  }

  void note(const VariableUseAt& use, std::uint32_t statement) {
    const ir::Variable& v = program_.at(use.variable);
    used_.insert(static_cast<std::uint32_t>(use.variable));
    if (v.bank == Bank::system || is_kept(v)) return;
    if (v.bank == bank_) {
      if (v.index == ExpressionId::none) {
        taken_.insert(v.number);
      } else {
        pinned_ = true;  // it may be any of them
      }
      return;
    }
    if (v.bank != Bank::named && v.index != ExpressionId::none) {
      if (rules_.shares && !whole_bank_) refuse_whole_bank(v);
      whole_bank_ = true;
      whole_from_ = v.bank;
      return;
    }
    const bool named = v.bank == Bank::named;
    Wanted& wanted = wanted_[{v.bank, named ? static_cast<std::uint32_t>(v.symbol) : v.number}];
    if (wanted.live.empty()) {
      wanted.place.from_bank = v.bank;
      wanted.place.symbol = v.symbol;
      wanted.place.from_number = v.number;
      if (named) take_symbol(wanted, v.symbol, v.span);
    }
    if (named && v.index != ExpressionId::none) check_array(wanted, v);
    live_.extend(wanted.live, statement);
  }

  [[nodiscard]] bool is_kept(const ir::Variable& v) const {
    return v.bank == Bank::named && rules_.kept.contains(v.symbol);
  }

  // A called program and its caller may need other places for theirs.
  void refuse_whole_bank(const ir::Variable& v) {
    report_.diagnostics.push_back(
        passes::diagnose(passes::computed("a variable of computed number, which called programs and callers share,"),
                         v.span, to_.title));
  }

  // Two arrays whose sizes no one knows would lie in each other.
  void check_array(Wanted& wanted, const ir::Variable& v) {
    const ir::Symbol& symbol = program_.at(v.symbol);
    if (symbol.dimension1 != 0 || wanted.refused) return;
    wanted.refused = true;
    report_.diagnostics.push_back(
        passes::diagnose(passes::not_known("the array " + std::string(program_.strings.at(symbol.name)) +
                                           ", whose size the program does not state,"),
                         v.span, to_.title));
  }

  void take_symbol(Wanted& wanted, ir::SymbolId id, text::Span used) {
    const ir::Symbol& symbol = program_.at(id);
    wanted.place.count = count_of(symbol);
    if (is_number(symbol)) return;
    report_.diagnostics.push_back(passes::diagnose(
        passes::of_value("the variable " + std::string(program_.strings.at(symbol.name)) + ", which is not a number,"),
        symbol.span.empty() ? used : symbol.span, to_.title));
  }

  // R[R1] may be any R: all of them move together.
  void widen_to_bank() {
    std::uint32_t highest = 0;
    for (const auto& [key, wanted] : wanted_) {
      if (key.first == whole_from_) highest = std::max(highest, key.second);
    }
    for (const ir::VariableRange& range : from_.variables) {
      if (range.bank == whole_from_ && range.use != VariableUse::system) highest = std::max(highest, range.last);
    }
    std::erase_if(wanted_, [&](const auto& row) { return row.first.first == whole_from_; });
    Wanted& all = wanted_[{whole_from_, 0}];
    all.place = {whole_from_, ir::SymbolId::none, 0, 0, highest + 1};
    all.live = LiveRange::always();
  }

  [[nodiscard]] std::vector<ir::VariableRange> user_ranges() const { return ranges_for_users(to_, bank_); }

  bool place_all(bool share) {
    given_.clear();
    if (pinned_ && !wanted_.empty()) return false;
    // Arrays first: they need their numbers in a row. Then those that can keep their own number, or one like it: R1 is
    // #101.
    for (auto& [key, wanted] : wanted_) {
      wanted.given = false;
      const auto fixed = rules_.fixed.find(wanted.place.symbol);
      if (key.first == Bank::named && fixed != rules_.fixed.end()) give(wanted, fixed->second);
    }
    for (auto& [key, wanted] : wanted_) {
      if (!wanted.given && wanted.place.count > 1 && !place(wanted, false)) return false;
    }
    for (auto& [key, wanted] : wanted_) {
      if (wanted.given || key.first == Bank::named) continue;
      if (rules_.shares) {
        const std::uint32_t number = shared_number(to_, bank_, key.second, rules_.reserved);
        if (!is_shared_by_calls(number) || !is_free(number, 1, wanted.live, false)) return false;
        give(wanted, number);
        continue;
      }
      for (const std::uint32_t number : {key.second, first_common() + key.second}) {
        if (!wanted.given && is_shared_by_calls(number) && is_free(number, 1, wanted.live, false)) give(wanted, number);
      }
    }
    return std::ranges::all_of(wanted_, [&](auto& row) { return row.second.given || place(row.second, share); });
  }

  bool place(Wanted& wanted, bool share) {
    for (const ir::VariableRange& range : user_ranges()) {
      if (rules_.shares && range.use != VariableUse::local) continue;
      const std::uint32_t count = wanted.place.count;
      for (std::uint32_t n = range.first; n + count <= range.last + 1; ++n) {
        if (!is_free(n, count, wanted.live, share)) continue;
        give(wanted, n);
        return true;
      }
    }
    return false;
  }

  // A number that means the same in called programs, as those of other banks do.
  [[nodiscard]] bool is_shared_by_calls(std::uint32_t number) const {
    return std::ranges::any_of(user_ranges(), [&](const ir::VariableRange& r) {
      return r.use != VariableUse::local && r.first <= number && number <= r.last;
    });
  }
  [[nodiscard]] std::uint32_t first_common() const {
    const std::vector<ir::VariableRange> ranges = user_ranges();
    return ranges.empty() ? 0 : ranges.front().first;
  }

  [[nodiscard]] bool is_free(std::uint32_t first, std::uint32_t count, const LiveRange& live, bool share) const {
    for (std::uint32_t n = first; n < first + count; ++n) {
      if (taken_.contains(n) || rules_.reserved.contains(n)) return false;
      const auto owners = given_.find(n);
      if (owners == given_.end()) continue;
      if (!share || std::ranges::any_of(owners->second, [&](const LiveRange& r) { return r.meets(live); }))
        return false;
    }
    return true;
  }

  void give(Wanted& wanted, std::uint32_t first) {
    wanted.place.number = first;
    wanted.given = true;
    for (std::uint32_t n = first; n < first + wanted.place.count; ++n) given_[n].push_back(wanted.live);
  }

  void too_few() {
    // Where programs call each other, names have local variables only.
    std::size_t needed = 0;
    for (const auto& [key, wanted] : wanted_)
      needed += wanted.given && rules_.fixed.contains(wanted.place.symbol) ? 0
                : rules_.shares && key.first != Bank::named                ? 0
                                                                           : wanted.place.count;
    std::size_t free = 0;
    for (const ir::VariableRange& range : user_ranges()) {
      if (rules_.shares && range.use != VariableUse::local) continue;
      for (std::uint32_t n = range.first; n <= range.last; ++n)
        free += pinned_ || taken_.contains(n) || rules_.reserved.contains(n) ? 0U : 1U;
    }
    report_.diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::not_enough_variables, {},
                                                        {std::to_string(needed), std::to_string(free)}));
  }

  void rewrite() {
    for (const std::uint32_t index : used_) {
      ir::Variable v = program_.variables[index];
      if (v.bank == bank_ || v.bank == Bank::system || is_kept(v)) continue;
      const bool whole = whole_bank_ && v.bank == whole_from_;
      const std::uint32_t key = v.bank == Bank::named ? static_cast<std::uint32_t>(v.symbol) : v.number;
      const AllocatedVariable& place = wanted_.at({v.bank, whole ? 0 : key}).place;
      std::uint32_t number = place.number + (whole ? v.number : 0);
      if (v.bank == Bank::named) v.index = flat_index(v);
      v.index2 = v.index3 = ExpressionId::none;
      if (v.index != ExpressionId::none) {
        const ir::Expression e = program_.at(v.index);
        if (e.op == ir::Operator::constant) {
          number = place.number + static_cast<std::uint32_t>(std::max(0.0, e.value));
          v.index = ExpressionId::none;
        } else {
          v.index = moved_by(v.index, place.number);
        }
      }
      v.bank = bank_;
      v.number = v.index == ExpressionId::none ? number : 0;
      v.symbol = ir::SymbolId::none;
      program_.variables[index] = v;
    }
  }

  // index + number, with a constant that the index ends in taken into it: #[#1+4-1+100] is #[#1+103].
  ExpressionId moved_by(ExpressionId index, double number) {
    const ir::Expression e = program_.at(index);
    const bool is_sum = e.op == ir::Operator::add || e.op == ir::Operator::subtract;
    if (is_sum && program_.at(e.b).op == ir::Operator::constant && is_whole(program_.at(e.b).value)) {
      const double last = program_.at(e.b).value;
      return moved_by(e.a, e.op == ir::Operator::add ? number + last : number - last);
    }
    if (number == 0.0) return index;
    const bool adds = number > 0.0;
    return program_.add_operator(adds ? ir::Operator::add : ir::Operator::subtract, index,
                                 program_.add_constant(std::abs(number), {}, false));
  }
  static bool is_whole(double value) { return std::trunc(value) == value; }

  // A[i, k] as one index: i * columns + k; with a third one, layers in it alike.
  ExpressionId flat_index(const ir::Variable& v) {
    const ir::Symbol symbol = program_.at(v.symbol);
    return within_row(within_row(v.index, symbol.dimension2, v.index2), symbol.dimension3, v.index3);
  }
  ExpressionId within_row(ExpressionId row, std::uint32_t size, ExpressionId column) {
    if (column == ExpressionId::none) return row;
    const ir::Expression a = program_.at(row);
    const ir::Expression b = program_.at(column);
    if (a.op == ir::Operator::constant && b.op == ir::Operator::constant)
      return program_.add_constant(a.value * size + b.value);
    const ExpressionId begin = program_.add_operator(ir::Operator::multiply, row, program_.add_constant(size));
    return program_.add_operator(ir::Operator::add, begin, column);
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  Bank bank_;
  const AllocationRules& rules_;
  LiveRanges live_;
  AllocationReport report_;
  std::map<Key, Wanted> wanted_;
  std::set<std::uint32_t> used_;   // indices into Program::variables
  std::set<std::uint32_t> taken_;  // numbers of the target bank that the program has already
  std::map<std::uint32_t, std::vector<LiveRange>> given_;
  bool pinned_ = false;
  bool whole_bank_ = false;
  Bank whole_from_ = Bank::r;
};

}  // namespace

std::uint32_t shared_number(const ir::Control& to, Bank bank, std::uint32_t number,
                            const std::set<std::uint32_t>& reserved) {
  for (const ir::VariableRange& range : ranges_for_users(to, bank)) {
    if (range.use == VariableUse::local) continue;
    for (std::uint32_t n = range.first; n <= range.last; ++n) {
      if (reserved.contains(n)) continue;
      if (number == 0) return n;
      --number;
    }
  }
  return 0;
}

AllocationReport allocate_variables(ir::Program& program, const ir::Control& from, const ir::Control& to, Bank bank,
                                    const AllocationRules& rules) {
  return Allocator(program, from, to, bank, rules).run();
}

std::vector<ir::PlacedName> placed_names(const AllocationReport& report, ir::Bank bank) {
  std::vector<ir::PlacedName> out;
  for (const AllocatedVariable& v : report.variables)
    if (v.symbol != ir::SymbolId::none) out.push_back({v.symbol, bank, v.number, v.count});
  return out;
}

}  // namespace dripfeed::passes
