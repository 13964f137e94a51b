// Which block needs which mode is a short list of rules; dialects/facts knows what is in effect there.
#include "dialects/passes/explicit_modes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/facts/resolved.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::passes {

namespace {

using facts::Facts;
using facts::index_of;
using facts::Known;
using facts::Mode;
using facts::Setting;
using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

struct ModeRow {
  Mode mode;
  ModalGroup group;
  std::string_view name;
};
constexpr std::array kRows = {
    ModeRow{Mode::feed, ModalGroup::feed, "the feed mode"},
    ModeRow{Mode::surface_speed, ModalGroup::surface_speed, "constant surface speed"},
    ModeRow{Mode::unit, ModalGroup::unit, "the unit of lengths"},
    ModeRow{Mode::distance, ModalGroup::distance, "absolute or incremental"},
    ModeRow{Mode::plane, ModalGroup::plane, "the plane"},
    ModeRow{Mode::diameter, ModalGroup::diameter, "diameter or radius"},
};
constexpr std::size_t kModes = kRows.size();  // the first ones of Mode
constexpr bool rows_in_order() {
  for (std::size_t i = 0; i < kModes; ++i)
    if (index_of(kRows[i].mode) != i) return false;
  return true;
}
static_assert(rows_in_order());
using Needs = std::array<bool, kModes>;

// One of these that the code sets.
std::optional<Mode> mode_of(const ir::Code& code) {
  const std::optional<Mode> mode = facts::mode_of(code);
  return mode && index_of(*mode) < kModes ? mode : std::nullopt;
}
const ModeRow& row_of(std::size_t mode) { return kRows[mode]; }

bool is_length(Address a) {
  return ir::is_linear_axis(a) || a == Address::i || a == Address::j || a == Address::k || a == Address::r;
}

bool is_counted_feed(const ir::Program& program, const ir::Word& w) {
  if (w.address != Address::f || w.value == ir::ExpressionId::none) return false;
  const ir::Expression& e = program.at(w.value);
  return e.op == ir::Operator::constant && !e.has_point && e.value != 0.0;
}

// F20 without a point is 0.2 mm per revolution and 20 mm per minute on a control that counts increments.
constexpr double kFeedsPerUnit = 100.0;
bool reads_feeds_otherwise(const ir::Control& from, const ir::Control& to) {
  return from.semantics.decimal_mode == ir::DecimalMode::least_increment &&
         to.semantics.decimal_mode != ir::DecimalMode::least_increment;
}
bool has_counted_feed(const ir::Program& program) {
  return std::ranges::any_of(program.words, [&](const ir::Word& w) { return is_counted_feed(program, w); });
}

// What a block holds, as far as the rules ask.
struct Traits {
  bool feed_code = false;
  bool speed_code = false;
  bool drills = false;  // a cycle of mills
  bool dwells = false;
  bool bends = false;  // an arc or a compensation
  bool axis_word = false;
  bool modal_axis_word = false;
  bool explicit_word = false;  // says by itself whether it is an increment
  bool x_word = false;
  bool counted_length = false;  // in increments of the control, without a point
  bool counted_feed = false;
};

Traits traits_of(const ir::Program& program, const ir::Block& block) {
  Traits t;
  for (const ir::Code& c : program.codes_of(block)) {
    t.feed_code |= c.function == Function::feed_per_min || c.function == Function::feed_per_rev;
    t.speed_code |= mode_of(c) == Mode::surface_speed;
    t.drills |= c.function == Function::drill && c.argument < ir::kDrillAlongZ;
    t.dwells |= c.function == Function::dwell;
    t.bends |= c.function == Function::arc_cw || c.function == Function::arc_ccw || c.function == Function::comp_left ||
               c.function == Function::comp_right;
  }
  for (const ir::Word& w : program.words_of(block)) {
    if (t.dwells || w.value == ir::ExpressionId::none) continue;
    const ir::Expression& e = program.at(w.value);
    t.counted_feed |= is_counted_feed(program, w);
    t.counted_length |= is_length(w.address) && e.op == ir::Operator::constant && !e.has_point && e.value != 0.0;
    if (!ir::is_axis(w.address)) continue;
    t.axis_word = true;
    t.x_word |= w.address == Address::x;
    t.modal_axis_word |= w.mode == ir::WordMode::as_modal;
    t.explicit_word |= w.mode != ir::WordMode::as_modal;
  }
  return t;
}

// One main program, from its first block to its last: the order of the text is the only path.
bool runs_as_written(const ir::Program& program) {
  return program.sections.size() < 2 &&
         std::ranges::all_of(
             program.statements,
             [](const ir::Statement& s) {
               return s.kind == StatementKind::empty || s.kind == StatementKind::block ||
                      s.kind == StatementKind::assign || s.kind == StatementKind::define ||
                      s.kind == StatementKind::message || s.kind == StatementKind::program_end;
             });
}

bool uses_surface_speed(const ir::Program& program) {
  return std::ranges::find(program.codes, Function::surface_speed_on, &ir::Code::function) != program.codes.end();
}

// One group of the feed and surface speed there, two here.
bool splits_pair(const ir::Control& from, const ir::Control& to) {
  return from.semantics.feed_code_ends_surface_speed && !to.semantics.feed_code_ends_surface_speed;
}

class Settling {
 public:
  Settling(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to), flow_(program, from), speed_matters_(uses_surface_speed(program)) {
    speed_matters_ |= from.kind != ir::MachineKind::mill;
    wake_up();
  }

  std::vector<text::Diagnostic> run() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      if (facts::section_of(program_, i).first == i) wake_up();
      if (program_.statements[i].kind != StatementKind::block) continue;
      if (const Facts* known = flow_.before(i)) block(i, *known);
      for (const ir::Code& code : program_.codes_of(program_.blocks[program_.statements[i].payload]))
        if (const auto mode = mode_of(code)) by_text_[index_of(*mode)] = code.function;
    }
    return std::move(diagnostics_);
  }

 private:
  void wake_up() {
    for (std::size_t m = 0; m < kModes; ++m) by_text_[m] = facts::power_on(static_cast<Mode>(m), from_).function;
  }

  [[nodiscard]] Needs needs_of(const Traits& t) const {
    const ir::Semantics& from = from_.semantics;
    const ir::Semantics& to = to_.semantics;
    Needs needs{};
    const auto need = [&needs](Mode mode, bool when) { needs[index_of(mode)] = needs[index_of(mode)] || when; };
    // Feed and surface speed are two groups there and one here.
    const bool pairs = to.feed_code_ends_surface_speed && !from.feed_code_ends_surface_speed;
    need(Mode::feed, pairs && t.speed_code && !t.feed_code);
    need(Mode::surface_speed, pairs && t.feed_code && !t.speed_code && speed_matters_);
    need(Mode::unit, from.decimal_mode == ir::DecimalMode::least_increment && t.counted_length);
    const bool modal = !from.incremental_letters_uvw;
    need(Mode::distance, modal && to.incremental_letters_uvw && t.modal_axis_word);
    need(Mode::distance, modal && !to.feed_code_ends_surface_speed && t.explicit_word);
    need(Mode::distance, modal && pairs && t.drills);
    need(Mode::plane, pairs && t.drills);
    const bool turning = from_.kind != ir::MachineKind::mill && to_.kind != ir::MachineKind::mill;
    need(Mode::diameter, turning && from.feed_code_ends_surface_speed && !to.feed_code_ends_surface_speed && t.x_word);
    return needs;
  }

  void block(std::uint32_t i, const Facts& facts) {
    const Traits traits = traits_of(program_, program_.blocks[program_.statements[i].payload]);
    end_surface_speed(program_.blocks[program_.statements[i].payload], traits, facts[Mode::surface_speed]);
    if (traits.counted_feed && reads_feeds_otherwise(from_, to_)) count_feed(i, facts);
    Needs needs = needs_of(traits);
    for (const ir::Code& code : program_.codes_of(program_.blocks[program_.statements[i].payload]))
      if (const auto mode = mode_of(code)) needs[index_of(*mode)] = false;
    for (std::size_t m = 0; m < kModes; ++m)
      if (needs[m]) make_explicit(i, m, facts.modes[m]);
  }

  // A feed code by itself ends constant surface speed where both are one group; elsewhere S800 after it would be
  // metres.
  void end_surface_speed(ir::Block& block, const Traits& traits, const Known<Setting>& fact) {
    if (!splits_pair(from_, to_) || !speed_matters_ || !traits.feed_code || traits.speed_code) return;
    const bool is_off = fact.is({.function = Function::surface_speed_off});
    if (!is_off) add_code(block, index_of(Mode::surface_speed), Function::surface_speed_off);
  }

  // A hundredth of a millimetre per revolution, and of all that in inch.
  void count_feed(std::uint32_t i, const Facts& facts) {
    const ir::Block& block = program_.blocks[program_.statements[i].payload];
    const std::optional<Function> feed = mode_in(i, Mode::feed, facts);
    const std::optional<Function> unit = mode_in(i, Mode::unit, facts);
    if (!feed || !unit) return;
    double factor = 1.0;
    if (*feed == Function::feed_per_rev) factor /= kFeedsPerUnit;
    if (*unit == Function::unit_inch) factor /= kFeedsPerUnit;
    if (factor == 1.0) return;
    const auto inverse = std::ranges::find(program_.codes, Function::feed_inverse_time, &ir::Code::function);
    if (inverse != program_.codes.end()) {
      diagnostics_.push_back(
          passes::diagnose(passes::by_parameter("a feed without a point together with inverse time feed"),
                           program_.statements[i].span, to_.title));
      return;
    }
    for (std::uint32_t k = block.first_word; k < block.first_word + block.word_count; ++k) {
      if (!is_counted_feed(program_, program_.words[k])) continue;
      const ir::Expression e = program_.at(program_.words[k].value);
      program_.words[k].value = program_.add_constant(e.value * factor, e.span);
    }
  }

  // The block's own code, or what holds before it; nothing where that is not known, which is reported.
  std::optional<Function> mode_in(std::uint32_t i, Mode mode, const Facts& facts) {
    std::optional<Function> own;
    for (const ir::Code& code : program_.codes_of(program_.blocks[program_.statements[i].payload]))
      if (mode_of(code) == mode) own = code.function;
    if (own) return own;
    const Known<Setting>& fact = facts[mode];
    return is_known(i, index_of(mode), fact) ? std::optional(fact.value.function) : std::nullopt;
  }

  void make_explicit(std::uint32_t i, std::size_t mode, const Known<Setting>& fact) {
    if (!is_known(i, mode, fact)) return;
    if (fact.value.function != by_text_[mode])
      add_code(program_.blocks[program_.statements[i].payload], mode, fact.value.function);
  }

  // Reports where it is not, or may not be.
  bool is_known(std::uint32_t i, std::size_t mode, const Known<Setting>& fact) {
    const text::Span span = program_.statements[i].span;
    if (!fact.agrees()) {
      const bool is_new = reported_.insert({mode, facts::section_of(program_, i).first}).second;
      if (!is_new) return false;
      diagnostics_.push_back(text::make_diagnostic(
          text::DiagnosticId::unknown_modal_state, span,
          {std::string(row_of(mode).name), fmt::format("{}", fmt::join(flow_.paths(fact), ", or "))}));
      return false;
    }
    if (fact.changer != facts::kNoStatement &&
        reported_.insert({mode, fact.changer + (std::uint64_t{1} << 32)}).second) {
      diagnostics_.push_back(
          text::make_diagnostic(text::DiagnosticId::unknown_modal_state, span,
                                {std::string(row_of(mode).name),
                                 fmt::format("it is taken as {}, which what line {} calls or does may have changed",
                                             flow_.paths(fact).front(), program_.statements[fact.changer].line)}));
      diagnostics_.back().severity = text::Severity::warning;
    }
    return true;
  }

  // The code in front of the block's own.
  void add_code(ir::Block& block, std::size_t mode, Function function) {
    ir::Code code;
    code.function = function;
    code.group = row_of(mode).group;
    const std::vector<ir::Code> own(program_.codes_of(block).begin(), program_.codes_of(block).end());
    block.first_code = static_cast<std::uint32_t>(program_.codes.size());
    block.code_count += 1;
    program_.codes.push_back(code);
    program_.codes.insert(program_.codes.end(), own.begin(), own.end());
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  facts::Resolved flow_;
  bool speed_matters_;
  std::array<Function, kModes> by_text_{};
  std::set<std::pair<std::size_t, std::uint64_t>> reported_;
  std::vector<text::Diagnostic> diagnostics_;
};

// --- running by itself

class Assuming {
 public:
  Assuming(const ir::Program& program, const ir::Control& control)
      : program_(program), control_(control), flow_(program, control) {
    turns_ = std::ranges::any_of(control.caller_modes, [](const ir::CodeRow& row) {
      return row.function == Function::spindle_cw || row.function == Function::spindle_ccw;
    });
  }

  std::vector<text::Diagnostic> run() {
    const facts::StatementRange main = facts::section_of(program_, 0);
    const Facts* start = main.first < main.last ? flow_.before(main.first) : nullptr;
    const auto inherited = [](const Known<Setting>& fact) { return fact.inherited; };
    if (start == nullptr || std::ranges::none_of(start->modes, inherited)) return {};
    for (std::uint32_t i = main.first; i < main.last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != StatementKind::block) continue;
      if (const Facts* known = flow_.before(i)) block(s, *known);
      spindle(s);
    }
    return std::move(diagnostics_);
  }

 private:
  void block(const ir::Statement& s, Facts facts) {
    const ir::Block& block = program_.blocks[s.payload];
    for (const ir::Code& code : program_.codes_of(block))
      if (const auto mode = mode_of(code)) facts[*mode] = {.value = {.function = code.function}};
    const Traits t = traits_of(program_, block);
    const bool turning = control_.kind != ir::MachineKind::mill;
    const auto words = program_.words_of(block);
    const auto feed = std::ranges::find(words, Address::f, &ir::Word::address);
    const auto assume = [&](Mode mode, bool needed, text::DiagnosticId id, std::string argument) {
      if (needed && facts[mode].inherited) add_code(mode, id, s.span, std::move(argument));
    };
    using enum text::DiagnosticId;
    assume(Mode::unit, t.axis_word, unit_not_stated, {});
    assume(Mode::distance, t.modal_axis_word && !control_.semantics.incremental_letters_uvw, distance_mode_not_stated,
           {});
    assume(Mode::plane, t.bends && !turning, plane_not_stated, {});
    if (feed != words.end() && !t.dwells)
      assume(Mode::feed, true, feed_mode_not_stated, std::string(feed->span.in(program_.source.text())));
    // A mode of programs only where the feed is one group with surface speed.
    const bool has_diameter_codes = control_.semantics.feed_code_ends_surface_speed && turning;
    assume(Mode::diameter, t.x_word && has_diameter_codes, unknown_modal_state, std::string(kRows[5].name));
  }

  void add_code(Mode mode, text::DiagnosticId id, text::Span span, std::string argument) {
    if (std::exchange(reported_[index_of(mode)], true)) return;
    const Known<Setting> at_start{.value = facts::power_on(mode, control_), .origin = facts::kPowerOn};
    const std::string taken = "taken as " + flow_.paths(at_start).front() + "; a caller may have set another";
    std::vector<std::string> arguments;
    if (!argument.empty()) arguments.push_back(std::move(argument));
    if (id == text::DiagnosticId::unknown_modal_state) arguments.push_back(taken);
    text::Diagnostic d = text::make_diagnostic(id, span, std::move(arguments));
    d.severity = mode == Mode::unit ? text::Severity::error : text::Severity::warning;
    if (id != text::DiagnosticId::unknown_modal_state) d.notes.push_back({span, taken});
    diagnostics_.push_back(std::move(d));
  }

  // Plain blocks say a speed with the direction that it turns in.
  void spindle(const ir::Statement& s) {
    const ir::Block& block = program_.blocks[s.payload];
    const auto codes = program_.codes_of(block);
    const auto words = program_.words_of(block);
    turns_ = turns_ || std::ranges::any_of(codes, [](const ir::Code& c) {
               return c.function == Function::spindle_cw || c.function == Function::spindle_ccw;
             });
    const bool speed = std::ranges::any_of(words, [](const ir::Word& w) { return w.address == Address::s; }) ||
                       std::ranges::any_of(codes, [](const ir::Code& c) { return mode_of(c) == Mode::surface_speed; });
    if (turns_ || !speed || std::exchange(reported_speed_, true)) return;
    diagnostics_.push_back(
        passes::diagnose("a speed of the spindle that only the caller has started", s.span, "plain blocks"));
  }

  const ir::Program& program_;
  const ir::Control& control_;
  facts::Resolved flow_;
  std::array<bool, kModes> reported_{};
  bool turns_ = false;
  bool reported_speed_ = false;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

std::vector<text::Diagnostic> make_modes_explicit(ir::Program& program, const ir::Control& from,
                                                  const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  const bool may_end_speed = splits_pair(from, to) && uses_surface_speed(program);
  const bool counts_feeds = reads_feeds_otherwise(from, to) && has_counted_feed(program);
  if (runs_as_written(program) && !may_end_speed && !counts_feeds) return {};
  return Settling(program, from, to).run();
}

std::vector<text::Diagnostic> assumed_modes(const ir::Program& program, const ir::Control& control) {
  return Assuming(program, control).run();
}

}  // namespace dripfeed::passes
