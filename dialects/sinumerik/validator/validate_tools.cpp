// Compensation where no tool edge is active, and constant surface speed without a speed: what a program can be seen to
// lack in the order of its text; a subprogram may have them from its caller. After a call or a native statement of
// unknown effect nothing more is said.
#include <algorithm>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

class Tools {
 public:
  explicit Tools(const Check& check) : check_(check) {}

  void run() {
    had_speed_ = may_have_caller(check_.program);
    for (const ir::Statement& s : check_.program.statements) {
      // A jump back may come from where the tool is another.
      if (s.is_label) off_ = surface_speed_ = {};
      const bool others = s.kind == StatementKind::call || s.kind == StatementKind::modal_call ||
                          (s.kind == StatementKind::native && !check_.program.natives[s.payload].effects_known);
      if (others) return;
      if (s.kind == StatementKind::assign) offset_data(s);
      if (s.kind == StatementKind::block) block(check_.block_of(s));
    }
  }

 private:
  void block(const ir::Block& block) {
    bool moves = false;
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (word.address == Address::t || word.address == Address::d) {
        const ir::Expression& value = check_.program.at(word.value);
        const bool none = value.op == ir::Operator::constant && value.value == 0.0;
        off_ = none ? word.span : text::Span{};
      }
      moves = moves || ir::is_axis(word.address);
    }
    for (const ir::Code& code : check_.program.codes_of(block)) take(code);
    // The speed may stand in the block of G96 or behind it.
    const auto words = check_.program.words_of(block);
    if (std::ranges::find(words, Address::s, &ir::Word::address) != words.end() && constant_speed_) {
      surface_speed_ = {};
      had_speed_ = true;
    }
    if (!moves || surface_speed_.empty()) return;
    check_.report(DiagnosticId::surface_speed_missing, surface_speed_);
    surface_speed_ = {};
  }

  // $P_AD[n] is the data of the active edge.
  void offset_data(const ir::Statement& s) {
    if (off_.empty()) return;
    const auto data = std::ranges::find_if(check_.program.variables, [&](const ir::Variable& v) {
      return v.bank == ir::Bank::system && v.name != ir::StringId::none && s.span.begin <= v.span.begin &&
             v.span.end <= s.span.end && check_.program.strings.at(v.name) == "$P_AD";
    });
    if (data == check_.program.variables.end()) return;
    check_
        .report(DiagnosticId::comp_without_tool, data->span,
                {std::string(check_.text_of(data->span)), std::string(check_.text_of(off_))})
        .alarm = "17160";
  }

  void take(const ir::Code& code) {
    if (code.function == Function::surface_speed_on) {
      constant_speed_ = true;
      if (!had_speed_) surface_speed_ = code.span;
    }
    if (code.function == Function::surface_speed_off) {
      constant_speed_ = false;
      surface_speed_ = {};
    }
    if (code.function != Function::comp_left && code.function != Function::comp_right) return;
    if (!off_.empty())
      check_.report(DiagnosticId::comp_without_tool, code.span,
                    {std::string(check_.text_of(code.span)), std::string(check_.text_of(off_))});
  }

  const Check& check_;
  text::Span off_;            // T0 or D0 that is in effect
  text::Span surface_speed_;  // a G96 that waits for its S
  bool constant_speed_ = false;
  bool had_speed_ = false;  // the control remembers the last speed of G96
};

}  // namespace

void check_tools(const Check& check) { Tools(check).run(); }

}  // namespace dripfeed::sinumerik
