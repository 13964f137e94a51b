// After the last block of a thread the feed is stated again as it is there.
#include "dialects/compile/translate/thread_leads.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/translate/lathe_facts.h"
#include "dialects/facts/axis_words.h"
#include "dialects/passes/findings.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;

class Leads {
 public:
  Leads(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to), facts_(program, from), out_(program), findings_(to) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (index_ = 0; index_ < count; ++index_) {
      out_.at(index_);
      statement_ = program_.statements[index_];
      findings_.at(statement_.span);
      if (ir::is_foreign(program_, index_)) {
        out_.keep();  // in ISO mode F is the lead, as it is there
        continue;
      }
      if (changes_lead(index_)) {
        changing();
        continue;
      }
      if (!cuts_thread(index_)) {
        out_.keep();
        continue;
      }
      const LatheState before = *facts_.before(index_);
      const ir::Block block = program_.blocks[statement_.payload];
      leads_by_letters(to_) ? feed_as_lead(before, block) : lead_as_feed(before, block);
    }
    out_.finish();
    return findings_.take();
  }

 private:
  // A block of a thread; where K, I or J say leads, with one of these.
  [[nodiscard]] bool cuts_thread(std::uint32_t index) const {
    const ir::Statement& s = program_.statements[index];
    const std::optional<LatheState> state = facts_.before(index);
    if (s.kind != StatementKind::block || !state) return false;
    const ir::Block& block = program_.blocks[s.payload];
    const auto codes = program_.codes_of(block);
    const auto motion = std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group);
    const bool thread =
        motion == codes.end() ? state->motion == Function::thread : motion->function == Function::thread;
    if (!thread || facts::has_own_words(program_, block)) return false;
    return leads_by_letters(from_) ? std::ranges::any_of(program_.words_of(block), is_lead) : moves_axes(block);
  }
  // A block that moves under G34 or G35, whatever it says of leads.
  [[nodiscard]] bool changes_lead(std::uint32_t index) const {
    const ir::Statement& s = program_.statements[index];
    if (s.kind != StatementKind::block) return false;
    const ir::Block& block = program_.blocks[s.payload];
    const auto codes = program_.codes_of(block);
    const auto motion = std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group);
    if (motion != codes.end()) return motion->function == Function::thread_changing;
    const std::optional<LatheState> state = facts_.before(index);
    return state && state->motion == Function::thread_changing && moves_axes(block) &&
           !facts::has_own_words(program_, block);
  }

  // G34 K2 F0.1 here is G34 F2 K0.1 there, G35 the same with K below 0. After it F is no feed on the one control and
  // the lead on the other.
  void changing() {
    const ir::Block block = program_.blocks[statement_.payload];
    if (block.rest_level != 0) return findings_.cannot(passes::at_switch("block skip inside a block"));
    std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    const bool by_letters = leads_by_letters(from_);
    const auto lead =
        by_letters ? std::ranges::find_if(words, is_lead) : std::ranges::find(words, Address::f, &ir::Word::address);
    const auto change = std::ranges::find(words, by_letters ? Address::f : Address::k, &ir::Word::address);
    if (lead == words.end() || change == words.end())
      return findings_.cannot(
          passes::not_known("a thread whose lead changes, without its lead and the change in the block"));
    const auto in_inch_alone = [](const ir::Code& c) { return c.function == Function::unit_inch && c.argument == 1; };
    if (by_letters && std::ranges::any_of(program_.codes, in_inch_alone))
      return findings_.cannot("the change of a lead where lengths alone are in inch (G70)");
    if (!by_letters && counts(*change))
      return findings_.cannot(passes::by_parameter("the change of a lead without a point"));
    if (needs_feed_after(program_, index_) && !thread_goes_on_changing())
      return findings_.cannot("the feed after a thread whose lead changes");
    if (!by_letters) lead_along_axis(*facts_.before(index_), words);
    if (by_letters) {
      lead->address = Address::f;
      change->address = Address::k;
      if (!take_sign(codes, *change))
        return findings_.cannot(passes::not_known("the change of a lead whose sign is not known"));
    }
    out_.emit_block(codes, words);
  }
  [[nodiscard]] bool thread_goes_on_changing() const {
    return index_ + 1 < program_.statements.size() && !program_.statements[index_ + 1].is_label &&
           changes_lead(index_ + 1);
  }
  // A number without a point that counts increments.
  [[nodiscard]] bool counts(const ir::Word& word) const {
    if (from_.semantics.decimal_mode != ir::DecimalMode::least_increment || word.value == ExpressionId::none)
      return false;
    const ir::Expression& e = program_.at(word.value);
    return e.op == ir::Operator::constant && !e.has_point && e.value != 0.0;
  }
  // G35: K is below 0, and the code is the one that the other control has. False where that is not known.
  bool take_sign(std::vector<ir::Code>& codes, ir::Word& change) {
    const auto code = std::ranges::find(codes, Function::thread_changing, &ir::Code::function);
    if (code == codes.end()) return false;  // which of the two is in effect
    const ir::Expression e = program_.at(change.value);
    const bool written = e.op == ir::Operator::constant;
    const bool shrinks = code->argument == 1;
    // In which direction it goes, the code says and no sign.
    if (e.op == ir::Operator::negate || (written && e.value < 0.0) || (shrinks && !written)) return false;
    code->argument = 0;
    if (shrinks) change.value = constant(-e.value);
    return true;
  }

  [[nodiscard]] bool thread_goes_on() const {
    return index_ + 1 < program_.statements.size() && !program_.statements[index_ + 1].is_label &&
           cuts_thread(index_ + 1);
  }
  static bool is_lead(const ir::Word& w) { return w.address >= Address::i && w.address <= Address::k; }

  void lead_as_feed(const LatheState& before, const ir::Block& block) {
    if (block.rest_level != 0) return findings_.cannot(passes::at_switch("block skip inside a block"));
    std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    // Each block says that its F is a lead: lengths may be in inch and feeds not (G70).
    if (std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group) == codes.end())
      codes.push_back(thread_code());
    std::vector<ir::Word> words;
    std::optional<double> feed = before.feed;
    for (const ir::Word& w : program_.words_of(block)) {
      if (w.address == Address::f) feed = facts_.feed_of(w, index_);
      if (w.address == Address::f) continue;
      words.push_back(w);
      if (is_lead(w)) words.back().address = Address::f;
    }
    out_.emit_block(codes, words);
    if (thread_goes_on()) return;
    if (!feed && needs_feed_after(program_, index_))
      findings_.cannot(passes::not_known("the feed after a thread, which is not known here,"));
    if (feed && *feed != 0.0) out_.emit_block({}, {word(Address::f, constant(*feed))});
  }

  // The lead stays in effect as a feed there, and is stated in each block here.
  void feed_as_lead(const LatheState& before, const ir::Block& block) {
    if (block.rest_level != 0) return out_.keep();
    const std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    const auto written = std::ranges::find(words, Address::f, &ir::Word::address);
    const bool known = before.feed && *before.feed != 0.0;
    if (written == words.end() && !known)
      return findings_.cannot(passes::not_known("the lead of a thread, not known here,"));
    ir::Word lead = written == words.end() ? word(Address::f, constant(*before.feed)) : *written;
    if (written == words.end()) words.push_back(lead);
    lead_along_axis(before, words);
    out_.emit_block(codes, words);
    if (!thread_goes_on() && needs_feed_after(program_, index_)) out_.emit_block({}, {lead});
  }

  // F of a cone counts along the axis that moves more, and there its letter is I or K. Where that is not known it is
  // taken as Z, with a warning.
  void lead_along_axis(const LatheState& before, std::vector<ir::Word>& words) {
    const auto lead = std::ranges::find(words, Address::f, &ir::Word::address);
    const std::optional<double> x = distance_along(Address::x, before.x, words);
    const std::optional<double> z = distance_along(Address::z, before.z, words);
    if ((x && *x == 0.0) || (z && *z == 0.0)) return;
    if (!x || !z) {
      findings_.warn("which axis the lead of a cone counts along, taken as Z,");
      return;
    }
    const double factor = from_.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0;
    if (*x / factor > *z) lead->address = Address::i;
  }
  // How far the block goes along X or Z as it is written there; nothing where that is not known.
  [[nodiscard]] std::optional<double> distance_along(Address axis, const std::optional<double>& from,
                                                     const std::vector<ir::Word>& words) const {
    const auto word = std::ranges::find_if(
        words, [&](const ir::Word& w) { return turning_axis(w.address, from_).value_or(Address::f) == axis; });
    if (word == words.end()) return 0.0;
    const std::optional<double> to = facts_.number(*word, index_);
    const std::optional<bool> increment = facts_.is_increment(*word, index_);
    if (!to || !increment || (!*increment && !from)) return std::nullopt;
    return std::abs(*increment ? *to : *to - *from);
  }

  [[nodiscard]] bool moves_axes(const ir::Block& block) const {
    return std::ranges::any_of(program_.words_of(block),
                               [&](const ir::Word& w) { return turning_axis(w.address, from_).has_value(); });
  }
  static ir::Code thread_code() {
    ir::Code code;
    code.function = Function::thread;
    code.group = ir::ModalGroup::motion;
    code.letter = 'G';
    return code;
  }
  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  LatheFacts facts_;
  passes::Rewrite out_;
  std::uint32_t index_ = 0;
  ir::Statement statement_;
  passes::Findings findings_;
};

}  // namespace

bool leads_by_letters(const ir::Control& control) { return !control.semantics.arc_radius_is_r; }

std::vector<text::Diagnostic> translate_leads(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  const bool threads = std::ranges::any_of(program.codes, [](const ir::Code& code) {
    return code.function == Function::thread || code.function == Function::thread_changing;
  });
  const bool differ = leads_by_letters(from) != leads_by_letters(to);
  return threads && differ ? Leads(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::compile
