// Blocks are taken in the order of the text: M29 belongs to the tapping cycle of the next block.
#include "dialects/passes/rigid_taps.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/facts/resolved.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::Function;
using ir::StatementKind;

constexpr std::int16_t kRigidFunction = 29;

using Form = ir::RigidTap;

bool is_m29(const ir::Code& c) { return c.function == Function::machine_function && c.argument == kRigidFunction; }

DrillCycle cycle_of(const ir::Code& c) { return static_cast<DrillCycle>(c.argument % ir::kDrillAlongZ); }

class Taps {
 public:
  Taps(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        to_(to),
        always_rigid_(from.semantics.taps_are_rigid),
        form_from_(from.semantics.rigid_tap),
        flow_(program, from),
        targets_(facts::jump_targets(program)),
        out_(program) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      const bool plain = s.kind == StatementKind::block && program_.blocks[s.payload].rest_level == 0;
      if (own_feed_ && !goes_straight(i))
        refuse(s,
               passes::by_parameter("a rigid tap whose feed is counted differently here, with a jump before its end,"));
      if (plain)
        block(i, s);
      else
        out_.keep();
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  void block(std::uint32_t i, const ir::Statement& s) {
    const ir::Block block = program_.blocks[s.payload];
    std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    const bool adds_feed = feeds_again(codes, words, s);
    const auto tap = std::ranges::find_if(codes, is_tap);
    if (tap == codes.end()) {
      in_announced_tap_ = in_announced_tap_ && !ends_cycle(codes);
      rigid_ = form_from_ == Form::m29 && std::ranges::any_of(codes, is_m29) && tap_follows(i);
      if (!rigid_) return adds_feed ? out_.emit_block(codes, words) : out_.keep();
      std::erase_if(codes, is_m29);
      if (!codes.empty() || !words.empty()) out_.emit_block(codes, words);
      return;
    }
    // Whether the spindle goes on being turned by its position, nothing that was found says.
    if (std::exchange(in_announced_tap_, rigid_) && !rigid_) refuse(s, passes::together("a second tap after one M29"));
    const bool rigid = takes_rigid(*tap, words, s);
    if (!rigid) warn_taken_as_rigid(s);
    if (rigid) {
      convert_feed(words, i);
      add_rigid(program_, to_, *tap, words, out_);
    }
    out_.emit_block(codes, words);
  }

  void refuse(const ir::Statement& s, passes::Refusal what) {
    own_feed_.reset();
    warn(s, std::move(what));
  }
  void warn(const ir::Statement& s, passes::Refusal what) {
    diagnostics_.push_back(passes::diagnose(std::move(what), s.span, to_.title));
  }
  // SINUMERIK names rigid taps and those in a compensating chuck apart; a rigid one is right in either chuck.
  void warn_taken_as_rigid(const ir::Statement& s) {
    if (to_.semantics.rigid_tap != Form::usual || std::exchange(warned_of_rigid_, true)) return;
    warn(s, passes::by_parameter("a tap that a parameter makes rigid or not (Fanuc 5200#0), written as a rigid one,"));
    diagnostics_.back().severity = text::Severity::warning;
  }
  static bool ends_cycle(const std::vector<ir::Code>& codes) {
    return std::ranges::any_of(
        codes, [](const ir::Code& c) { return c.group == ir::ModalGroup::motion || c.group == ir::ModalGroup::cycle; });
  }
  // Whether the program comes to it from the statement before it alone, and always.
  [[nodiscard]] bool goes_straight(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    const bool passes_on = s.kind == StatementKind::block || s.kind == StatementKind::empty ||
                           s.kind == StatementKind::assign || s.kind == StatementKind::message;
    const bool may_be_skipped =
        s.skip_level != 0 || (s.kind == StatementKind::block && program_.blocks[s.payload].rest_level != 0);
    return passes_on && !targets_[i] && !may_be_skipped;
  }
  // The S that counts at the statement, in rev/min: the last one of a straight path there, or the only one that the
  // program knows; nothing where that is not certain.
  [[nodiscard]] std::optional<double> speed_at(std::uint32_t i) const {
    for (;; --i) {
      if (const ir::Word* word = speed_word(program_.statements[i])) return constant_of(*word);
      if (i == 0 || !goes_straight(i)) return only_speed();
    }
  }
  [[nodiscard]] const ir::Word* speed_word(const ir::Statement& s) const {
    if (s.kind != StatementKind::block) return nullptr;
    const auto words = program_.words_of(program_.blocks[s.payload]);
    const auto word =
        std::ranges::find_if(words, [](const ir::Word& w) { return w.address == Address::s && w.extension == 0; });
    return word == words.end() ? nullptr : &*word;
  }
  [[nodiscard]] std::optional<double> only_speed() const {
    std::optional<double> only;
    for (const ir::Statement& s : program_.statements) {
      if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) return std::nullopt;
      const ir::Word* word = speed_word(s);
      if (word == nullptr) continue;
      const double speed_rpm = constant_of(*word);
      if (only.value_or(speed_rpm) != speed_rpm) return std::nullopt;
      only = speed_rpm;
    }
    return only;
  }
  // Nothing where paths that lead there bring different ones.
  [[nodiscard]] std::optional<Function> feed_mode_at(std::uint32_t i) const {
    for (const ir::Code& code : program_.codes_of(program_.blocks[program_.statements[i].payload]))
      if (code.group == ir::ModalGroup::feed) return code.function;
    const facts::Facts* facts = flow_.before(i);
    if (facts == nullptr || !(*facts)[facts::Mode::feed].agrees()) return std::nullopt;
    return (*facts)[facts::Mode::feed].value.function;
  }
  [[nodiscard]] double constant_of(const ir::Word& word) const {
    const bool known = word.value != ir::ExpressionId::none && program_.at(word.value).op == ir::Operator::constant;
    return known ? program_.at(word.value).value : 0.0;
  }

  // After ,R1 F is the lead, in G94 too (Mitsubishi M800 programming manual, "Synchronous tapping"); elsewhere it is
  // the feed of its mode.
  void convert_feed(std::vector<ir::Word>& words, std::uint32_t i) {
    if ((form_from_ == Form::comma_r) == feeds_taps_by_lead(to_)) return;
    const ir::Statement s = program_.statements[i];
    const std::optional<Function> mode = feed_mode_at(i);
    if (!mode) return refuse(s, passes::not_known("a rigid tap where the kind of feed is not known"));
    if (*mode == Function::feed_per_rev) return;
    const auto feed = std::ranges::find(words, Address::f, &ir::Word::address);
    const double value = feed == words.end() ? 0.0 : constant_of(*feed);
    const double speed_rpm = speed_at(i).value_or(0.0);
    if (*mode != Function::feed_per_min || value <= 0.0 || speed_rpm <= 0.0)
      return refuse(s, passes::not_known("a rigid tap whose feed or speed is not written, as far as is known here,"));
    own_feed_ = *feed;
    feed->value =
        program_.add_constant(form_from_ == Form::comma_r ? value * speed_rpm : value / speed_rpm, feed->span, true);
  }

  // The first block after the cycle says F as it was written: it counts there, too, until another one does. Under the
  // cycle nothing may change the lead.
  bool feeds_again(const std::vector<ir::Code>& codes, std::vector<ir::Word>& words, const ir::Statement& s) {
    if (!own_feed_) return false;
    const auto has = [&](Address a) { return std::ranges::find(words, a, &ir::Word::address) != words.end(); };
    const bool ends = ends_cycle(codes);
    const bool changes = has(Address::f) || has(Address::s) ||
                         std::ranges::any_of(codes, [](const ir::Code& c) { return c.group == ir::ModalGroup::feed; });
    if (!ends && changes)
      refuse(s, passes::by_parameter(
                    "a feed or speed that changes under a rigid tap whose feed is counted differently here"));
    if (!ends || !own_feed_) return false;
    const bool says = has(Address::f);
    if (!says) words.push_back(*own_feed_);
    own_feed_.reset();
    return !says;
  }

  // Takes the source's word for it away.
  bool takes_rigid(const ir::Code& tap, std::vector<ir::Word>& words, const ir::Statement& s) {
    bool rigid = std::exchange(rigid_, false) || always_rigid_;
    if (form_from_ == Form::own_code) rigid = is_written_rigid(tap.span.in(program_.source.text()));
    if (form_from_ != Form::comma_r) return rigid;
    for (const ir::Word& w : words) {
      if (w.address != Address::rounding) continue;
      const ir::Expression& e = program_.at(w.value);
      if (e.op != ir::Operator::constant)
        diagnostics_.push_back(passes::diagnose(passes::computed("a tap whose ,R is computed"), s.span, to_.title));
      rigid = e.value == 1.0;
    }
    std::erase_if(words, [](const ir::Word& w) { return w.address == Address::rounding; });
    return rigid;
  }

  [[nodiscard]] bool tap_follows(std::uint32_t i) const {
    for (++i; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::empty && !targets_[i]) continue;
      return s.kind == StatementKind::block && !targets_[i] &&
             std::ranges::any_of(program_.codes_of(program_.blocks[s.payload]), is_tap);
    }
    return false;
  }

  ir::Program& program_;
  const ir::Control& to_;
  bool always_rigid_;
  Form form_from_;
  facts::Resolved flow_;
  std::vector<bool> targets_;  // of jumps
  Rewrite out_;
  bool rigid_ = false;
  bool warned_of_rigid_ = false;
  bool in_announced_tap_ = false;     // M29 came before it
  std::optional<ir::Word> own_feed_;  // of a tap whose F was converted
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

bool is_tap(const ir::Code& code) {
  return code.function == Function::drill &&
         (cycle_of(code) == DrillCycle::tap_right || cycle_of(code) == DrillCycle::tap_left);
}

bool is_floating_tap(const ir::Code& code) {
  return code.function == Function::linear && code.group == ir::ModalGroup::non_modal;
}

bool announces_rigid_tap(const ir::Code& code, const ir::Control& control) {
  return control.semantics.rigid_tap == Form::m29 && is_m29(code);
}

bool is_written_rigid(std::string_view written) {
  return written.ends_with("84.2") || written.ends_with("84.3") || written.ends_with("88.2");
}

bool feeds_taps_by_lead(const ir::Control& control) { return control.semantics.rigid_tap == Form::comma_r; }

namespace {

// Its name in the control's table: the code next to the usual one, with a digit after the point.
std::string_view rigid_name(const ir::Control& to, const ir::Code& tap) {
  const auto row = std::ranges::find_if(to.g_codes, [&](const ir::CodeRow& r) {
    return r.function == Function::drill && r.argument == tap.argument && r.number10 % 10 != 0;
  });
  return row == to.g_codes.end() ? std::string_view() : row->name;
}

}  // namespace

void add_rigid(ir::Program& program, const ir::Control& to, ir::Code& tap, std::vector<ir::Word>& words, Rewrite& out) {
  const Form form = to.semantics.rigid_tap;
  const std::string_view own = form == Form::own_code ? rigid_name(to, tap) : std::string_view();
  if (!own.empty()) tap.name = program.strings.add(own);
  if (form == Form::comma_r) {
    ir::Word one;
    one.address = Address::rounding;
    one.value = program.add_constant(1.0, {}, false);
    words.push_back(one);
  }
  if (form != Form::m29) return;
  ir::Code m29;
  m29.function = Function::machine_function;
  m29.argument = kRigidFunction;
  m29.letter = 'M';
  out.emit_block({m29}, {});
}

std::vector<text::Diagnostic> translate_taps(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  const bool any = std::ranges::any_of(program.codes, is_tap);
  return any ? Taps(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::passes
