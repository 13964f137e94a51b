// Goes round over the program until nothing new is learned; a variable whose uses disagree says nothing further.
#include "dialects/compile/native/variable_quantities.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dialects/compile/native/native_variable.h"
#include "dialects/facts/calls.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr VariableQuantity kAngle{family::kAngle};
constexpr VariableQuantity kCount{family::kRatio, true};

// Words of these mean something else: offsets that are written into the control, angles, other programs' data.
bool has_words_of_its_own(const ir::Program& program, const ir::Block& block) {
  constexpr Function kOwn[] = {Function::data_input, Function::rotate,           Function::scale,
                               Function::mirror,     Function::machine_function, Function::not_modelled};
  return std::ranges::any_of(program.codes_of(block), [&](const ir::Code& code) {
    return std::ranges::find(kOwn, code.function) != std::end(kOwn) && code.letter == 'G';
  });
}

bool has_dwell(const ir::Program& program, const ir::Block& block) {
  const auto codes = program.codes_of(block);
  return std::ranges::find(codes, Function::dwell, &ir::Code::function) != codes.end();
}

bool is_arc(const ir::Program& program, const ir::Block& block) {
  return std::ranges::any_of(program.codes_of(block), [](const ir::Code& code) {
    return code.function == Function::arc_cw || code.function == Function::arc_ccw;
  });
}

bool is_comparison(Operator op) { return op >= Operator::equal && op <= Operator::greater_equal; }

}  // namespace

VariableQuantities::VariableQuantities(const ir::Program& program, const ir::Control& control,
                                       const facts::Resolved& resolved)
    : program_(program), control_(control), resolved_(resolved) {
  learn();
  // What nothing else reports may be a counter; where one is a factor, the other factor measures what the product
  // does.
  counters();
  learn();
}

void VariableQuantities::learn() {
  for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::block && s.payload != ir::kNoIndex) block(i);
  }
  constexpr int kRounds = 6;  // chains of more assignments are rare, and what is not learned is only not said
  changed_ = true;
  for (int round = 0; round < kRounds && changed_; ++round) {
    changed_ = false;
    for (const ir::Statement& s : program_.statements)
      if (s.payload != ir::kNoIndex) expressions(s);
  }
}

std::optional<VariableQuantities::Key> VariableQuantities::key_of(const ir::Variable& v) {
  if (v.bank == ir::Bank::system || v.index != ir::ExpressionId::none) return std::nullopt;
  return Key(v.bank, v.bank == ir::Bank::named ? static_cast<std::uint32_t>(v.symbol) : v.number);
}

std::optional<VariableQuantity> VariableQuantities::of(const ir::Variable& variable) const {
  const std::optional<Key> key = key_of(variable);
  const auto found = key ? known_.find(*key) : known_.end();
  if (found == known_.end() || found->second.is_contradicted) return std::nullopt;
  return found->second.quantity;
}

std::optional<VariableQuantity> VariableQuantities::of(ir::SymbolId symbol) const {
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.symbol = symbol;
  return of(variable);
}

void VariableQuantities::note(const Key& key, VariableQuantity quantity) {
  if (using_ != nullptr) {
    std::vector<WordUse>& uses = uses_[key];
    if (std::ranges::find(uses, *using_) == uses.end()) uses.push_back(*using_);
    if (!using_->mode_known) return;
  }
  if (passing_to_ != nullptr) passed_on_[key].insert(*passing_to_);
  const auto [known, is_new] = known_.try_emplace(key, Known{quantity});
  if (is_new) {
    changed_ = true;
  } else if (known->second.quantity != quantity && !known->second.is_contradicted) {
    known->second.is_contradicted = true;
    changed_ = true;
  }
}

std::vector<WordUse> VariableQuantities::uses_of(const std::vector<ir::Variable>& variables,
                                                 const std::vector<bool>& scope) const {
  std::vector<Key> keys;
  const auto add = [&keys](const Key& key) {
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  };
  for (const ir::Variable& one : variables)
    if (const std::optional<Key> key = key_of(one)) add(*key);
  std::vector<WordUse> out;
  for (std::size_t done = 0; done < keys.size(); ++done) {
    const Key key = keys[done];
    if (const auto uses = uses_.find(key); uses != uses_.end())
      std::ranges::copy_if(uses->second, std::back_inserter(out),
                           [&](const WordUse& one) { return scope[one.statement]; });
    if (const auto to = passed_on_.find(key); to != passed_on_.end()) std::ranges::for_each(to->second, add);
  }
  std::ranges::sort(out, {}, &WordUse::statement);
  return out;
}

// --- words

void VariableQuantities::block(std::uint32_t statement) {
  const ir::Block& block = program_.blocks[program_.statements[statement].payload];
  if (has_dwell(program_, block)) return dwell(block);
  if (has_words_of_its_own(program_, block)) return;
  for (const ir::Word& one : program_.words_of(block)) {
    if (one.value == ir::ExpressionId::none || program_.at(one.value).op == Operator::constant) continue;
    const bool radius = one.address == Address::arc_radius ||
                        (one.address == Address::r && control_.semantics.arc_radius_is_r && is_arc(program_, block));
    if (radius)
      use({.statement = statement, .dimension = family::kLength}, one.value);
    else
      word(one, statement);
  }
}

// P in milliseconds, X and U in seconds; or F in seconds, and S counts turns of the spindle.
void VariableQuantities::dwell(const ir::Block& block) {
  const bool p_is_ms = control_.semantics.dwell_p_is_ms;
  for (const ir::Word& one : program_.words_of(block)) {
    if (one.value == ir::ExpressionId::none) continue;
    const Address a = one.address;
    if (p_is_ms && a == Address::p) take(one.value, {.dimension = family::kTime, .is_ms = true});
    if (p_is_ms ? a == Address::x || a == Address::u : a == Address::f) take(one.value, {family::kTime});
  }
}

void VariableQuantities::word(const ir::Word& word, std::uint32_t statement) {
  const Address a = word.address;
  const char letter = a <= Address::z ? static_cast<char>('A' + static_cast<int>(a)) : '\0';
  if (ir::is_linear_axis(a) || (a >= Address::i && a <= Address::k))
    return use({.statement = statement, .dimension = family::kLength}, word.value);
  if (ir::is_rotary_axis(a) && control_.axes.contains(letter)) return take(word.value, kAngle);
  if (a == Address::t || a == Address::d || a == Address::h) return take(word.value, kCount);
  if (a != Address::f && a != Address::s) return;
  const std::optional<facts::Facts> facts = resolved_.at(statement);
  if (!facts) return;
  using facts::Mode;
  if (a == Address::f) {
    const facts::Setting* mode = (*facts)[Mode::feed].certain();
    if (mode != nullptr && mode->function == Function::feed_inverse_time) return;
    const bool per_rev = mode != nullptr && mode->function == Function::feed_per_rev;
    return use({.statement = statement,
                .dimension = per_rev ? family::kFeedPerRev : family::kFeedPerMin,
                .mode_known = mode != nullptr},
               word.value);
  }
  if (const facts::Setting* mode = (*facts)[Mode::surface_speed].certain())
    use({.statement = statement,
         .dimension = mode->function == Function::surface_speed_off ? family::kSpeed : family::kSurfaceSpeed},
        word.value);
}

void VariableQuantities::use(const WordUse& use, ir::ExpressionId value) {
  using_ = &use;
  take(value, {use.dimension});
  using_ = nullptr;
}

// --- expressions

void VariableQuantities::expressions(const ir::Statement& s) {
  if (s.kind == StatementKind::assign) assignment(program_.assigns[s.payload]);
  if (facts::is_call(s.kind)) call(program_.calls[s.payload]);
  passes::for_each_root(
      program_, s,
      [this](ir::ExpressionId root) {
        passes::for_each_node(program_, root, [this](ir::ExpressionId id) { node(id); });
      },
      [](ir::VariableId) {});
}

void VariableQuantities::node(ir::ExpressionId id) {
  const ir::Expression& e = program_.at(id);
  if (e.op == Operator::sin || e.op == Operator::cos || e.op == Operator::tan) return take(e.a, kAngle);
  if (e.op == Operator::variable && program_.at(e.variable).index != ir::ExpressionId::none)
    return take(program_.at(e.variable).index, kCount);
  if (!is_comparison(e.op)) return;
  if (const auto known = quantity_of(e.a)) take(e.b, *known);
  if (const auto known = quantity_of(e.b)) take(e.a, *known);
}

void VariableQuantities::assignment(const ir::Assign& assign) {
  const std::optional<Key> key = key_of(program_.at(assign.target));
  if (const auto known = of(program_.at(assign.target)); known && key) pass_on(assign.value, *known, *key);
  if (const auto known = quantity_of(assign.value); known && key) note(*key, *known);
}

// The parameters of a program of the text.
void VariableQuantities::call(const ir::Call& call) {
  const ir::Structure* head = procedure_named(program_, call.name);
  for (std::uint32_t i = 0; head != nullptr && i < std::min(call.argument_count, head->symbol_count); ++i) {
    const ir::ExpressionId value = program_.arguments[call.first_argument + i].value;
    const std::uint32_t parameter = head->first_symbol + i;
    if (const auto known = of(static_cast<ir::SymbolId>(parameter)); known && value != ir::ExpressionId::none)
      pass_on(value, *known, Key(ir::Bank::named, parameter));
  }
}

void VariableQuantities::pass_on(ir::ExpressionId id, VariableQuantity quantity, const Key& to) {
  passing_to_ = &to;
  take(id, quantity);
  passing_to_ = nullptr;
}

// What the expression measures goes to the variables in it that measure the same.
void VariableQuantities::take(ir::ExpressionId id, VariableQuantity quantity) {
  const ir::Expression& e = program_.at(id);
  switch (e.op) {
    case Operator::variable:
      if (const auto key = key_of(program_.at(e.variable))) note(*key, quantity);
      return;
    case Operator::negate:
    case Operator::abs:
    case Operator::round:
    case Operator::truncate:
    case Operator::round_up: return take(e.a, quantity);
    case Operator::add:
    case Operator::subtract:
    case Operator::minimum:
    case Operator::maximum: take(e.a, quantity); return take(e.b, quantity);
    case Operator::multiply:
      quantity.is_count = false;
      if (is_ratio(e.a)) return take(e.b, quantity);
      if (is_ratio(e.b)) return take(e.a, quantity);
      return;
    case Operator::divide:
      if (is_ratio(e.b)) take(e.a, {quantity.dimension});
      return;
    default: return;
  }
}

std::optional<VariableQuantity> VariableQuantities::quantity_of(ir::ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  switch (e.op) {
    case Operator::variable: return of(program_.at(e.variable));
    case Operator::asin:
    case Operator::acos:
    case Operator::atan:
    case Operator::atan2: return kAngle;
    case Operator::negate:
    case Operator::abs: return quantity_of(e.a);
    case Operator::add:
    case Operator::subtract: {
      const auto a = quantity_of(e.a);
      const auto b = quantity_of(e.b);
      return a && b && *a != *b ? std::nullopt : a ? a : b;
    }
    default: return std::nullopt;
  }
}

// A factor that has no unit of its own. Other constants (25.4, 60, 1000) change units.
bool VariableQuantities::is_ratio(ir::ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  constexpr double kLargest = 4.0;  // half, double, the sides of a square
  switch (e.op) {
    case Operator::constant: return e.value == 0.5 || (std::trunc(e.value) == e.value && std::abs(e.value) <= kLargest);
    case Operator::sin:
    case Operator::cos:
    case Operator::tan: return true;
    case Operator::negate: return is_ratio(e.a);
    case Operator::variable: {
      const auto known = of(program_.at(e.variable));
      return known && known->is_count;
    }
    case Operator::multiply: return is_ratio(e.a) && is_ratio(e.b);
    default: return false;
  }
}

// --- counters

// The variable that `#3=#3+1` counts, when the expression is such a sum.
std::optional<VariableQuantities::Key> VariableQuantities::counter_in(ir::ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  if (e.op != Operator::add && e.op != Operator::subtract) return std::nullopt;
  if (program_.at(e.a).op != Operator::variable || program_.at(e.b).op != Operator::constant) return std::nullopt;
  if (program_.at(e.b).value != 1.0 || program_.at(e.b).has_point) return std::nullopt;
  return key_of(program_.at(program_.at(e.a).variable));
}

void VariableQuantities::counters() {
  for (const ir::Statement& s : program_.statements) {
    if (s.kind == StatementKind::for_begin && s.payload != ir::kNoIndex) {
      const ir::Structure& loop = program_.structures[s.payload];
      for (const ir::ExpressionId bound : {loop.first, loop.last})
        if (bound != ir::ExpressionId::none) take(bound, kCount);
    }
    if (s.kind != StatementKind::assign) continue;
    const ir::Assign& assign = program_.assigns[s.payload];
    const auto counted = counter_in(assign.value);
    const auto target = key_of(program_.at(assign.target));
    if (counted && target == counted && !known_.contains(*counted)) note(*counted, kCount);
  }
  // What a counter is compared with.
  for (const ir::Statement& s : program_.statements) {
    if (s.payload == ir::kNoIndex) continue;
    passes::for_each_root(
        program_, s,
        [this](ir::ExpressionId root) {
          passes::for_each_node(program_, root, [this](ir::ExpressionId id) {
            const ir::Expression& e = program_.at(id);
            if (is_comparison(e.op)) counted_by(e.a, e.b), counted_by(e.b, e.a);
          });
        },
        [](ir::VariableId) {});
  }
}

void VariableQuantities::counted_by(ir::ExpressionId one, ir::ExpressionId other) {
  const auto known = quantity_of(one);
  if (known && known->is_count && !quantity_of(other)) take(other, kCount);
}

}  // namespace dripfeed::compile
