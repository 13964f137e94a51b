// Blocks are taken in the order of the text: M29 belongs to the tapping cycle of the next block.
#include "dialects/passes/rigid_taps.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/ir/cycle.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::Function;
using ir::StatementKind;

constexpr std::int16_t kRigidFunction = 29;

enum class Form : std::uint8_t { usual, m29, comma_r, own_code };
struct FormRow {
  std::string_view dialect;
  Form form;
};
constexpr std::array kForms = {FormRow{"fanuc", Form::m29}, FormRow{"mitsubishi-m80", Form::comma_r},
                               FormRow{"mazak", Form::own_code}};

Form form_of(const ir::Control& control) {
  const auto* const row = std::ranges::find(kForms, control.dialect, &FormRow::dialect);
  return row == kForms.end() ? Form::usual : row->form;
}

bool is_m29(const ir::Code& c) { return c.function == Function::machine_function && c.argument == kRigidFunction; }

DrillCycle cycle_of(const ir::Code& c) { return static_cast<DrillCycle>(c.argument % ir::kDrillAlongZ); }
class Taps {
 public:
  Taps(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), to_(to), said_(form_of(from)), out_(program) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      if (s.kind == StatementKind::block && program_.blocks[s.payload].rest_level == 0)
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
    take_modes(codes, words);
    const bool adds_feed = feeds_again(codes, words);
    const auto tap = std::ranges::find_if(codes, is_tap);
    if (tap == codes.end()) {
      rigid_ = said_ == Form::m29 && std::ranges::any_of(codes, is_m29) && tap_follows(i);
      if (!rigid_) return adds_feed ? out_.emit_block(codes, words) : out_.keep();
      std::erase_if(codes, is_m29);
      if (!codes.empty() || !words.empty()) out_.emit_block(codes, words);
      return;
    }
    const bool rigid = takes_rigid(*tap, words, s);
    if (rigid) {
      convert_feed(words, s);
      add_rigid(program_, to_, *tap, words, out_);
    }
    out_.emit_block(codes, words);
  }

  void take_modes(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words) {
    for (const ir::Code& code : codes)
      if (code.group == ir::ModalGroup::feed) per_turn_ = code.function == Function::feed_per_rev;
    for (const ir::Word& word : words)
      if (word.address == Address::s && word.extension == 0) speed_rpm_ = constant_of(word);
  }
  [[nodiscard]] double constant_of(const ir::Word& word) const {
    const bool known = word.value != ir::ExpressionId::none && program_.at(word.value).op == ir::Operator::constant;
    return known ? program_.at(word.value).value : 0.0;
  }

  // Behind ,R1 F is the lead, in G94 too (Mitsubishi M800 programming manual, "Synchronous tapping"); elsewhere it is
  // the feed of its mode.
  void convert_feed(std::vector<ir::Word>& words, const ir::Statement& s) {
    if (per_turn_ || (said_ == Form::comma_r) == feeds_taps_by_lead(to_)) return;
    const auto feed = std::ranges::find(words, Address::f, &ir::Word::address);
    const double value = feed == words.end() ? 0.0 : constant_of(*feed);
    if (value <= 0.0 || speed_rpm_ <= 0.0) {
      diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::cannot_translate, s.span,
                                                   {"a rigid tap whose feed or speed is not written", to_.title}));
      return;
    }
    own_feed_ = *feed;
    feed->value =
        program_.add_constant(said_ == Form::comma_r ? value * speed_rpm_ : value / speed_rpm_, feed->span, true);
  }

  // The first block behind the cycle says F as it was written: it counts there, too, until another one does.
  bool feeds_again(const std::vector<ir::Code>& codes, std::vector<ir::Word>& words) {
    const bool says = std::ranges::find(words, Address::f, &ir::Word::address) != words.end();
    const bool ends = std::ranges::any_of(codes, [](const ir::Code& c) {
      return c.group == ir::ModalGroup::motion || c.group == ir::ModalGroup::cycle || c.function == Function::cycle_off;
    });
    if (!own_feed_ || (!says && !ends)) return false;
    if (!says) words.push_back(*own_feed_);
    own_feed_.reset();
    return !says;
  }

  // Takes the source's word for it away.
  bool takes_rigid(const ir::Code& tap, std::vector<ir::Word>& words, const ir::Statement& s) {
    bool rigid = std::exchange(rigid_, false);
    if (said_ == Form::own_code) rigid = is_written_rigid(tap.span.in(program_.source.text()));
    if (said_ != Form::comma_r) return rigid;
    for (const ir::Word& w : words) {
      if (w.address != Address::rounding) continue;
      const ir::Expression& e = program_.at(w.value);
      if (e.op != ir::Operator::constant)
        diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::cannot_translate, s.span,
                                                     {"a tap whose ,R is computed", to_.title}));
      rigid = e.value == 1.0;
    }
    std::erase_if(words, [](const ir::Word& w) { return w.address == Address::rounding; });
    return rigid;
  }

  [[nodiscard]] bool tap_follows(std::uint32_t i) const {
    for (++i; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::empty && !s.is_label) continue;
      return s.kind == StatementKind::block && !s.is_label &&
             std::ranges::any_of(program_.codes_of(program_.blocks[s.payload]), is_tap);
    }
    return false;
  }

  ir::Program& program_;
  const ir::Control& to_;
  Form said_;
  Rewrite out_;
  bool rigid_ = false;
  bool per_turn_ = false;             // G95
  double speed_rpm_ = 0.0;            // the last S; 0: not known
  std::optional<ir::Word> own_feed_;  // of a tap whose F was converted
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

bool is_tap(const ir::Code& code) {
  return code.function == Function::drill &&
         (cycle_of(code) == DrillCycle::tap_right || cycle_of(code) == DrillCycle::tap_left);
}

bool announces_rigid_tap(const ir::Code& code, const ir::Control& control) {
  return form_of(control) == Form::m29 && is_m29(code);
}

bool is_written_rigid(std::string_view written) {
  return written.ends_with("84.2") || written.ends_with("84.3") || written.ends_with("88.2");
}

bool feeds_taps_by_lead(const ir::Control& control) { return form_of(control) == Form::comma_r; }

void add_rigid(ir::Program& program, const ir::Control& to, ir::Code& tap, std::vector<ir::Word>& words, Rewrite& out) {
  const Form form = form_of(to);
  if (form == Form::own_code)
    tap.name = program.strings.add(cycle_of(tap) == DrillCycle::tap_left ? "G84.3"
                                   : tap.argument >= ir::kDrillAlongX    ? "G88.2"
                                                                         : "G84.2");
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

std::vector<text::Diagnostic> settle_taps(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  const bool any = std::ranges::any_of(program.codes, is_tap);
  return any ? Taps(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::passes
