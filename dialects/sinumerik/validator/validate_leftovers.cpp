// What is still in effect where it should have ended, and cuts without a turning spindle: as all paths to a block have
// it, and nothing that is not read may have changed it.
#include <algorithm>
#include <optional>
#include <string>

#include "dialects/facts/in_effect.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using facts::Kept;
using facts::Mode;
using ir::Address;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

constexpr Function kCuts[] = {Function::linear, Function::arc_cw,     Function::arc_ccw,
                              Function::thread, Function::arc_via,    Function::arc_tangent,
                              Function::spline, Function::polynomial, Function::thread_changing};

// LIMS[2]=… of another spindle.
bool limits_other_spindle(const ir::Program& program) {
  return std::ranges::any_of(program.words, [&](const ir::Word& word) {
    return word.address == Address::other && program.strings.at(word.name).starts_with("LIMS");
  });
}

class Leftovers {
 public:
  Leftovers(const Check& check, const facts::Resolved& facts)
      : check_(check),
        is_main_(!may_have_caller(check.program)),
        in_effect_(check.program, facts, is_main_),
        has_limit_(limits_other_spindle(check.program)) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = check_.program.statements[at];
    const bool ends = s.kind == StatementKind::program_end && is_main_;
    if (s.kind != StatementKind::block && !ends) return;
    in_effect_.at(at);
    if (ends)
      end(s.span);
    else
      block(check_.block_of(s));
  }

 private:
  void block(const ir::Block& block) {
    bool changes_tool = false;
    bool own_words = false;  // of a frame, of G4, of an axis by itself: no motion of the path
    for (const ir::Code& code : check_.program.codes_of(block)) {
      in_effect_.take(code);
      own_words |= code.group == ir::ModalGroup::non_modal || code.group == ir::ModalGroup::frame;
      changes_tool |= code.function == Function::tool_change;
      if (code.function == Function::surface_speed_on) limit(code, block);
      if (code.function == Function::tool_change) end(code.span);
    }
    bool moves = false;
    for (const ir::Word& word : check_.program.words_of(block)) {
      moves |= ir::is_linear_axis(word.address);
      const bool calls_tool = word.address == Address::t && check_.control.kind == ir::MachineKind::lathe;
      if (calls_tool && !changes_tool) end(word.span);
    }
    if (moves && !own_words) cut(block);
  }

  void limit(const ir::Code& code, const ir::Block& block) {
    if (has_limit_ || has_word(block, Address::spindle_limit) || !in_effect_.lacks(Kept::spindle_limit)) return;
    has_limit_ = true;
    text::Diagnostic& d =
        check_.report(DiagnosticId::surface_speed_unlimited, code.span, {"ever more", "0", "not known"});
    d.notes.push_back({code.span, "a limit of the machine (G26, setting data) may hold"});
  }

  void cut(const ir::Block& block) {
    const bool lacks_speed = !tap_reported_ && in_effect_.lacks(Kept::speed) && !has_word(block, Address::s);
    const bool is_still = stands();
    if (!lacks_speed && !is_still) return;
    const std::optional<facts::Setting> motion = in_effect_.stated(Mode::motion);
    if (!motion) return;
    if (lacks_speed && motion->function == Function::tap) {
      tap_reported_ = true;
      check_.report(DiagnosticId::tap_without_speed, span_of(block), {"G331"}).severity = text::Severity::warning;
    }
    const std::uint32_t origin = in_effect_.origin(Mode::spindle);
    if (!is_still || origin == spindle_reported_ || std::ranges::find(kCuts, motion->function) == std::end(kCuts))
      return;
    spindle_reported_ = origin;
    check_.report(DiagnosticId::spindle_not_turning, span_of(block));
  }

  // A spindle that was oriented may be meant to stand.
  [[nodiscard]] bool stands() const {
    const std::optional<facts::Setting> spindle = in_effect_.certain(Mode::spindle);
    if (!spindle || spindle->function != Function::spindle_stop) return false;
    const std::uint32_t origin = in_effect_.origin(Mode::spindle);
    if (origin >= check_.program.statements.size()) return true;
    const auto codes = check_.program.codes_of(check_.block_of(check_.program.statements[origin]));
    return std::ranges::find(codes, Function::spindle_orient, &ir::Code::function) == codes.end();
  }

  [[nodiscard]] bool has_word(const ir::Block& block, Address address) const {
    const auto words = check_.program.words_of(block);
    return std::ranges::find(words, address, &ir::Word::address) != words.end();
  }
  [[nodiscard]] text::Span span_of(const ir::Block& block) const {
    const auto codes = check_.program.codes_of(block);
    return codes.empty() ? check_.program.words_of(block).front().span : codes.front().span;
  }

  // A tool is changed, or the program ends.
  void end(text::Span span) {
    modal_call(span);
    const std::optional<facts::Setting> compensation = in_effect_.stated(Mode::compensation);
    const std::uint32_t origin = in_effect_.origin(Mode::compensation);
    if (!compensation || compensation->function == Function::comp_off || origin == compensation_reported_) return;
    compensation_reported_ = origin;
    report(span, std::string(in_effect_.written(Mode::compensation)));
  }

  // A program that is called after each move may do what it likes, but the call stays.
  void modal_call(text::Span span) {
    if (in_effect_.here() == nullptr) return;
    const facts::Known<facts::Setting>& fact = (*in_effect_.here())[Mode::modal_call];
    const bool is_known = fact.agrees() && (fact.changer == facts::kNoStatement || fact.changer == fact.origin);
    if (!is_known || fact.value.function == Function::none || fact.origin == modal_reported_) return;
    modal_reported_ = fact.origin;
    report(span, name_of(check_.program.statements[fact.origin]));
  }
  [[nodiscard]] std::string name_of(const ir::Statement& call) const {
    if (call.kind == StatementKind::native) return "MCALL " + std::string(check_.native_name(call));
    const ir::StringId name = check_.program.calls[call.payload].name;
    return name == ir::StringId::none ? "a modal call" : "MCALL " + std::string(check_.program.strings.at(name));
  }

  void report(text::Span span, std::string left) {
    check_.report(DiagnosticId::code_not_in_mode, span, {std::string(check_.text_of(span)), std::move(left)}).severity =
        text::Severity::warning;
  }

  const Check& check_;
  bool is_main_;
  facts::InEffect in_effect_;
  bool has_limit_;
  // Reported: once, or by the statement that set what is reported.
  bool tap_reported_ = false;
  std::uint32_t spindle_reported_ = ir::kNoIndex;
  std::uint32_t compensation_reported_ = ir::kNoIndex;
  std::uint32_t modal_reported_ = ir::kNoIndex;
};

}  // namespace

StatementCheck leftovers_check(const Check& check, const facts::Resolved& facts) {
  return [leftovers = Leftovers(check, facts)](std::uint32_t i) mutable { leftovers.statement(i); };
}

}  // namespace dripfeed::sinumerik
