// What an address counts depends on the codes in its block and, of modal ones, before it in its part.
#include "dialects/compile/translate/iso_increments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/facts/resolved.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

using facts::Mode;
using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

constexpr double kFeedsPerUnit = 100.0;  // F20 is 0.2 mm per revolution, and a hundredth of that in inch
// Letters of a macro call that are lengths.
constexpr std::string_view kLengthLetters = "ABCIJKQRUVWXYZ";

// What a number without a point is.
enum class Counts : std::uint8_t { nothing, length, angle, feed, unknown };

class Increments {
 public:
  Increments(ir::Program& program, const ir::Control& from, const ir::Control& iso, const ir::Control& to)
      : program_(program),
        to_(to),
        flow_(program, from),
        per_mm_(std::nearbyint(1.0 / iso.semantics.least_increment_mm)),
        deg_(iso.semantics.least_increment_deg) {}

  std::vector<text::Diagnostic> run() {
    for (index_ = 0; index_ < program_.statements.size(); ++index_) {
      const ir::Statement& s = program_.statements[index_];
      if (s.kind == StatementKind::block) block(program_.blocks[s.payload]);
      if (!ir::is_foreign(program_, index_)) continue;
      if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) call(program_.calls[s.payload]);
    }
    return std::move(diagnostics_);
  }

 private:
  void block(const ir::Block& block) {
    for (const ir::Code& c : program_.codes_of(block)) {
      if (c.group != ModalGroup::motion && c.group != ModalGroup::cycle && c.function != Function::cycle_off) continue;
      drills_ = c.function == Function::drill;
      threads_ = c.function == Function::thread_changing;
    }
    if (!ir::is_foreign(program_, index_)) return;
    for (std::uint32_t i = block.first_word; i < block.first_word + block.word_count; ++i) {
      const ir::Word w = program_.words[i];
      if (w.value != ExpressionId::none && lacks_point(w.value))
        program_.words[i].value = translated(w.value, counts(block, w.address), w.span);
    }
  }

  void call(const ir::Call& call) {
    for (std::uint32_t i = call.first_argument; i < call.first_argument + call.argument_count; ++i) {
      const ir::Argument argument = program_.arguments[i];
      if (argument.value == ExpressionId::none || !lacks_point(argument.value)) continue;
      const Counts kind = kLengthLetters.contains(argument.letter) ? Counts::length : Counts::nothing;
      program_.arguments[i].value = translated(argument.value, kind, program_.statements[index_].span);
    }
  }

  [[nodiscard]] bool has(const ir::Block& block, Function function) const {
    return std::ranges::any_of(program_.codes_of(block), [&](const ir::Code& c) { return c.function == function; });
  }

  [[nodiscard]] Counts counts(const ir::Block& block, Address a) const {
    const bool center = a >= Address::i && a <= Address::k;
    const bool radius = a == Address::r || a == Address::arc_radius;
    if (has(block, Function::dwell) || a == Address::p) return Counts::nothing;
    if (ir::is_axis(a)) return ir::is_rotary_axis(a) ? Counts::angle : Counts::length;
    if (a == Address::f) return Counts::feed;
    if (has(block, Function::rotate)) return radius ? Counts::angle : Counts::nothing;
    if (has(block, Function::scale)) return Counts::nothing;  // a factor: what it counts is settled elsewhere
    const bool own = has(block, Function::repetitive_cycle) || has(block, Function::data_input) ||
                     has(block, Function::hole_pattern) || has(block, Function::nurbs);
    if (own && a == Address::q) return Counts::nothing;
    if (own || threads_) return center || radius || a == Address::d ? Counts::unknown : Counts::nothing;
    if (drills_ && a == Address::k) return Counts::nothing;  // holes
    if (a == Address::q) return drills_ ? Counts::length : Counts::nothing;
    return center || radius || a == Address::chamfer || a == Address::rounding ? Counts::length : Counts::nothing;
  }

  // The value with its point.
  ExpressionId translated(ExpressionId id, Counts kind, text::Span span) {
    const double value = number(id);
    if (kind == Counts::nothing) return id;
    if (kind == Counts::angle) return constant(value * deg_, id);
    if (kind == Counts::unknown) {
      diagnostics_.push_back(passes::diagnose(
          passes::by_parameter("a number without a point, which counts increments in ISO mode,"), span, to_.title));
      return id;
    }
    const std::optional<Function> unit = mode(Mode::unit, "the unit of lengths", span);
    if (!unit) return id;
    const bool inch = *unit == Function::unit_inch;
    if (kind == Counts::length) return constant(value / (inch ? per_mm_ * 10.0 : per_mm_), id);
    const std::optional<Function> feed = mode(Mode::feed, "the feed mode", span);
    if (!feed || *feed == Function::feed_inverse_time) return id;
    const double per_unit = (*feed == Function::feed_per_rev ? kFeedsPerUnit : 1.0) * (inch ? kFeedsPerUnit : 1.0);
    return constant(value / per_unit, id);
  }

  // The block's own, or what holds before it on all paths; nothing, and reported, where they differ.
  std::optional<Function> mode(Mode wanted, std::string name, text::Span span) {
    const ir::Statement& s = program_.statements[index_];
    if (s.kind == StatementKind::block)
      for (const ir::Code& c : program_.codes_of(program_.blocks[s.payload]))
        if (facts::mode_of(c) == wanted) return c.function;
    const facts::Facts* facts = flow_.before(index_);
    if (facts == nullptr) return std::nullopt;
    const facts::Known<facts::Setting>& fact = (*facts)[wanted];
    if (fact.is_certain()) return fact.value.function;
    diagnostics_.push_back(
        text::make_diagnostic(text::DiagnosticId::unknown_modal_state, span,
                              {std::move(name), fmt::format("{}", fmt::join(flow_.paths(fact), ", or "))}));
    return std::nullopt;
  }

  [[nodiscard]] const ir::Expression& literal(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    return e.op == ir::Operator::negate ? program_.at(e.a) : e;
  }
  [[nodiscard]] bool lacks_point(ExpressionId id) const {
    const ir::Expression& e = literal(id);
    return e.op == ir::Operator::constant && !e.has_point && e.value != 0.0;
  }
  [[nodiscard]] double number(ExpressionId id) const {
    return program_.at(id).op == ir::Operator::negate ? -literal(id).value : literal(id).value;
  }
  ExpressionId constant(double value, ExpressionId written) {
    return program_.add_constant(value, program_.at(written).span);
  }

  ir::Program& program_;
  const ir::Control& to_;
  facts::Resolved flow_;
  double per_mm_;
  double deg_;
  std::vector<text::Diagnostic> diagnostics_;
  std::uint32_t index_ = 0;
  bool drills_ = false;   // a drilling cycle is in effect
  bool threads_ = false;  // a thread whose lead changes
};

}  // namespace

std::vector<text::Diagnostic> translate_iso_increments(ir::Program& program, const ir::Control& from,
                                                       const ir::Control& iso, const ir::Control& to) {
  if (iso.semantics.decimal_mode != ir::DecimalMode::least_increment) return {};
  return Increments(program, from, iso, to).run();
}

}  // namespace dripfeed::compile
