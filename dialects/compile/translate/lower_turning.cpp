// A pass of G92, with the tool at X0 Z0:
//
//   G92 X29. Z-20. F2.         G0 X29
//                              G33 Z-20 K2
//                              G0 X30          X0
//                              G0 Z5           Z0
//
// The moves are written in the coordinates of the program, absolute, with the cycle's own words where these are
// computed. A thread's lead is written as the other control takes it: K or I, or F, which is then said again as it was.
#include "dialects/compile/translate/lower_turning.h"

#include <algorithm>
#include <cmath>
#include <expected>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/translate/lathe_facts.h"
#include "dialects/compile/translate/thread_call.h"
#include "dialects/compile/translate/thread_leads.h"
#include "dialects/facts/axis_words.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/findings.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/round_positions.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr std::int16_t kThread = ir::argument_of(ir::TurningCycle::thread);
constexpr std::int16_t kAlongX = ir::argument_of(ir::TurningCycle::along_x);
constexpr std::size_t kMostMoves = 20'000;

bool has_row(const ir::Control& control, Function function) {
  return std::ranges::find(control.g_codes, function, &ir::CodeRow::function) != control.g_codes.end();
}

class Lowering {
 public:
  Lowering(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        from_(from),
        to_(to),
        facts_(program, from),
        out_(program),
        findings_(to),
        factor_(from.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (index_ = 0; index_ < count; ++index_) {
      out_.at(index_);
      statement_ = program_.statements[index_];
      findings_.at(statement_.span);
      const std::optional<LatheState> state = facts_.before(index_);
      if (!state)
        out_.keep();
      else if (statement_.kind == StatementKind::block)
        block_with_stop(*state);
      else if (statement_.kind == StatementKind::call && is_thread_call(program_.calls[statement_.payload]))
        thread_call(*state);
      else
        out_.keep();
    }
    out_.finish();
    return findings_.take();
  }

 private:
  // --- which blocks

  // M0 stops the machine when the block's moves are made.
  void block_with_stop(const LatheState& before) {
    last_codes_.clear();
    block(before);
    if (!last_codes_.empty()) out_.emit_block(last_codes_, {});
  }
  void take_code(const ir::Code& code, std::vector<ir::Code>& codes) {
    const bool stops = code.function == Function::program_stop || code.function == Function::optional_stop;
    (stops ? last_codes_ : codes).push_back(code);
  }

  void block(const LatheState& before) {
    const ir::Block block = program_.blocks[statement_.payload];
    const auto codes = program_.codes_of(block);
    const auto repeats = std::ranges::find(codes, Function::repetitive_cycle, &ir::Code::function);
    if (repeats != codes.end() && !ir::follows_shape(*repeats) && !has_row(to_, Function::repetitive_cycle))
      return repetitive(before, block);
    if (has_row(to_, Function::turning_cycle)) return out_.keep();
    const auto turns = std::ranges::find(codes, Function::turning_cycle, &ir::Code::function);
    const auto moves = std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group);
    const bool stays = moves == codes.end() && before.cycle != LatheState::kNone;
    if ((turns == codes.end() && !stays) || (turns == codes.end() && facts::has_own_words(program_, block)))
      return out_.keep();
    if (turns == codes.end() && !moves_axes(block)) return out_.keep();
    if (turns == codes.end() && !before.cycle)
      return findings_.unknown("the turning cycle", "two control-flow paths lead to this block and differ");
    pass(before, block, turns == codes.end() ? *before.cycle : turns->argument, turns != codes.end());
  }

  [[nodiscard]] bool moves_axes(const ir::Block& block) const {
    return std::ranges::any_of(program_.words_of(block), [&](const ir::Word& w) {
      return turning_axis(w.address, from_).has_value() || w.address == Address::r;
    });
  }

  // --- G90, G92, G94

  struct Pass {
    ExpressionId x = ExpressionId::none;
    ExpressionId z = ExpressionId::none;
    ExpressionId taper = ExpressionId::none;  // none: there is none
  };

  void pass(const LatheState& before, const ir::Block& block, std::int16_t cycle, bool begins) {
    if (block.rest_level != 0) return findings_.cannot(passes::at_switch("block skip inside a block"));
    if (!find_distance()) return;
    std::vector<ir::Code> rest_codes;
    std::vector<ir::Word> rest;
    for (const ir::Code& c : program_.codes_of(block))
      if (c.function != Function::turning_cycle) take_code(c, rest_codes);
    const std::optional<Pass> words = words_of(before, block, cycle, begins, rest);
    if (!words) return;
    if (words->x == ExpressionId::none || words->z == ExpressionId::none || !moves_axes(block)) {
      if (!rest_codes.empty() || !rest.empty()) out_.emit_block(rest_codes, rest);
      return;
    }
    if (!before.x || !before.z)
      return findings_.cannot(passes::not_known("a turning cycle that begins at a position not known here"));
    if (cycle == kThread && !lead_) return findings_.cannot(passes::not_known("the lead of a thread, not known here,"));
    const ExpressionId x0 = constant(*before.x);
    const ExpressionId z0 = constant(*before.z);
    first_codes_ = std::move(rest_codes);
    first_words_ = std::move(rest);
    const bool tapers = words->taper != ExpressionId::none;
    if (cycle == kAlongX) {
      move(Function::rapid, ExpressionId::none, tapers ? sum(words->z, words->taper, 1.0) : words->z);
      move(Function::linear, words->x, tapers ? words->z : ExpressionId::none);
      move(Function::linear, ExpressionId::none, z0);
      move(Function::rapid, x0, ExpressionId::none);
      return;
    }
    move(Function::rapid, tapers ? sum(words->x, words->taper, factor_) : words->x, ExpressionId::none);
    if (cycle == kThread)
      thread(tapers ? words->x : ExpressionId::none, words->z, *lead_, false);
    else
      move(Function::linear, tapers ? words->x : ExpressionId::none, words->z);
    move(cycle == kThread ? Function::rapid : Function::linear, x0, ExpressionId::none);
    move(Function::rapid, ExpressionId::none, z0);
  }

  // The cycle's own words and those that it keeps; the others go to `rest`.
  std::optional<Pass> words_of(const LatheState& before, const ir::Block& block, std::int16_t cycle, bool begins,
                               std::vector<ir::Word>& rest) {
    Pass pass;
    const Address old_taper = cycle == kAlongX ? Address::k : Address::i;
    bool tapers = false;
    lead_ = before.feed && *before.feed != 0.0 ? std::optional(constant(*before.feed)) : std::nullopt;
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    for (const ir::Word& w : words) {
      if (w.address == Address::r || w.address == old_taper) {
        const std::optional<ExpressionId> value = value_of(w);
        if (!value) return std::nullopt;
        pass.taper = number(*value) == 0.0 ? ExpressionId::none : *value;
        tapers = true;
      } else if (const std::optional<Address> axis = turning_axis(w.address, from_)) {
        const std::optional<ExpressionId> end = end_of(before, w, *axis);
        if (!end) return std::nullopt;
        (*axis == Address::x ? pass.x : pass.z) = *end;
      } else if (ir::is_axis(w.address) || w.address == Address::q) {
        findings_.cannot("a turning cycle with the word " + std::string(w.span.in(program_.source.text())));
        return std::nullopt;
      } else {
        if (w.address == Address::f) {
          const std::optional<double> feed = facts_.feed_of(w, index_);
          lead_ = feed ? constant(*feed) : w.value;
        }
        rest.push_back(w);
      }
    }
    if (begins) return pass;
    const auto kept = [&](ExpressionId& word, const std::optional<bool>& has, const std::optional<double>& value) {
      if (word != ExpressionId::none || has == false) return true;
      if (!has || !value) return false;
      word = constant(*value);
      return true;
    };
    if (!tapers && before.taper && *before.taper != 0.0) pass.taper = constant(*before.taper);
    if (kept(pass.x, before.has_x, before.end_x) && kept(pass.z, before.has_z, before.end_z) &&
        (tapers || before.taper))
      return pass;
    findings_.cannot(passes::not_known("a word that a turning cycle keeps, not known here,"));
    return std::nullopt;
  }

  std::optional<ExpressionId> end_of(const LatheState& before, const ir::Word& w, Address axis) {
    const std::optional<bool> increment = facts_.is_increment(w, index_);
    if (!increment) {
      findings_.unknown("absolute or incremental", "two control-flow paths lead to this block and differ");
      return std::nullopt;
    }
    const std::optional<ExpressionId> value = value_of(w);
    if (!value || !*increment) return value;
    const std::optional<double>& place = axis == Address::x ? before.x : before.z;
    if (!place) {
      findings_.cannot(passes::not_known("a turning cycle that begins at a position not known here"));
      return std::nullopt;
    }
    return sum(constant(*place), *value, 1.0);
  }

  std::optional<ExpressionId> value_of(const ir::Word& w) {
    if (const std::optional<double> value = facts_.number(w, index_)) return constant(*value);
    if (program_.at(w.value).op != Operator::constant) return w.value;
    findings_.unknown("the unit of lengths", "two control-flow paths lead to this block and differ");
    return std::nullopt;
  }

  // --- G74, G75, G76

  void repetitive(const LatheState& before, const ir::Block& block) {
    if (block.rest_level != 0) return findings_.cannot(passes::at_switch("block skip inside a block"));
    if (!find_distance()) return;
    first_codes_.clear();
    first_words_.clear();
    LatheState here = before;
    for (const ir::Code& c : program_.codes_of(block))
      if (c.function != Function::repetitive_cycle) take_code(c, first_codes_);
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    for (const ir::Word& w : words) {
      const bool rest =
          w.address == Address::f || w.address == Address::s || w.address == Address::t || w.address == Address::m;
      if (w.address == Address::f) here.feed = facts_.feed_of(w, index_);
      if (rest) first_words_.push_back(w);
    }
    const std::optional<LatheFacts::Repeated> done = facts_.repeat(index_, here);
    if (!done)
      return findings_.cannot(passes::not_known("a turning cycle whose numbers or position are not known here"));
    if (done->fails || done->motions.size() > kMostMoves) return findings_.cannot("a turning cycle with such numbers");
    moves(done->motions, done->inch ? 25.4 : 1.0);
    if (!first_codes_.empty() || !first_words_.empty())
      out_.emit_block(std::exchange(first_codes_, {}), std::exchange(first_words_, {}));
    if (!done->motions.empty()) motion_again(before, {});
  }

  // --- threads by a call

  void thread_call(const LatheState& before) {
    const std::string name(program_.strings.at(program_.calls[statement_.payload].name));
    if (!is_lathe(to_) || !is_lathe(from_)) return findings_.cannot(name + " between a lathe and a mill");
    const std::optional<Function> unit = facts_.mode(facts::Mode::unit, index_);
    if (!unit) return findings_.cannot(passes::not_known(name + " where the unit of lengths is not known"));
    const bool inch = *unit == Function::unit_inch;
    const std::expected<std::vector<ir::Motion>, std::string> done =
        moves_of_thread(program_, program_.calls[statement_.payload], from_, inch);
    if (!done) return findings_.cannot(done.error());
    const std::optional<Function> distance = facts_.mode(facts::Mode::distance, index_);
    const std::optional<Function> diameter = facts_.mode(facts::Mode::diameter, index_);
    if (!distance || !diameter)
      return findings_.cannot(
          passes::not_known(name + " where absolute, incremental, diameter or radius is not known"));
    x_scale_ = *diameter == Function::diameter_off ? 0.5 : 1.0;
    mode_ = *distance == Function::incremental ? ir::WordMode::absolute : ir::WordMode::as_modal;
    moves(*done, inch ? 25.4 : 1.0);
    x_scale_ = 1.0;
    mode_ = ir::WordMode::as_modal;
    // Here the lead was the feed.
    std::vector<ir::Word> feed;
    if (before.feed && *before.feed != 0.0) feed.push_back(word(Address::f, constant(*before.feed)));
    motion_again(before, feed);
    if (!before.feed && needs_feed_after(program_, index_))
      findings_.cannot(passes::not_known("the feed after " + name + ", which is not known here,"));
  }

  static bool is_lathe(const ir::Control& control) { return control.kind != ir::MachineKind::mill; }

  // --- moves

  // `mm`: of one unit of the program.
  void moves(const std::vector<ir::Motion>& motions, double mm) {
    bool first = true;
    for (const ir::Motion& m : motions) {
      if (!ir::is_move(m.kind)) continue;
      const auto at = [&](std::size_t axis) {
        const bool stays = !first && m.end[axis] == m.start[axis];
        if (stays || (m.axes_commanded & (1U << axis)) == 0) return ExpressionId::none;
        return constant(rounded(m.end[axis] * (axis == 0 ? x_scale_ : 1.0), mm));
      };
      const ExpressionId x = at(0);
      const ExpressionId z = at(2);
      if (x == ExpressionId::none && z == ExpressionId::none) continue;
      first = false;
      if (m.kind == ir::MotionKind::thread) {
        const bool along_x = std::abs(m.end[0] - m.start[0]) / factor_ > std::abs(m.end[2] - m.start[2]) + 1e-9;
        thread(x, z, constant(m.feed / mm), along_x);
      } else {
        move(m.kind == ir::MotionKind::rapid ? Function::rapid : Function::linear, x, z);
      }
    }
  }

  // In units of `mm`, as the control counts them.
  [[nodiscard]] double rounded(double value_mm, double mm) const {
    const double increment = passes::least_increment_mm(to_, mm != 1.0) / mm;
    const double per_unit = std::nearbyint(1.0 / increment);
    return std::nearbyint(value_mm / mm * per_unit) / per_unit;
  }

  // The block's other codes and words go into the first move.
  void move(Function function, ExpressionId x, ExpressionId z) {
    std::vector<ir::Code> codes = std::exchange(first_codes_, {});
    codes.push_back(motion_code(function));
    std::vector<ir::Word> words;
    if (x != ExpressionId::none) words.push_back(word(Address::x, x));
    if (z != ExpressionId::none) words.push_back(word(Address::z, z));
    words.insert(words.end(), first_words_.begin(), first_words_.end());
    first_words_.clear();
    out_.emit_block(codes, words);
  }

  void thread(ExpressionId x, ExpressionId z, ExpressionId lead, bool along_x) {
    std::vector<ir::Word> words;
    if (x != ExpressionId::none) words.push_back(word(Address::x, x));
    if (z != ExpressionId::none) words.push_back(word(Address::z, z));
    ir::Word pitch = word(leads_by_letters(to_) ? (along_x ? Address::i : Address::k) : Address::f, lead);
    pitch.mode = ir::WordMode::as_modal;
    words.push_back(pitch);
    out_.emit_block({motion_code(Function::thread)}, words);
  }

  // The moves end in rapid; what was in effect before is written again.
  void motion_again(const LatheState& before, const std::vector<ir::Word>& words) {
    if (before.cycle != LatheState::kNone) return;
    std::vector<ir::Code> codes;
    if (before.motion && *before.motion != Function::rapid) codes.push_back(motion_code(*before.motion));
    if (!before.motion && needs_motion_after(program_, index_))
      return findings_.unknown("the motion after the cycle", "two control-flow paths lead to this block and differ");
    if (!codes.empty() || !words.empty()) out_.emit_block(codes, words);
  }

  // The words that are written are absolute: where increments have no letters of their own, under G91 each says so.
  bool find_distance() {
    mode_ = ir::WordMode::as_modal;
    if (from_.semantics.incremental_letters_uvw) return true;
    const std::optional<Function> distance = facts_.mode(facts::Mode::distance, index_);
    if (!distance) {
      findings_.unknown("absolute or incremental", "two control-flow paths lead to this block and differ");
      return false;
    }
    if (*distance == Function::incremental) mode_ = ir::WordMode::absolute;
    return true;
  }

  // --- small parts

  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }
  [[nodiscard]] std::optional<double> number(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    return e.op == Operator::constant ? std::optional(e.value) : std::nullopt;
  }
  ExpressionId sum(ExpressionId a, ExpressionId b, double times) {
    const std::optional<double> left = number(a);
    const std::optional<double> right = number(b);
    // Six places: without what a binary fraction leaves.
    if (left && right) return constant(std::nearbyint((*left + *right * times) * 1e6) / 1e6);
    const ExpressionId product = times == 1.0 ? b
                                 : right      ? constant(*right * times)
                                              : program_.add_operator(Operator::multiply, b, constant(times));
    return program_.add_operator(Operator::add, a, product);
  }
  static ir::Code motion_code(Function function) {
    ir::Code code;
    code.function = function;
    code.group = ir::ModalGroup::motion;
    return code;
  }
  [[nodiscard]] ir::Word word(Address address, ExpressionId value) const {
    ir::Word w = ir::word(address, value);
    if (address == Address::x || address == Address::z) w.mode = mode_;
    return w;
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  LatheFacts facts_;
  passes::Rewrite out_;
  passes::Findings findings_;
  double factor_;  // of a radius in the words of X
  std::uint32_t index_ = 0;
  ir::Statement statement_;
  std::optional<ExpressionId> lead_;
  std::vector<ir::Code> first_codes_;
  std::vector<ir::Code> last_codes_;
  std::vector<ir::Word> first_words_;
  double x_scale_ = 1.0;
  ir::WordMode mode_ = ir::WordMode::as_modal;
};

}  // namespace

std::vector<text::Diagnostic> lower_turning(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  const bool codes = std::ranges::any_of(program.codes, [&](const ir::Code& c) {
    return (c.function == Function::turning_cycle || c.function == Function::repetitive_cycle) &&
           !has_row(to, c.function);
  });
  const bool calls = std::ranges::any_of(program.calls, is_thread_call);
  return codes || calls ? Lowering(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::compile
